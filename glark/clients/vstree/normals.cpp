// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "glark/clients/vstree/cells.h"
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

// The points by the cells of a grid, so that near ones have near numbers. Their own are the bits of the fourth.
std::vector<Float4> sorted(const PointSet& points, const Cube& cube, const Workers& workers) {
  constexpr unsigned levels = 6;  // cells of a few hundred points, of millions of a surface
  std::vector<Float4> result(points.positions.size() / 3);
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i)
      *keys++ = cube_key(octree_cell(cube.inside(&points.positions[3 * i])), octree_levels - levels);
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) {
      Float4 point = cube.inside(&points.positions[3 * i]);
      point[3] = std::bit_cast<float>(static_cast<std::uint32_t>(i));
      result[*slots++] = point;
    }
  };
  sort_by_key(result.size(), std::size_t{1} << (3 * levels), key, move, workers);
  return result;
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
  std::vector<Float4> positions = sorted(points, cube, workers), normals(count);
  std::vector<std::uint32_t> index(count);
  std::vector<bool> given(count);
  for (std::size_t i = 0; i < count; ++i) {
    index[i] = std::bit_cast<std::uint32_t>(static_cast<float>(positions[i][3]));
    positions[i] = without_fourth(positions[i]);
    if (!points.normals.empty()) normals[i] = unit_normal(&points.normals[3 * std::size_t{index[i]}]);
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
    orient(positions, normals, neighbours, each, given, workers);
  } else {
    const Float4 scanner = cube.inside(options.scanner->data());
    for (std::size_t i = 0; i < count; ++i) {
      if (!given[i] && dot(normals[i], scanner - positions[i]) < 0) normals[i] = -normals[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[3 * std::size_t{index[i]} + k] = normals[i][k];
  }
  return result;
}

}  // namespace glark::vstree
