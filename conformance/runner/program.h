// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::conformance {

// The whole program, whatever its cases; returns its exit status (runner/exit_status.h).
int run_program(int argc, char** argv);

}  // namespace glark::conformance
