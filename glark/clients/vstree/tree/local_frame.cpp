// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/tree/local_frame.h"

#include <Eigen/Eigenvalues>

namespace glark::vstree {
namespace {

// Returns the direction in which the normals vary most, as a unit vector in the plane of the mean normal. It is the
// eigenvector of the larger of the two eigenvalues. The other eigenvector is orthogonal to it.
// Source: Boubekeur 2007, ch. 3.2.2.
Float4 main_direction(std::span<const Record> records, Float4 normal) {
  Float4 rows[3] = {};
  for (const Record& record : records) {
    rows[0] += splat<0>(record.normal) * record.normal;
    rows[1] += splat<1>(record.normal) * record.normal;
    rows[2] += splat<2>(record.normal) * record.normal;
  }
  Eigen::Matrix3f scatter;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) scatter(i, k) = rows[i][k];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(scatter);
  // Eigenvectors are sorted by eigenvalue. The last one is nearly the normal itself.
  for (const int which : {1, 0}) {
    const Eigen::Vector3f vector = solver.eigenvectors().col(which);
    const Float4 direction{vector[0], vector[1], vector[2], 0};
    const Float4 projected = direction - normal * dot(direction, normal);
    if (dot(projected, projected) > 0.01F) return unit(projected);
  }
  const Float4 axis = std::abs(normal[0]) < 0.6F ? Float4{1, 0, 0, 0} : Float4{0, 1, 0, 0};
  return unit(axis - normal * dot(axis, normal));
}

}  // namespace

LocalFrame frame_of(std::span<const Record> records, const Moments& moments) {
  LocalFrame frame;
  frame.origin = without_fourth(moments.mean);
  Float4 normal = moments.normal();
  if (dot(normal, normal) == 0) normal = Float4{0, 0, 1, 0};  // equal samples without normals
  const Float4 u = main_direction(records, normal);
  const Float4 v = cross(normal, u);
  for (int i = 0; i < 3; ++i) frame.columns[i] = Float4{u[i], v[i], normal[i], 0};
  frame.fit(records);
  return frame;
}

void LocalFrame::fit(std::span<const Record> records) {
  Float4 least_corner{1e30F, 1e30F, 1e30F, 0};
  Float4 greatest_corner = -least_corner;
  for (const Record& record : records) {
    const Float4 position = inside(record.point());
    least_corner = least(least_corner, position);
    greatest_corner = greatest(greatest_corner, position);
  }
  constexpr float cells = 1U << quadtree_levels;
  for (int i = 0; i < 2; ++i) {
    low[i] = least_corner[i];
    size[i] = greatest_corner[i] - least_corner[i];
    scale[i] = size[i] > 1e-30F ? cells / size[i] : 0;
  }
}

Frame LocalFrame::in_space(const Cube& cube, std::uint32_t node) const {
  Frame frame;
  frame.origin = triple(cube.low + origin * cube.side);
  frame.u = {columns[0][0], columns[1][0], columns[2][0]};
  frame.v = {columns[0][1], columns[1][1], columns[2][1]};
  frame.normal = {columns[0][2], columns[1][2], columns[2][2]};
  for (std::size_t i = 0; i < 2; ++i) {
    frame.low[i] = low[i] * cube.side;
    frame.size[i] = size[i] * cube.side;
  }
  frame.node = node;
  return frame;
}

}  // namespace glark::vstree
