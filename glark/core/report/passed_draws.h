// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>

#include "glark/core/report/cause.h"

namespace glark::core {

// Counts the draws of a context that stay unrefined, and logs the first one of each cause.
class PassedDraws {
 public:
  void count(Cause cause);

 private:
  std::bitset<cause_count> logged_;
};

}  // namespace glark::core
