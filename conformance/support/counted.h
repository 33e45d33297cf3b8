// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How many triangles a draw has that goes to the screen: with transform feedback an implementation may refine in another way.
#pragma once

#include <functional>

#include "conformance/gl/gl.h"

namespace glark::conformance {

// What PRIMITIVES_GENERATED counts.
GLuint count_generated(const std::function<void()>& draw);

}  // namespace glark::conformance
