// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A file for intermediate results. It has a name if a later run is to go on from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "glark/clients/common/nameless_file.h"

namespace glark::stream {

// A file with a name, which stays.
struct KeptFile {
  std::filesystem::path path;
};

class TemporaryFile {
 public:
  // Throws Error if the folder cannot be written.
  explicit TemporaryFile(const std::filesystem::path& folder);
  // Keeps what the file has.
  explicit TemporaryFile(const KeptFile& file);
  // The next append() begins at `size`. Throws Error if the file is shorter.
  void continue_at(std::uint64_t size);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  // Adds bytes at the end, and returns where they begin. Several threads may call it. Throws Error, for a full disk too.
  std::uint64_t append(std::span<const char> bytes);
  void write(std::uint64_t offset, std::span<const char> bytes);
  void read(std::uint64_t offset, std::span<char> bytes) const;
  // Waits until the disk has all bytes. Throws Error if it cannot have them.
  void flush();
  std::uint64_t size() const { return end_; }

 private:
  std::string folder_;
  std::optional<common::NamelessFile> nameless_;  // or a file with a name
  int descriptor_ = -1;
  std::mutex mutex_;
  std::uint64_t end_ = 0;
};

}  // namespace glark::stream
