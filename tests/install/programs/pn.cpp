// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/pn.h>

#include <array>

int main() {
  const std::array<float, 9> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::array<std::uint32_t, 3> triangles = {0, 1, 2};
  return glark::pn::derive_tags({.positions = positions, .triangles = triangles}).triangles.empty() ? 1 : 0;
}
