// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "conformance/runner/time_limit.h"

namespace glark::conformance {

using Clock = std::chrono::steady_clock;

// Another process of this program, with other arguments. It writes its report to descriptor 3 and has no standard
// input.
class Process {
 public:
  // `preload`, if not empty, is put before LD_PRELOAD. Throws std::runtime_error.
  Process(const std::vector<std::string>& arguments, const std::string& preload);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  int report_descriptor() const { return report_; }
  int output_descriptor() const { return output_; }
  // Reads new output. Returns false at the end of the report.
  bool read_report(std::string& text);
  bool read_output(std::string& text);
  void kill();
  // Waits for the end of the process; returns the status of waitpid.
  int wait();
  // What the process has used since its start. Its child processes do not count.
  TimeUsed used() const;

 private:
  pid_t pid_ = -1;
  int report_ = -1;
  int output_ = -1;
  Clock::time_point started_ = Clock::now();
};

}  // namespace glark::conformance
