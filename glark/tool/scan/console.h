// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the commands for files say: progress to a terminal, warnings, reports.
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

namespace glark::tool {

using Report = nlohmann::ordered_json;

// A line on standard error that counts, gone when the step is done. Silent unless standard error is a terminal.
class Progress {
 public:
  explicit Progress(std::string step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // 0 to 1; less than 0 where it cannot be known.
  void show(double fraction);
  double seconds() const;

 private:
  std::string step_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point shown_;
};

void warn(const std::string& text);

// On standard output: as JSON, or a line for each value, those of an object indented below its name.
void print(const Report& report, bool json);

}  // namespace glark::tool
