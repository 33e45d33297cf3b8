// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the bindings of an assembly program are in GLSL: vertex.color, state.matrix.mvp.row[2], result.texcoord[1].
// Based on: ARB_vertex_program, tables X.1 (results), X.2 (attributes) and X.3 (state).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glark/core/refine/assembly/program.h"

namespace glark::refine::assembly {

// One part of a path such as "row[0..3]".
struct PathPart {
  std::string name;
  bool indexed = false;
  int first = 0;
  int last = 0;  // equals `first` unless a range is given
};
using Path = std::span<const PathPart>;

struct Output {
  std::string name;     // the GLSL variable
  bool scalar = false;  // it is a float
};

// Empty: there is no such binding.
std::optional<Vector> vertex_attribute(Path path);  // "vertex...."
std::vector<Vector> parameters(Path path);          // "state....", "program....": one vector for each row
std::optional<Output> result(Path path);            // "result...."

}  // namespace glark::refine::assembly
