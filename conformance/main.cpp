// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-conformance: judges the implementation of GL_ARK_adaptive_refinement that the loader finds. README.md says how.
#include "conformance/runner/program.h"

int main(int argc, char** argv) { return glark::conformance::run_program(argc, argv); }
