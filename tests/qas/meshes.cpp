// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/qas/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace glark::qas::test {
namespace {

using std::numbers::pi;

void add_vertex(ControlMesh& mesh, double x, double y, double z) {
  for (const double value : {x, y, z}) mesh.positions.push_back(static_cast<float>(value));
}

void add_triangle(ControlMesh& mesh, int a, int b, int c) {
  for (const int v : {a, b, c}) mesh.triangles.push_back(static_cast<std::uint32_t>(v));
}

void add_quad(ControlMesh& mesh, int a, int b, int c, int d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

}  // namespace

double ControlMesh::diagonal() const {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double least = positions[axis], most = least;
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      least = std::min<double>(least, positions[i]);
      most = std::max<double>(most, positions[i]);
    }
    square += (most - least) * (most - least);
  }
  return std::sqrt(square);
}

ControlMesh icosahedron() {
  ControlMesh mesh{"icosahedron", {}, {}};
  const double t = (1 + std::sqrt(5.0)) / 2;
  for (const double y : {-1.0, 1.0}) {
    for (const double z : {-t, t}) {
      add_vertex(mesh, 0, y, z);
      add_vertex(mesh, y, z, 0);
      add_vertex(mesh, z, 0, y);
    }
  }
  const auto at = [&](int v, int axis) {
    return double{mesh.positions[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(axis)]};
  };
  const auto near = [&](int a, int b) {
    return std::hypot(at(a, 0) - at(b, 0), at(a, 1) - at(b, 1), at(a, 2) - at(b, 2)) < 2.1;
  };
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
        const double volume = at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) +
                              at(a, 1) * (at(b, 2) * at(c, 0) - at(b, 0) * at(c, 2)) +
                              at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
        volume > 0 ? add_triangle(mesh, a, b, c) : add_triangle(mesh, a, c, b);
      }
    }
  }
  return mesh;
}

ControlMesh cube() {
  ControlMesh mesh{"cube", {}, {}};
  for (int i = 0; i < 8; ++i) add_vertex(mesh, i & 1, i >> 1 & 1, i >> 2);
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

ControlMesh knot(int along, int around) {
  ControlMesh mesh{"knot", {}, {}};
  for (int i = 0; i < along; ++i) {
    const double t = 2 * pi * i / along;
    const std::array<double, 3> centre = {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                                          -std::sin(3 * t)};
    std::array<double, 3> tangent = {std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t),
                                     -3 * std::cos(3 * t)};
    const double length = std::hypot(tangent[0], tangent[1], tangent[2]);
    for (double& x : tangent) x /= length;
    const double flat = std::hypot(tangent[0], tangent[1]);
    const std::array<double, 3> side = {tangent[1] / flat, -tangent[0] / flat, 0};
    const std::array<double, 3> up = {side[1] * tangent[2], -side[0] * tangent[2],
                                      side[0] * tangent[1] - side[1] * tangent[0]};
    for (int j = 0; j < around; ++j) {
      const double s = 2 * pi * j / around, x = 0.6 * std::cos(s), y = 0.6 * std::sin(s);
      add_vertex(mesh, centre[0] + x * side[0] + y * up[0], centre[1] + x * side[1] + y * up[1],
                 centre[2] + x * side[2] + y * up[2]);
    }
  }
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const int i1 = (i + 1) % along, j1 = (j + 1) % around;
      add_quad(mesh, i * around + j, i1 * around + j, i1 * around + j1, i * around + j1);
    }
  }
  return mesh;
}

ControlMesh blocks() {
  ControlMesh mesh{"blocks", {}, {}};
  std::set<std::array<int, 3>> cubes = {{0, 0, 1}, {0, 0, 2}};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x != 1 || y != 1) cubes.insert({x, y, 0});
    }
  }
  std::map<std::array<int, 3>, int> vertices;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, is_new] = vertices.emplace(at, static_cast<int>(vertices.size()));
    if (is_new) add_vertex(mesh, at[0], at[1], at[2]);
    return found->second;
  };
  for (const auto& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = cube;
        beside[axis] += side == 1 ? 1 : -1;
        if (cubes.contains(beside)) continue;
        std::array<std::array<int, 3>, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
          corners[i] = cube;
          corners[i][axis] += side;
          corners[i][(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
          corners[i][(axis + 2) % 3] += i >= 2 ? 1 : 0;
        }
        if (side == 0) std::swap(corners[1], corners[3]);
        add_quad(mesh, vertex(corners[0]), vertex(corners[1]), vertex(corners[2]), vertex(corners[3]));
      }
    }
  }
  return mesh;
}

