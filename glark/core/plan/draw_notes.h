// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a draw asks for and does not get although it is refined. The user and the application are told once for each
// program. No GL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glark/core/objects/application_message.h"
#include "glark/core/refinement.h"
#include "glark/core/report/refinement_fallback.h"

namespace glark::core {

struct DrawNoteFacts {
  Refinement refinement = Refinement::linear_inputs;  // the chosen one
  std::optional<RefinementFallback> fallback = std::nullopt;
  bool transparent = false;
  bool fixed_function = false;
  bool left = false;            // the draw stays unrefined for this reason
  std::string construct = {};   // of the vertex stage, that is the reason
  bool ignores_shader = false;  // the refinement shader does not run
  bool undisplaced = false;     // GL_DISPLACEMENT_ARK has no effect
};

struct DrawNote {
  MessageId id = MessageId::other_refinement;
  std::string text;  // completes "program 3 ..."
};

// Bits that name the notes.
unsigned note_bits(const DrawNoteFacts& facts);
// Returns the notes of these bits.
std::vector<DrawNote> draw_notes(const DrawNoteFacts& facts, unsigned bits);

}  // namespace glark::core
