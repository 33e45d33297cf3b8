// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::depth::testing {

// How often `new` was called since the program began.
int allocations();

}  // namespace glark::depth::testing
