// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the triangles of a draw to the screen. An implementation may refine differently with transform feedback.
#pragma once

#include <functional>

#include "conformance/gl/gl.h"

namespace glark::conformance {

// The result of PRIMITIVES_GENERATED.
GLuint count_generated(const std::function<void()>& draw);

}  // namespace glark::conformance
