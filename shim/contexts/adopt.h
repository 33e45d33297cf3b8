// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::shim {

// Looks for a context that became current without a call that we saw. Returns whether the thread now has a context of
// ours.
bool adopt_current_context();

}  // namespace glark::shim
