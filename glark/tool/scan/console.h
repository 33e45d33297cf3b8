// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The output of the commands for files: progress on a terminal, warnings, reports.
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

namespace glark::tool {

using Report = nlohmann::ordered_json;

// A progress line on standard error. It disappears when the step is done. It is only shown if standard error is a
// terminal.
class Progress {
 public:
  explicit Progress(std::string step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // The fraction is 0 to 1; a negative value means that it is unknown.
  void show(double fraction);
  double seconds() const;

 private:
  std::string step_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point shown_;
};

void warn(const std::string& text);

// Prints to standard output, as JSON or as one line for each value. The values of an object are indented below its
// name.
void print(const Report& report, bool json);

}  // namespace glark::tool