ControlMesh sheet(int cells) {
  ControlMesh mesh{"sheet", {}, {}};
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double x = double(j) / cells, y = double(i) / cells;
      add_vertex(mesh, x, y, 0.15 * std::sin(7 * x) * std::cos(5 * y));
    }
  }
  const int row = cells + 1;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const int a = i * row + j;
      if ((i + j) % 2 == 0) {
        add_quad(mesh, a, a + 1, a + row + 1, a + row);
      } else {
        add_quad(mesh, a + 1, a + row + 1, a + row, a);
      }
    }
  }
  return mesh;
}

ControlMesh bipyramid(int sides) {
  ControlMesh mesh{"bipyramid", {}, {}};
  for (int i = 0; i < sides; ++i) add_vertex(mesh, std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), 0);
  add_vertex(mesh, 0, 0, 1);
  add_vertex(mesh, 0, 0, -1);
  for (int i = 0; i < sides; ++i) {
    add_triangle(mesh, i, (i + 1) % sides, sides);
    add_triangle(mesh, (i + 1) % sides, i, sides + 1);
  }
  return mesh;
}

ControlMesh drum(int sides) {
  ControlMesh mesh{"drum", {}, {}};
  const int rings = std::max(3, sides - 4);
  const auto height = [&](int ring) { return 1.0 * ring / (rings - 1); };
  for (int ring = 0; ring < rings; ++ring) {
    const double radius = 1 - 0.3 * std::sin(pi * height(ring));
    for (int i = 0; i < sides; ++i)
      add_vertex(mesh, radius * std::cos(2 * pi * i / sides), radius * std::sin(2 * pi * i / sides), height(ring));
  }
  const int bottom = rings * sides, last = (rings - 1) * sides;
  add_vertex(mesh, 0, 0, -0.1);
  add_vertex(mesh, 0, 0, 1.2);
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    for (int ring = 0; ring + 1 < rings; ++ring)
      add_quad(mesh, ring * sides + i, ring * sides + next, (ring + 1) * sides + next, (ring + 1) * sides + i);
    add_triangle(mesh, next, i, bottom);
    add_triangle(mesh, last + i, last + next, bottom + 1);
    for (const int first : {0, last}) {
      for (const int v : {first + i, first + next}) mesh.creases.push_back(static_cast<std::uint32_t>(v));
    }
  }
  return mesh;
}

ControlMesh asteroid(int levels) {
  ControlMesh mesh = densified(icosahedron(), levels);
  mesh.name = "asteroid";
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    float* const p = &mesh.positions[3 * v];
    const double length = std::hypot(p[0], p[1], p[2]);
    const double x = p[0] / length, y = p[1] / length, z = p[2] / length;
    const double radius = 1 + 0.15 * std::sin(5 * x + 1) * std::cos(4 * y) + 0.1 * std::sin(7 * z + 3 * x);
    p[0] = static_cast<float>(1.3 * radius * x);
    p[1] = static_cast<float>(radius * y);
    p[2] = static_cast<float>(0.8 * radius * z);
  }
  return mesh;
}

ControlMesh goblet(int around, int rings) {
  ControlMesh mesh{"goblet", {}, {}};
  for (int i = 1; i < rings; ++i) {
    const double t = double(i) / rings;
    const double radius = std::sin(pi * t) * (0.7 + 0.35 * std::cos(9 * t));
    for (int j = 0; j < around; ++j)
      add_vertex(mesh, radius * std::cos(2 * pi * j / around), radius * std::sin(2 * pi * j / around), 2.2 * t);
  }
  const int bottom = (rings - 1) * around;
  add_vertex(mesh, 0, 0, 0);
  add_vertex(mesh, 0, 0, 2.2);
  for (int j = 0; j < around; ++j) {
    const int next = (j + 1) % around;
    add_triangle(mesh, next, j, bottom);
    add_triangle(mesh, bottom - around + j, bottom - around + next, bottom + 1);
    for (int i = 0; i + 2 < rings; ++i)
      add_quad(mesh, i * around + j, i * around + next, (i + 1) * around + next, (i + 1) * around + j);
  }
  return mesh;
}

