// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::conformance {

// Runs the whole program, with any cases; returns its exit status (runner/exit_status.h).
int run_program(int argc, char** argv);

}  // namespace glark::conformance
