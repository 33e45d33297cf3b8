// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The ways to draw the whole scene.
#pragma once

#include <vector>

#include "conformance/changes/scene.h"

namespace glark::conformance {

struct Path {
  const char* name;
  Apis apis;
  void (*draw)(const Scene& scene);
  bool has_indices = false;
  bool has_commands = false;     // in a buffer
  bool has_instances = true;     // each draw is one instance at least
  bool draws_instances = false;  // several of them
  bool copies_arrays = false;    // a display list: later changes of arrays do not show
  void (*prepare)(Test& t, Scene& scene) = nullptr;
};

const std::vector<Path>& paths();

}  // namespace glark::conformance
