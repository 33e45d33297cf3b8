// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A file that appears complete or not at all: written aside, then renamed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace glark::geometry {

class OutputFile {
 public:
  // Throws Error where the folder cannot be written. What is not a plain file (a pipe, a device) is written as it is.
  explicit OutputFile(const std::filesystem::path& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  template <class Value>
  void write_values(std::span<const Value> values) {
    write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  // The file is there once this has returned.
  void commit();

 private:
  void flush();
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path file_;
  std::filesystem::path aside_;  // empty where the aside file has no name
  int descriptor_ = -1;
  bool direct_ = false;
  std::string buffer_;
};

}  // namespace glark::geometry
