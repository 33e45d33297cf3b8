// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A regular file that is read at any place, and not mapped: pages of a mapping would count as memory of the process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace glark::stream {

// What tells whether a file has changed.
struct FileState {
  std::uint64_t size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;  // of the last modification
  friend bool operator==(const FileState&, const FileState&) = default;
};

class SourceFile {
 public:
  // Throws Error if the file cannot be opened or is not a regular file.
  explicit SourceFile(const std::filesystem::path& file);
  ~SourceFile();
  SourceFile(SourceFile&& other) noexcept;
  SourceFile& operator=(SourceFile&&) = delete;

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  FileState state() const;
  // Throws Error if the file's size or time differs from `before`.
  void require_unchanged(const FileState& before) const;

  // Reads all of `to`, from the byte `offset` on. Throws Error if the file ends before, or cannot be read.
  void read(std::uint64_t offset, std::span<char> to) const;
  // Tells the system to read this range ahead.
  void will_read(std::uint64_t offset, std::uint64_t size) const;
  int descriptor() const { return descriptor_; }

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace glark::stream
