// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/vertex_map.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace glark::tool {

VertexMap::VertexMap(const std::filesystem::path& folder, std::size_t cache_bytes)
    : folder_(folder.empty() ? "." : folder),
      blocks_(std::max<std::size_t>(1, cache_bytes / (block_size * sizeof(std::uint32_t))), no_block),
      numbers_(blocks_.size() * block_size) {
  std::string name = (folder_ / ".glark-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot be made");
  unlink(name.c_str());
}

VertexMap::~VertexMap() {
  if (descriptor_ >= 0) close(descriptor_);
}

void VertexMap::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: a temporary file {}: {}; make room there, or name an output elsewhere",
                                       folder_.string(), what, std::strerror(errno)));
}

void VertexMap::append(std::span<const std::uint32_t> numbers) {
  const auto* bytes = reinterpret_cast<const char*>(numbers.data());
  for (std::size_t done = 0; done < numbers.size_bytes();) {
    const auto at = static_cast<off_t>(size_ * sizeof(std::uint32_t) + done);
    const ssize_t count = pwrite(descriptor_, bytes + done, numbers.size_bytes() - done, at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot be written");
    done += static_cast<std::size_t>(count);
  }
  if (const std::uint64_t last = size_ / block_size; blocks_[last % blocks_.size()] == last)
    blocks_[last % blocks_.size()] = no_block;  // it has grown
  size_ += numbers.size();
}

void VertexMap::load(std::uint64_t block, std::size_t slot) {
  const std::uint64_t count = std::min(block_size, size_ - block * block_size);
  auto* bytes = reinterpret_cast<char*>(&numbers_[slot * block_size]);
  const std::size_t wanted = static_cast<std::size_t>(count) * sizeof(std::uint32_t);
  for (std::size_t done = 0; done < wanted;) {
    const auto at = static_cast<off_t>(block * block_size * sizeof(std::uint32_t) + done);
    const ssize_t got = pread(descriptor_, bytes + done, wanted - done, at);
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;
    if (got <= 0) fail("cannot be read");
    done += static_cast<std::size_t>(got);
  }
  blocks_[slot] = block;
}

std::uint32_t VertexMap::at(std::uint64_t vertex) {
  const std::uint64_t block = vertex / block_size;
  const auto slot = static_cast<std::size_t>(block % blocks_.size());
  if (blocks_[slot] != block) load(block, slot);
  return numbers_[slot * block_size + static_cast<std::size_t>(vertex % block_size)];
}

}  // namespace glark::tool
