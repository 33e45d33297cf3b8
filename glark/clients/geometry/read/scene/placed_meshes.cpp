// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/scene/placed_meshes.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>

namespace glark::geometry {
namespace {

using Row = std::array<double, 3>;

Row crossed(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Row linear(const std::array<double, 4>& row) { return {row[0], row[1], row[2]}; }

double determinant(const std::array<std::array<double, 4>, 3>& place) {
  const Row cofactors = crossed(linear(place[1]), linear(place[2]));
  return place[0][0] * cofactors[0] + place[0][1] * cofactors[1] + place[0][2] * cofactors[2];
}

// The cofactors of a matrix are its inverse transpose times its determinant, whose sign is taken out.
void place_normals(PlacedMesh& placed) {
  const double sign = placed.mirrors() ? -1 : 1;
  for (std::size_t row = 0; row < 3; ++row) {
    placed.normal_place[row] = crossed(linear(placed.place[(row + 1) % 3]), linear(placed.place[(row + 2) % 3]));
    for (double& value : placed.normal_place[row]) value *= sign;
  }
}

PlacedMesh placed_by(const aiMesh& mesh, const aiMatrix4x4& matrix) {
  PlacedMesh placed{.mesh = &mesh, .moves = matrix != aiMatrix4x4()};
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 4; ++column)
      placed.place[row][column] = static_cast<double>(matrix[row][column]);
  place_normals(placed);
  return placed;
}

struct Visit {
  const aiNode* node;
  aiMatrix4x4 place;
};

}  // namespace

std::array<double, 3> PlacedMesh::position(unsigned vertex) const {
  const aiVector3D& local = mesh->mVertices[vertex];
  const Row from{static_cast<double>(local.x), static_cast<double>(local.y), static_cast<double>(local.z)};
  if (!moves) return from;
  Row to{};
  for (std::size_t row = 0; row < 3; ++row)
    to[row] = place[row][0] * from[0] + place[row][1] * from[1] + place[row][2] * from[2] + place[row][3];
  return to;
}

std::array<float, 3> PlacedMesh::normal(unsigned vertex) const {
  const aiVector3D& local = mesh->mNormals[vertex];
  if (!moves) return {local.x, local.y, local.z};
  Row to{};
  for (std::size_t row = 0; row < 3; ++row)
    to[row] = normal_place[row][0] * static_cast<double>(local.x) +
              normal_place[row][1] * static_cast<double>(local.y) + normal_place[row][2] * static_cast<double>(local.z);
  const double length = std::hypot(to[0], to[1], to[2]);
  const double scale = length > 0 ? 1 / length : 1;
  return {static_cast<float>(scale * to[0]), static_cast<float>(scale * to[1]), static_cast<float>(scale * to[2])};
}

bool PlacedMesh::mirrors() const { return moves && determinant(place) < 0; }

std::vector<PlacedMesh> placed_meshes(const aiScene& scene) {
  std::vector<PlacedMesh> meshes;
  std::vector<Visit> waiting{{scene.mRootNode, aiMatrix4x4()}};
  while (!waiting.empty()) {
    const Visit visit = waiting.back();
    waiting.pop_back();
    if (visit.node == nullptr) continue;
    const aiMatrix4x4 place = visit.place * visit.node->mTransformation;
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i)
      meshes.push_back(placed_by(*scene.mMeshes[visit.node->mMeshes[i]], place));
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) waiting.push_back({visit.node->mChildren[i - 1], place});
  }
  return meshes;
}

std::vector<PlacedMesh> unplaced_meshes(const aiScene& scene) {
  std::vector<PlacedMesh> meshes;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) meshes.push_back(placed_by(*scene.mMeshes[i], aiMatrix4x4()));
  return meshes;
}

}  // namespace glark::geometry
