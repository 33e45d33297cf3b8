// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The operations of a session, as lines of text in a file. Each line begins with a checksum of itself and of all lines
// before it, so that a line that was not written to its end is found, and so is a line that was changed or left out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glark::edit {

class Log {
 public:
  // Reads the lines of a file, or makes it. A last line that is not complete is cut off. Throws Error, which names the
  // file and the line, if another line is damaged.
  explicit Log(const std::filesystem::path& file);
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  const std::vector<std::string>& lines() const { return lines_; }
  bool has_dropped_line() const { return has_dropped_line_; }
  // The number of a line in the file, for messages.
  static std::size_t line_number(std::size_t line) { return line + 2; }

  // Returns when the line is on the disk. Throws Error if it cannot be written; the file has it not, then.
  void append(const std::string& line);

 private:
  void begin();
  void read(std::string_view contents);
  void write(std::string_view bytes);
  void cut();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;      // of the complete lines
  std::uint64_t checksum_ = 0;  // of the last line
  std::vector<std::string> lines_;
  bool has_dropped_line_ = false;
};

}  // namespace glark::edit
