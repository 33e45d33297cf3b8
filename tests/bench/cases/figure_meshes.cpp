// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/cases/figure_meshes.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/subject/model.h"

namespace glark::bench {
namespace {

// Makes a torus. Its inside bends more than its outside, and its near side appears larger.
Mesh make_torus(int rings, int sides) {
  Mesh mesh;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const float u = 6.2831853F * static_cast<float>(i) / static_cast<float>(rings);
      const float v = 6.2831853F * static_cast<float>(j) / static_cast<float>(sides);
      const float tilt = 0.9F;
      const float n[3] = {std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)};
      const float p[3] = {0.7F * std::cos(u) + 0.25F * n[0], 0.25F * n[1], 0.7F * std::sin(u) + 0.25F * n[2]};
      const auto turned = [&](const float* a) {
        return std::array{a[0], std::cos(tilt) * a[1] - std::sin(tilt) * a[2],
                          std::sin(tilt) * a[1] + std::cos(tilt) * a[2]};
      };
      const auto position = turned(p);
      const auto normal = turned(n);
      mesh.vertices.push_back({{position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}, {0, 0}});
      const auto at = [&](int a, int b) { return static_cast<std::uint32_t>(a % rings * sides + b % sides); };
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

// Makes hills. View::plane sees them from above their near end.
Mesh make_landscape() {
  Mesh mesh = make_plane(30, 18);
  const auto height = [](float x, float z) {
    return 0.6F * std::sin(0.9F * x) * std::cos(0.7F * z) + 0.3F * std::sin(0.4F * x + 1.1F * z);
  };
  for (Vertex& vertex : mesh.vertices) {
    constexpr float step = 0.01F;
    const float x = vertex.position[0];
    const float z = vertex.position[2];
    const float slope_x = (height(x + step, z) - height(x - step, z)) / (2 * step);
    const float slope_z = (height(x, z + step) - height(x, z - step)) / (2 * step);
    const float size = std::hypot(slope_x, 1.0F, slope_z);
    vertex = {{x, height(x, z), z}, {-slope_x / size, 1 / size, -slope_z / size}, {vertex.uv[0], vertex.uv[1]}};
  }
  return mesh;
}

}  // namespace

void for_each_figure_mesh(Report& report, const std::string& row,
                          const std::function<void(const std::string& name, const Mesh& mesh, View view)>& run) {
  run("sphere", make_sphere(500), View::sphere);
  run("landscape", make_landscape(), View::plane);
  run("torus", make_torus(24, 12), View::sphere);
  for (const std::string& name : model_names()) run(name, load_model(name, 1500), View::sphere);
  if (model_names().empty()) report.note(row + ": models from files are left out; --models DIR says where they are");
}

}  // namespace glark::bench
