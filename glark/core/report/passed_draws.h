// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <string>

#include "glark/core/report/cause.h"

namespace glark::core {

// Counts the draws of a context that stay unrefined, and tells of the first one of each cause.
class PassedDraws {
 public:
  // Logs the first draw of a cause. Returns a message for the application's debug output, if that is `audible` and the
  // message is new; else an empty text.
  std::string count(Cause cause, bool audible);

 private:
  std::bitset<cause_count> logged_;
  std::bitset<cause_count> sent_;
};

}  // namespace glark::core
