// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::tool {

// Prints the driver of each kind of context that this machine has, and whether glark can refine with it. Each kind is
// tried in a child process, so that a crash of a driver costs one line. Returns 0 if refinement works with any of them,
// else 1.
int info();

}  // namespace glark::tool
