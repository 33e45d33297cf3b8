// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads points back from the application's buffers.
#pragma once

#include <vector>

#include "glark/core/meshes/overlays.h"
#include "glark/core/objects/error_scope.h"
#include "glark/core/state/arrays/vertex_arrays.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

// Whether the array has points of floats in a buffer.
bool has_points(const AttributeSource& source);
// The first points of the buffer that the array reads. Waits for the GPU. Empty if GL does not give them (OpenGL ES, a
// buffer that is mapped). The array must have points.
std::vector<Point> read_points(const gl::Dispatch& gl, PendingError& errors, const AttributeSource& source);

}  // namespace glark::core
