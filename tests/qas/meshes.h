// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse control meshes: the seven of the figures, and others.
#pragma once

#include <glark/qas.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace glark::qas::test {

struct ControlMesh {
  std::string name;
  std::vector<float> positions;  // x y z
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> creases = {};

  std::size_t vertex_count() const { return positions.size() / 3; }
  Mesh view() const { return {vertex_count(), triangles, creases}; }
  double diagonal() const;  // the diagonal of the bounding box
};

// The name that Google Test prints.
inline std::ostream& operator<<(std::ostream& out, const ControlMesh& mesh) { return out << mesh.name; }

ControlMesh icosahedron();
ControlMesh cube();                         // 12 triangles
ControlMesh knot(int along, int around);    // a trefoil of 2 * along * around triangles, every valence 6
ControlMesh blocks();                       // a ring of cubes with a post: genus 1, valences 4 to 8
ControlMesh sheet(int cells);               // a wavy square with a boundary, 2 * cells^2 triangles
ControlMesh bipyramid(int sides);           // two vertices of the valence `sides`
ControlMesh drum(int sides);                // a cylinder with lids, with creases along the edges of the lids
ControlMesh asteroid(int levels);           // 20 * 4^levels triangles
ControlMesh goblet(int around, int rings);  // a surface of revolution with two poles

std::vector<ControlMesh> seven_meshes();  // with 720 to 1440 triangles each, like the coarse meshes of the thesis
std::vector<ControlMesh> small_meshes();  // with 12 to 720 triangles each

// Flips random edges. This gives irregular valences, as decimation does.
ControlMesh flipped(ControlMesh mesh, int flips);

// Moves vertices by up to `amount` of the diagonal, the same way every time.
ControlMesh shaken(ControlMesh mesh, double amount);

// Splits each triangle linearly into four, `levels` times, for a large mesh to measure times.
ControlMesh densified(const ControlMesh& mesh, int levels);

}  // namespace glark::qas::test
