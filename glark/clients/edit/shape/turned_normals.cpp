// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/shape/turned_normals.h"

#include <Eigen/Dense>

namespace glark::edit {
namespace {

Eigen::Vector3d difference(const Samples& samples, std::size_t a, std::size_t b) {
  const Vector3d d = samples.position(a) - samples.position(b);
  return {d.x, d.y, d.z};
}

Vector3f turned(const Shape& shape, std::uint32_t sample) {
  const Vector3f n = shape.before.normal(sample);
  const Eigen::Vector3d normal(n.x, n.y, n.z);
  if (!(normal.norm() > 0)) return n;
  Eigen::Matrix3d before = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
  for (const std::uint32_t k : shape.graph.of(sample)) {
    const Eigen::Vector3d from = difference(shape.before, k, sample);
    before += from * from.transpose();
    both += difference(shape.now, k, sample) * from.transpose();
  }
  // The neighbours say little about the map across the surface. The cross product does not need it.
  const double extent = before.trace();
  const Eigen::Matrix3d map = both * (before + 1e-9 * (extent + 1e-30) * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Eigen::Vector3d after = (map * u).cross(map * v).normalized();
  if (!after.allFinite() || !(after.norm() > 0)) return n;
  return {static_cast<float>(after[0]), static_cast<float>(after[1]), static_cast<float>(after[2])};
}

}  // namespace

std::vector<Vector3f> turned_normals(const Shape& shape, std::span<const std::uint32_t> samples,
                                     const common::Workers& workers) {
  std::vector<Vector3f> normals(samples.size());
  workers.each(samples.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) normals[i] = turned(shape, samples[i]);
  });
  return normals;
}

}  // namespace glark::edit
