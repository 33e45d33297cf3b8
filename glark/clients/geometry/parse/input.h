// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The bytes of a file in order, read in blocks. A file compressed by zstd is recognised by its first bytes.
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
  // Fills the span with the next bytes and returns their number. Only at the end is the number smaller than the span.
  using Fill = std::function<std::size_t(std::span<char>)>;

  // size: the total number of bytes, if it is known in advance.
  Input(std::string name, Fill fill, std::optional<std::uint64_t> size);

  const std::string& name() const { return name_; }
  // The number of remaining bytes, if it is known.
  std::optional<std::uint64_t> remaining() const;

  // Returns the next `count` bytes, or fewer at the end of the file. The bytes are valid until the next call.
  std::span<const char> take(std::size_t count);
  // Reads a line without its end. Returns false at the end of the file. Throws Error if the line is too long for text.
  bool line(std::string_view& text);
  // Returns the next word between white space, or an empty word at the end of the file.
  std::string_view word();
  // Sets a function that receives the number of bytes read so far.
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

// Throws Error if the file cannot be opened, is empty or is a folder.
Input open_input(const std::filesystem::path& file);

// The caller owns the bytes.
Input memory_input(std::string name, std::span<const char> bytes);

}  // namespace glark::geometry
