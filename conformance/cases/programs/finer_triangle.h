// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A triangle with all attributes of the fixed-function vertex stage, drawn as a mesh of finer triangles.
#pragma once

#include <array>

#include "conformance/support/capture.h"

namespace glark::conformance {

struct FixedFunctionCorner {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  std::array<float, 3> colour;
  std::array<float, 3> secondary;
  std::array<float, 2> texture;
  float fog;
};

inline constexpr FixedFunctionCorner corners_of_triangle[3] = {
    {{-0.8F, -0.7F, 0.2F}, {-0.6F, -0.4F, 0.8F}, {1, 0.2F, 0}, {0, 0.3F, 0.1F}, {0, 0.1F}, 0.2F},
    {{0.8F, -0.6F, -0.3F}, {0.7F, -0.1F, 0.9F}, {0.1F, 1, 0.3F}, {0.4F, 0, 0}, {1, 0}, 0.7F},
    {{-0.1F, 0.8F, 0.4F}, {0.1F, 0.9F, 0.5F}, {0.2F, 0, 1}, {0, 0, 0.5F}, {0.3F, 1}, 1.3F}};

template <std::size_t n>
std::array<float, n> mixed(const std::array<float, 3>& w, const std::array<float, n>& a, const std::array<float, n>& b,
                           const std::array<float, n>& c) {
  std::array<float, n> result{};
  for (std::size_t i = 0; i < n; ++i) result[i] = (w[0] * a[i] + w[1] * b[i]) + w[2] * c[i];
  return result;
}

inline void fixed_function_vertex(const std::array<float, 3>& w) {
  const auto colour =
      mixed(w, corners_of_triangle[0].colour, corners_of_triangle[1].colour, corners_of_triangle[2].colour);
  const auto secondary =
      mixed(w, corners_of_triangle[0].secondary, corners_of_triangle[1].secondary, corners_of_triangle[2].secondary);
  const auto normal =
      mixed(w, corners_of_triangle[0].normal, corners_of_triangle[1].normal, corners_of_triangle[2].normal);
  const auto texture_at =
      mixed(w, corners_of_triangle[0].texture, corners_of_triangle[1].texture, corners_of_triangle[2].texture);
  const auto position =
      mixed(w, corners_of_triangle[0].position, corners_of_triangle[1].position, corners_of_triangle[2].position);
  gl.Color3f(colour[0], colour[1], colour[2]);
  gl.SecondaryColor3f(secondary[0], secondary[1], secondary[2]);
  gl.Normal3f(normal[0], normal[1], normal[2]);
  gl.TexCoord2f(texture_at[0], texture_at[1]);
  gl.MultiTexCoord2f(GL_TEXTURE1, texture_at[1], 1 - texture_at[0]);
  gl.FogCoordf((w[0] * corners_of_triangle[0].fog + w[1] * corners_of_triangle[1].fog) +
               w[2] * corners_of_triangle[2].fog);
  gl.Vertex3f(position[0], position[1], position[2]);
}

// Draws 4^level triangles in place of the coarse one.
inline Picture finer_picture(int level) {
  clear_surface();
  const int n = 1 << level;
  const auto at = [n](int i, int j) {
    const auto u = static_cast<float>(i) / static_cast<float>(n);
    const auto v = static_cast<float>(j) / static_cast<float>(n);
    fixed_function_vertex({1 - u - v, u, v});
  };
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      at(i, j);
      at(i + 1, j);
      at(i, j + 1);
      if (i + j + 1 >= n) continue;
      at(i + 1, j);
      at(i + 1, j + 1);
      at(i, j + 1);
    }
  gl.End();
  return read_picture(surface_size, surface_size);
}

}  // namespace glark::conformance