// Each vertex whose valence changes keeps a valence of 4 to 9.
ControlMesh flipped(ControlMesh mesh, int flips) {
  using Edge = std::array<std::uint32_t, 2>;
  std::map<Edge, std::uint32_t> opposite;  // the half-edge with these two ends
  std::vector<int> valence(mesh.vertex_count(), 0);
  for (std::uint32_t h = 0; h < mesh.triangles.size(); ++h) {
    opposite[{mesh.triangles[h], mesh.triangles[h % 3 == 2 ? h - 2 : h + 1]}] = h;
    ++valence[mesh.triangles[h]];
  }
  const auto third = [&](std::uint32_t h) { return mesh.triangles[h % 3 == 0 ? h + 2 : h - 1]; };
  std::uint32_t state = 1;
  for (int done = 0, tried = 0; done < flips && tried < 100 * flips; ++tried) {
    state = state * 1664525U + 1013904223U;
    const std::uint32_t h = (state >> 8U) % static_cast<std::uint32_t>(mesh.triangles.size());
    const std::uint32_t a = mesh.triangles[h], b = mesh.triangles[h % 3 == 2 ? h - 2 : h + 1];
    const auto back = opposite.find({b, a});
    if (back == opposite.end()) continue;
    const std::uint32_t g = back->second, c = third(h), d = third(g);
    if (valence[a] < 5 || valence[b] < 5 || valence[c] > 8 || valence[d] > 8 || opposite.contains({c, d}) ||
        opposite.contains({d, c}))
      continue;
    opposite.erase({a, b});
    opposite.erase({b, a});
    const std::uint32_t first = h / 3 * 3, second = g / 3 * 3;
    const std::array<std::uint32_t, 6> corners = {a, d, c, d, b, c};
    for (std::uint32_t i = 0; i < 6; ++i) mesh.triangles[(i < 3 ? first : second - 3) + i] = corners[i];
    for (const std::uint32_t start : {first, second}) {
      for (std::uint32_t i = 0; i < 3; ++i)
        opposite[{mesh.triangles[start + i], mesh.triangles[start + (i + 1) % 3]}] = start + i;
    }
    --valence[a], --valence[b], ++valence[c], ++valence[d];
    ++done;
  }
  return mesh;
}

std::vector<ControlMesh> seven_meshes() {
  ControlMesh irregular = flipped(asteroid(3), 400);
  irregular.name = "flipped";
  return {knot(72, 7), shaken(asteroid(3), 0.003), irregular, densified(blocks(), 2), sheet(24), goblet(24, 24),
          drum(24)};
}

std::vector<ControlMesh> small_meshes() {
  return {shaken(icosahedron(), 0.02), shaken(cube(), 0.02), knot(60, 6), blocks(), sheet(12), bipyramid(12), drum(12)};
}

ControlMesh shaken(ControlMesh mesh, double amount) {
  const double size = 2 * amount * mesh.diagonal();
  std::uint32_t state = 12345;
  for (float& value : mesh.positions) {
    state = state * 1664525U + 1013904223U;
    value += static_cast<float>(size * (static_cast<double>(state >> 8U) / (1U << 24U) - 0.5));
  }
  return mesh;
}

ControlMesh densified(const ControlMesh& mesh, int levels) {
  if (levels == 0) return mesh;
  ControlMesh fine{mesh.name, mesh.positions, {}, {}};
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.emplace(std::array{std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(fine.vertex_count()));
    for (std::size_t axis = 0; is_new && axis < 3; ++axis)
      fine.positions.push_back((mesh.positions[3 * a + axis] + mesh.positions[3 * b + axis]) / 2);
    return found->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return densified(fine, levels - 1);
}

}  // namespace glark::qas::test
