// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/expand.h"

#include <stdexcept>
#include <string>

#define GLARK_SINK_PARAMETER std::vector<Instance>&instances,
#define GLARK_SINK_ARGUMENT instances,
#define GLARK_EMIT(piece, ou, ov, s, r) instances.push_back(Instance{piece, ou, ov, s, r})

#include "glark/core/pattern/expand.glsl.h"

namespace glark::pattern {

std::vector<Instance> expand(int e0, int e1, int e2, Interior interior) {
  for (int depth : {e0, e1, e2}) {
    if (depth < 0 || depth > deepest_level) {
      throw std::invalid_argument("glark: edge depth " + std::to_string(depth) + " is not in 0.." +
                                  std::to_string(deepest_level) + "; clamp the depth tags");
    }
  }
  std::vector<Instance> instances;
  expand_pattern(instances, e0, e1, e2, static_cast<int>(interior));
  return instances;
}

}  // namespace glark::pattern
