// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The time limit of a case. On a loaded machine a process waits for a processor for longer than it computes, and that
// is no fault of the implementation. So a case is over its limit when both the clock and its own processor time say so,
// or when it has hardly computed at all, as in a deadlock.
#pragma once

#include <optional>
#include <string>

namespace glark::conformance {

// What a process has used so far, in seconds.
struct TimeUsed {
  double clock = 0;      // since any fixed time
  double processor = 0;  // of all threads of the process
};

class TimeLimit {
 public:
  explicit TimeLimit(int seconds) : seconds_(seconds) {}

  // A case begins, after its process has used `now`.
  void begin(const TimeUsed& now) { began_ = mark_ = now; }
  // Returns why the case must end, or nothing while it may go on. Call it at least once in each limit's time.
  std::optional<std::string> exceeded(const TimeUsed& now);

 private:
  int seconds_;
  TimeUsed began_;
  TimeUsed mark_;  // since when the process has to compute something
};

}  // namespace glark::conformance
