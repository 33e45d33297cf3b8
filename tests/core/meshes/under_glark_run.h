// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace glark::core::test {

// The program runs as under `glark run --refine smooth --level 3 --wait`. The library reads the variables when the first
// context is made.
inline const bool as_under_glark_run = [] {
  return setenv("GLARK_CONFIG", "/dev/null", 1) == 0 && setenv("GLARK_ENABLE", "1", 1) == 0 &&
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0 &&
         setenv("GLARK_WAIT", "1", 1) == 0;
}();

}  // namespace glark::core::test
