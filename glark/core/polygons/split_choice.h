// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/capture/draw_call.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/programs/program.h"

namespace glark::polygons {

// Returns whether the polygons of a draw can be split at their centroids, in a compatibility context. No GL.
bool splits_at_centroid(const core::DrawCall& call, const core::Program& program, const core::Bindings& bindings);

}  // namespace glark::polygons
