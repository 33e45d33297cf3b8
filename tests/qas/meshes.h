// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse control meshes: the seven that figures are given for, and others.
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
  double diagonal() const;  // of the bounding box
};

// How Google Test names it.
inline std::ostream& operator<<(std::ostream& out, const ControlMesh& mesh) { return out << mesh.name; }

ControlMesh icosahedron();
ControlMesh cube();                         // 12 triangles
ControlMesh knot(int along, int around);    // a trefoil of 2 * along * around triangles, every valence 6
ControlMesh blocks();                       // a ring of cubes with a post: genus 1, valences 4 to 8
ControlMesh sheet(int cells);               // a wavy square with a boundary, 2 * cells^2 triangles
ControlMesh bipyramid(int sides);           // two vertices of that valence
ControlMesh drum(int sides);                // a cylinder with lids, creases along the two rims
ControlMesh asteroid(int levels);           // 20 * 4^levels triangles
ControlMesh goblet(int around, int rings);  // of revolution; two poles

std::vector<ControlMesh> seven_meshes();  // of 720 to 1440 triangles, as the coarse meshes of the thesis are
std::vector<ControlMesh> small_meshes();  // of 12 to 720

// With edges turned at random: irregular valences, as decimation leaves.
ControlMesh flipped(ControlMesh mesh, int flips);

// Vertices moved by up to `amount` of the diagonal, the same way every time.
ControlMesh shaken(ControlMesh mesh, double amount);

// The surface after `levels` linear splits of each triangle into four: a large mesh for timing.
ControlMesh densified(const ControlMesh& mesh, int levels);

}  // namespace glark::qas::test
