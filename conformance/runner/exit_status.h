// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

// The exit status of the program; docs/reference/conformance.md documents it.
namespace glark::conformance::exit_status {

inline constexpr int passed = 0;
inline constexpr int failed = 1;         // a verdict that is bad, or an archive that does not verify
inline constexpr int usage = 2;          // options or files that make no sense
inline constexpr int no_case = 3;        // nothing matches what was asked for
inline constexpr int no_report = 4;      // the report cannot be written
inline constexpr int no_context = 5;     // the platform gives no context
inline constexpr int not_supported = 6;  // the implementation has no GL_ARK_adaptive_refinement

}  // namespace glark::conformance::exit_status
