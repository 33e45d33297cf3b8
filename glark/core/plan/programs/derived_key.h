// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Selects the derived program of an application's program that a draw needs. No GL.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

struct KeyState {
  const ContextOptions& options;
  const ArkState& ark;
  const Bindings& bindings;
  const Capabilities& capabilities;
};

struct KeyRequest {
  Refinement refinement = Refinement::linear_inputs;  // choose_refinement()
  GLenum mode = GL_TRIANGLES;
  bool tagged = false;    // records hold depth tags
  bool placed = false;    // pieces have a placement
  bool morphing = false;  // vertices move between levels
};
DerivedKey derived_key(const KeyState& state, const Program& program, const KeyRequest& request);
// The angle beyond which shared normals do not curve an edge, in degrees. A program that calls the API gets what its
// normals say.
float crease_of(const ContextOptions& options);
// Adds the words that welding writes to the records, if there is room. `turns`: normals are measured.
void add_welded_words(DerivedKey& key, bool turns);

}  // namespace glark::core
