// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that GL refuses, each for one reason, as a table.
#pragma once

#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

// Four triangles whose tags are 1, their program in use, and buffers of indices and of commands, bound.
struct RefusedScene {
  GLuint array = 0;
  GLuint vertices = 0;
  GLuint elements = 0;
  GLuint commands = 0;
  GLuint program = 0;
  GLuint framebuffer = 0;  // that of the surface
};
RefusedScene make_refused_scene(Test& t);

struct Refusal {
  std::string leaf;
  GLenum error;
  void (*draw)(const RefusedScene& scene);
  void (*enter)(Test& t, const RefusedScene& scene) = [](Test&, const RefusedScene&) {};  // makes GL refuse
  void (*leave)(const RefusedScene& scene) = [](const RefusedScene&) {};                  // undoes it
  Apis apis = every_api;
  bool allows_feedback = true;  // enter() may be called while transform feedback is active
  bool allows_queries = true;
  bool is_plain = true;  // a draw of GL
};
const std::vector<Refusal>& refusals();

}  // namespace glark::conformance
