// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals follow the positions around them.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

// Returns the normals of some samples after the edit. Each one turns by the linear map that fits the motion of its
// neighbours best, from before the edit to now. So normals do not drift over many strokes.
std::vector<Vector3f> turned_normals(const Shape& shape, std::span<const std::uint32_t> samples,
                                     const common::Workers& workers);

}  // namespace glark::edit
