// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "glark/clients/common/resume/work_folder.h"

namespace glark::common {

// Tells when to save the state of a pass: after each twentieth of the points, but not for fewer than a million.
class Checkpoints {
 public:
  static constexpr std::uint64_t least_step = 1 << 20;  // points

  Checkpoints(WorkFolder& folder, std::uint64_t points, std::uint64_t least = least_step)
      : folder_(folder), step_(std::max(least, points / 20)), next_(step_) {}

  WorkFolder& folder() { return folder_; }
  // done: the points of this pass, at its beginning.
  void begin(std::uint64_t done) { next_ = done + step_; }
  bool is_due(std::uint64_t done) {
    if (!folder_.is_used() || done < next_) return false;
    next_ = done + step_;
    return true;
  }

 private:
  WorkFolder& folder_;
  std::uint64_t step_, next_;
};

}  // namespace glark::common
