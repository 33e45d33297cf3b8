// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Writes a file atomically: it is written under another name, then renamed. It keeps the mode of a file that it
// replaces, and the owner and group where the system permits it. Other hard links keep the old contents.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace glark::geometry {

class OutputFile {
 public:
  // Throws Error if the folder is not writable. Pipes and devices are written directly.
  explicit OutputFile(const std::filesystem::path& file);
  // The same, but the bytes go to the file `partial` until commit(). It is on the same file system, keeps its first
  // `kept` bytes, and stays if commit() is not called. Throws Error if it has less.
  OutputFile(const std::filesystem::path& file, const std::filesystem::path& partial, std::uint64_t kept);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  // Gives all bytes to the system.
  void flush();
  template <class Value>
  void write_values(std::span<const Value> values) {
    write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  // Replaces bytes that were written before. Not for pipes and devices.
  void overwrite(std::uint64_t offset, std::string_view bytes);
  // Whether the bytes go straight to a pipe or a device, where they cannot be replaced.
  bool is_direct() const { return direct_; }
  // Does all of commit() that is likely to fail.
  void prepare();
  // Puts the finished file in place.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path file_;
  std::filesystem::path aside_;  // empty if the temporary file has no name
  int descriptor_ = -1;
  bool direct_ = false;
  bool stays_ = false;  // the temporary file is not removed
  std::string buffer_;
};

}  // namespace glark::geometry
