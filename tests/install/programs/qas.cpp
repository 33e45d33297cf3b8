// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/qas.h>

#include <array>

int main() {
  const std::array<float, 12> positions = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
  const std::array<std::uint32_t, 12> triangles = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  glark::qas::Surface surface({.vertex_count = 4, .triangles = triangles});
  surface.update(positions);
  return surface.patches().empty() ? 1 : 0;
}
