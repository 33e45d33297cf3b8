// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace glark::conformance {

// An implementation may keep what a draw has computed, once the draw has repeated often without a change. So many
// repetitions are often.
inline void repeat_often(const std::function<void()>& draw) {
  for (int again = 0; again < 24; ++again) draw();
}

}  // namespace glark::conformance
