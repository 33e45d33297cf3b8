// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes a program of random steps that fails as short as possible.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace glark::conformance {

// Leaves out steps as long as the program still fails; runs it at most `most_runs` times (delta debugging: Zeller and
// Hildebrandt 2002, Simplifying and isolating failure-inducing input). `Program` has a vector `steps`.
template <typename Program>
Program shortest(const Program& program, const std::function<bool(const Program&)>& fails, int most_runs) {
  Program best = program;
  std::size_t part = std::max<std::size_t>(1, best.steps.size() / 2);
  for (int runs = 0; runs < most_runs;) {
    bool is_shorter = false;
    for (std::size_t first = 0; first < best.steps.size() && runs < most_runs; ++runs) {
      Program tried = best;
      const auto begin = tried.steps.begin() + static_cast<std::ptrdiff_t>(first);
      tried.steps.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(part, tried.steps.size() - first)));
      if (!tried.steps.empty() && fails(tried)) {
        best = tried;
        is_shorter = true;
      } else {
        first += part;
      }
    }
    if (part == 1 && !is_shorter) break;
    part = std::max<std::size_t>(1, part / 2);
  }
  return best;
}

}  // namespace glark::conformance
