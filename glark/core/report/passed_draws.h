// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <string>

#include "glark/core/report/cause.h"

namespace glark::core {

// Counts the draws of a context that stay unrefined, and logs the first one of each cause.
class PassedDraws {
 public:
  // Returns the message if it is the first draw of a cause that the user may want to know; else an empty text.
  std::string count(Cause cause);

 private:
  std::bitset<cause_count> logged_;
};

}  // namespace glark::core
