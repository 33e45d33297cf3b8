// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::test {

// The number of calls of `new` since the program began.
int allocations();

}  // namespace glark::test
