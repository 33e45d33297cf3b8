// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::tool {

// Prints, for each way to a context that this machine has, what the driver is and whether glark can refine with it. Each is
// tried in a process of its own: a driver that crashes costs one line. Returns 0 if refinement works somewhere, else 1.
int info();

}  // namespace glark::tool
