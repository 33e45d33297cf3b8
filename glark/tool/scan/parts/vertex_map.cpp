// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/vertex_map.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace glark::tool {

VertexMap::VertexMap(const std::filesystem::path& folder, std::size_t cache_bytes)
    : folder_(folder.empty() ? "." : folder),
      nameless_(std::in_place, folder),
      descriptor_(nameless_->descriptor()),
      blocks_(std::max<std::size_t>(1, cache_bytes / (block_size * sizeof(std::uint32_t))), no_block),
      numbers_(blocks_.size() * block_size) {
  if (descriptor_ < 0) fail("cannot be made");
}

VertexMap::VertexMap(const SharedNumbers& shared, std::size_t cache_bytes)
    : folder_(shared.file.parent_path()),
      descriptor_(open(shared.file.c_str(), O_RDONLY | O_CLOEXEC)),
      size_(shared.vertices),
      blocks_(std::max<std::size_t>(1, cache_bytes / (block_size * sizeof(std::uint32_t))), no_block),
      numbers_(blocks_.size() * block_size) {
  if (descriptor_ < 0) fail("cannot be opened");
}

VertexMap::~VertexMap() {
  if (!nameless_ && descriptor_ >= 0) close(descriptor_);
}

void VertexMap::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: a temporary file {}: {}; make room there, or name an output elsewhere",
                                       folder_.string(), what, std::strerror(errno)));
}

void VertexMap::append(std::span<const std::uint32_t> numbers) {
  const std::span bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
  if (!common::write_at(descriptor_, size_ * sizeof(std::uint32_t), bytes)) fail("cannot be written");
  if (const std::uint64_t last = size_ / block_size; blocks_[last % blocks_.size()] == last)
    blocks_[last % blocks_.size()] = no_block;  // it has grown
  size_ += numbers.size();
}

void VertexMap::load(std::uint64_t block, std::size_t slot) {
  const std::uint64_t count = std::min(block_size, size_ - block * block_size);
  const std::span bytes(reinterpret_cast<char*>(&numbers_[slot * block_size]),
                        static_cast<std::size_t>(count) * sizeof(std::uint32_t));
  if (!common::read_at(descriptor_, block * block_size * sizeof(std::uint32_t), bytes)) fail("cannot be read");
  blocks_[slot] = block;
}

std::uint32_t VertexMap::at(std::uint64_t vertex) {
  const std::uint64_t block = vertex / block_size;
  const auto slot = static_cast<std::size_t>(block % blocks_.size());
  if (blocks_[slot] != block) load(block, slot);
  return numbers_[slot * block_size + static_cast<std::size_t>(vertex % block_size)];
}

}  // namespace glark::tool
