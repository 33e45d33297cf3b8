// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Fields of the coarse record besides the inputs of the vertex stage: scalar tags, and the inputs of displacement.
#pragma once

#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/refine/derive.h"
#include "glark/core/state/programs/program.h"

namespace glark::refine {

// Adds the fields that `key` asks for, unless the vertex stage reads them anyway. Writes their indices to `request`.
void add_shape_fields(std::vector<capture::Field>& fields, const core::DerivedKey& key, bool fixed_function,
                      DeriveRequest& request);

core::SurfaceWords surface_words(const capture::Layout& layout, const core::ShapeFields& fields);

}  // namespace glark::refine
