// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The states that lists compile, as a table, and the draw that reads them.
#pragma once

#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

struct CompiledState {
  const char* leaf;  // of the case's name
  void (*change)();
  void (*prepare)() = [] {};  // before the first draw
  bool shows = true;          // in the unrefined picture
  bool executes = true;       // with COMPILE_AND_EXECUTE
};

const std::vector<CompiledState>& compiled_states();

// Lights, textures and arrays of two triangles: one shows its front, the other its back. All other values of the vertices
// are current ones.
void set_up_state_triangles(Test& t);
void draw_state_triangles();

}  // namespace glark::conformance
