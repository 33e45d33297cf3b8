// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A number for each vertex of a mesh that is larger than the memory. The numbers lie in a file, which has no name unless
// several processes share it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "glark/clients/common/nameless_file.h"

namespace glark::tool {

struct SharedNumbers {
  std::filesystem::path file;
  std::uint64_t vertices = 0;
};

class VertexMap {
 public:
  // cache_bytes: of the numbers that at() keeps in memory. Throws std::runtime_error if the folder cannot be written.
  VertexMap(const std::filesystem::path& folder, std::size_t cache_bytes);
  // Reads the numbers that others have written to a file, `vertices` of them. Throws std::runtime_error if it cannot be
  // opened.
  VertexMap(const SharedNumbers& shared, std::size_t cache_bytes);
  ~VertexMap();
  VertexMap(const VertexMap&) = delete;
  VertexMap& operator=(const VertexMap&) = delete;

  std::uint64_t size() const { return size_; }
  // Adds the numbers of the next vertices. Throws std::runtime_error, for a full disk too.
  void append(std::span<const std::uint32_t> numbers);
  std::uint32_t at(std::uint64_t vertex);

 private:
  static constexpr std::uint64_t block_size = 1024;  // numbers
  static constexpr std::uint64_t no_block = ~std::uint64_t{0};

  [[noreturn]] void fail(const char* what) const;
  void load(std::uint64_t block, std::size_t slot);

  std::filesystem::path folder_;
  std::optional<common::NamelessFile> nameless_;  // or a file with a name
  int descriptor_;
  std::uint64_t size_ = 0;
  std::vector<std::uint64_t> blocks_;  // which one each slot has
  std::vector<std::uint32_t> numbers_;
};

}  // namespace glark::tool
