// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The meshes of a scene, in the places that its nodes give them.
#pragma once

#include <array>
#include <vector>

struct aiMesh;
struct aiScene;

namespace glark::geometry {

struct PlacedMesh {
  const aiMesh* mesh = nullptr;
  bool moves = false;                                   // otherwise the place is the identity
  std::array<std::array<double, 4>, 3> place{};         // rows: the linear part, and what is added
  std::array<std::array<double, 3>, 3> normal_place{};  // its inverse transpose, up to a factor above zero

  std::array<double, 3> position(unsigned vertex) const;
  std::array<float, 3> normal(unsigned vertex) const;  // of length 1 if the place is not the identity
  // The place is a reflection: triangles have to turn, so that their normals point to the same side.
  bool mirrors() const;
};

// In the order of the nodes. A mesh of several nodes comes several times, one without a node not at all.
std::vector<PlacedMesh> placed_meshes(const aiScene& scene);

// All meshes, where they are.
std::vector<PlacedMesh> unplaced_meshes(const aiScene& scene);

}  // namespace glark::geometry
