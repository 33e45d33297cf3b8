// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/draw_notes.h"

#include <fmt/format.h>

namespace glark::core {
namespace {

constexpr unsigned ignored_shader_bit = 1U << refinement_fallback_count;
constexpr unsigned undisplaced_bit = ignored_shader_bit << 1U;

unsigned bit_of(RefinementFallback fallback) { return 1U << static_cast<unsigned>(fallback); }

}  // namespace

unsigned note_bits(const DrawNoteFacts& facts) {
  return (facts.fallback ? bit_of(*facts.fallback) : 0) | (facts.ignores_shader ? ignored_shader_bit : 0) |
         (facts.undisplaced ? undisplaced_bit : 0);
}

std::vector<DrawNote> draw_notes(const DrawNoteFacts& facts, unsigned bits) {
  std::vector<DrawNote> notes;
  if (facts.fallback && (bits & bit_of(*facts.fallback)) != 0) {
    const FallbackText& text = text_of(*facts.fallback);
    // The options of `glark run` do not apply to a program that calls the extension.
    const bool names = *facts.fallback == RefinementFallback::no_normal && !facts.transparent;
    const char* const remedy = facts.fixed_function
                                   ? "fixed function reads normals for lighting and for generated coordinates only"
                                   : "name the attributes as man glark (VERTEX ATTRIBUTES) says";
    const std::string verdict =
        facts.left ? std::string("stays as it is") : fmt::format("is refined by {}", traits_of(facts.refinement).word);
    notes.push_back(
        {MessageId::other_refinement, fmt::format("{}: {}{}; {}", verdict, text.explanation,
                                                  facts.construct.empty() ? "" : fmt::format(" ({})", facts.construct),
                                                  names ? remedy : text.remedy)});
  }
  if ((bits & ignored_shader_bit) != 0) {
    notes.push_back(
        {MessageId::ignored_shader,
         "ignores its refinement shader: the vertex stage reads gl_VertexID, gl_BaseVertex or gl_DrawID, or writes "
         "gl_CullDistance, so it runs on the corners only; give it a vertex attribute, or gl_ClipDistance, instead"});
  }
  if ((bits & undisplaced_bit) != 0) {
    notes.push_back(
        {MessageId::not_displaced,
         "is not displaced: its vertex stage has no attribute that is known as the position, the normal or the "
         "texture coordinate; set GL_DISPLACEMENT_COORDINATE_ARK, or name the attributes as man glark says"});
  }
  return notes;
}

}  // namespace glark::core
