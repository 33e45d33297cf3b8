// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The reasons why a draw gets another refinement than the wanted one.
#pragma once

#include <string_view>

namespace glark::core {

enum class RefinementFallback {
  vertex_id,       // the program uses the extension and reads a number that has no value between vertices
  cull_distance,   // culling needs all corners of the coarse triangle
  unsound_stage,   // the position jumps between vertices, or has no meaning there
  bent_unknowing,  // the position is not affine in the attributes, and no normal is known
  no_normal,       // a curved refinement, but no position or no normal is known
  flat_shading,    // shows_facets()
};
inline constexpr unsigned refinement_fallback_count = static_cast<unsigned>(RefinementFallback::flat_shading) + 1;

// `key` names the reason in files; `remedy` completes the log line.
struct FallbackText {
  std::string_view key;
  std::string_view explanation;
  std::string_view remedy;
};
const FallbackText& text_of(RefinementFallback fallback);

}  // namespace glark::core
