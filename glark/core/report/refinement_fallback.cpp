// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/refinement_fallback.h"

#include <array>
#include <cstddef>

namespace glark::core {
namespace {

constexpr std::array<FallbackText, refinement_fallback_count> fallback_texts{{
    {"vertex_id", "the vertex stage reads gl_VertexID or another number that has no value between vertices",
     "give it a vertex attribute instead"},
    {"cull_distance", "the vertex stage writes gl_CullDistance, which culls whole triangles of the application",
     "use gl_ClipDistance"},
    {"unsound_stage", "its position has no meaning between vertices", "nothing to do: this keeps the picture"},
    {"bent_unknowing", "its position is not linear in the attributes, and no normal tells that it is a surface",
     "name the position and the normal with --position and --normal"},
    {"no_normal", "no attribute is known to be the position or the normal, so the triangles stay flat",
     "name them with --position and --normal"},
    {"flat_shading",
     "glShadeModel(GL_FLAT) or a flat output shows each triangle in one colour, so the normals may belong to "
     "triangles, not to a smooth surface",
     "--refine pn curves it"},
}};

}  // namespace

const FallbackText& text_of(RefinementFallback fallback) {
  return fallback_texts.at(static_cast<std::size_t>(fallback));
}

}  // namespace glark::core
