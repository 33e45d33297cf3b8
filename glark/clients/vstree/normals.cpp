// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "glark/clients/vstree/neighbours.h"
#include "glark/clients/vstree/orientation.h"
#include "glark/clients/vstree/samples.h"

namespace glark::vstree {
namespace {

// The direction of the least extent; zero where two directions have none.
Float4 least_extent(std::span<const Float4> points, std::span<const std::uint32_t> which) {
  const Float4 first = points[which.front()];
  Float4 sum{}, rows[3] = {};
  for (const std::uint32_t i : which) {
    const Float4 d = points[i] - first;
    sum += d;
    rows[0] += splat<0>(d) * d;
    rows[1] += splat<1>(d) * d;
    rows[2] += splat<2>(d) * d;
  }
  const auto count = static_cast<float>(which.size());
  Eigen::Matrix3f products;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) products(i, k) = rows[i][k] - sum[i] * sum[k] / count;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(products);
  const Eigen::Vector3f& values = solver.eigenvalues();
  if (!(values[1] > 1e-6F * values[2])) return Float4{};
  const Eigen::Vector3f vector = solver.eigenvectors().col(0);
  return unit(Float4{vector[0], vector[1], vector[2], 0});
}

}  // namespace

std::vector<float> estimate_normals(const PointSet& points, const NormalOptions& options) {
  const Workers workers(options.threads);
  check(points, workers);
  if (options.neighbours < 3 || options.neighbours > 256) {
    throw Error(Element::option, 0, "neighbours is " + std::to_string(options.neighbours) + "; 3 to 256 are possible");
  }
  const Cube cube = bounding_cube(points.positions, workers);
  const std::size_t count = points.positions.size() / 3;
  std::vector<float> result(3 * count);
  if (count == 0) return result;
  std::vector<Float4> positions(count), normals(count);
  std::vector<bool> given(count);
  for (std::size_t i = 0; i < count; ++i) {
    positions[i] = cube.inside(&points.positions[3 * i]);
    if (!points.normals.empty()) normals[i] = unit_normal(&points.normals[3 * i]);
    given[i] = normals[i][3] > 0;
    normals[i] = without_fourth(normals[i]);
  }
  const std::size_t each = std::min<std::size_t>(options.neighbours, count);
  const std::vector<std::uint32_t> neighbours = nearest(positions, each, workers);
  workers.each(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!given[i]) normals[i] = least_extent(positions, std::span(neighbours).subspan(i * each, each));
    }
  });
  if (options.scanner == nullptr) {
    orient(positions, normals, neighbours, each, given);
  } else {
    const Float4 scanner = cube.inside(options.scanner->data());
    for (std::size_t i = 0; i < count; ++i) {
      if (!given[i] && dot(normals[i], scanner - positions[i]) < 0) normals[i] = -normals[i];
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = normals[i / 3][static_cast<int>(i % 3)];
  return result;
}

}  // namespace glark::vstree
