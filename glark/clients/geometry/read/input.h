// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The bytes of a file, in order: plain or compressed by zstd (told by its first bytes), read in blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glark::geometry {

class Input {
 public:
  // Fills the span as far as bytes are left; returns how many those were.
  using Fill = std::function<std::size_t(std::span<char>)>;

  // `size`: of all bytes, where it is known before they are read.
  Input(std::string name, Fill fill, std::optional<std::uint64_t> size);

  const std::string& name() const { return name_; }
  // Bytes that follow, where that is known.
  std::optional<std::uint64_t> remaining() const;

  // The next `count` bytes, fewer at the end of the file; good until the next call.
  std::span<const char> take(std::size_t count);
  // Without its end. False at the end of the file. Throws on a line that no text has.
  bool line(std::string_view& text);
  // The next word between white space; empty at the end of the file.
  std::string_view word();
  // Reports how far the reading is, in bytes of the file.
  void on_progress(std::function<void(std::uint64_t bytes)> report) { report_ = std::move(report); }

 private:
  std::size_t ensure(std::size_t count);

  std::string name_;
  Fill fill_;
  std::optional<std::uint64_t> size_;
  std::uint64_t taken_ = 0;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool at_end_ = false;
  std::function<void(std::uint64_t bytes)> report_;
};

// Throws Error where the file cannot be opened, is a folder or empty.
Input open_input(const std::filesystem::path& file);

// The bytes stay the caller's.
Input memory_input(std::string name, std::span<const char> bytes);

}  // namespace glark::geometry
