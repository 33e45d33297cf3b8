// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/tree/plane_normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "glark/clients/stream/sample/grid/lattice.h"

namespace glark::stream {
namespace {

// The micro-clusters around each one: up to 26, and itself.
class Neighbourhoods {
 public:
  Neighbourhoods(std::span<const MicroCluster> clusters, unsigned bits)
      : clusters_(clusters), last_((1U << bits) - 1) {}

  // Calls step(other, offset in cubes) for each neighbour, itself included.
  template <class Step>
  void each(std::uint32_t i, const Step& step) const {
    const std::uint64_t key = clusters_[i].key;
    const std::array<std::uint32_t, 3> at{gather_third_bits(key), gather_third_bits(key >> 1),
                                          gather_third_bits(key >> 2)};
    for (int n = 0; n < 27; ++n) {
      const std::array<int, 3> offset{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      std::array<std::uint32_t, 3> cube{};
      bool is_inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        cube[k] = at[k] + static_cast<std::uint32_t>(offset[k]);
        is_inside &= cube[k] <= last_;  // -1 is a great number
      }
      if (!is_inside) continue;
      const auto other = static_cast<std::uint32_t>(Lattice::key(cube));
      const auto found = std::lower_bound(clusters_.begin(), clusters_.end(), other,
                                          [](const MicroCluster& cluster, std::uint32_t k) { return cluster.key < k; });
      if (found != clusters_.end() && found->key == other)
        step(static_cast<std::uint32_t>(found - clusters_.begin()), offset);
    }
  }

 private:
  std::span<const MicroCluster> clusters_;
  std::uint32_t last_;
};

Eigen::Vector3d plane_normal(std::span<const MicroCluster> clusters, const Neighbourhoods& around, std::uint32_t i,
                             double small) {
  double count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  around.each(i, [&](std::uint32_t other, const std::array<int, 3>& offset) {
    const MicroCluster& c = clusters[other];
    const Eigen::Vector3d p(c.position[0], c.position[1], c.position[2]);
    const Eigen::Vector3d by = small * Eigen::Vector3d(offset[0], offset[1], offset[2]);
    Eigen::Matrix3d m;
    m << c.sums[0], c.sums[3], c.sums[5], c.sums[3], c.sums[1], c.sums[4], c.sums[5], c.sums[4], c.sums[2];
    products += m + p * by.transpose() + by * p.transpose() + c.count * by * by.transpose();
    sum += p + c.count * by;
    count += c.count;
  });
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(products / count - sum * sum.transpose() / (count * count));
  return solver.eigenvectors().col(0);
}

}  // namespace

void find_plane_normals(std::span<MicroCluster> clusters, unsigned bits, double side) {
  const double small = std::ldexp(side, -static_cast<int>(bits));
  const Neighbourhoods around(clusters, bits);
  std::vector<Eigen::Vector3d> normals(clusters.size());
  for (std::uint32_t i = 0; i < clusters.size(); ++i) normals[i] = plane_normal(clusters, around, i, small);
  std::vector<bool> is_done(clusters.size());
  std::vector<std::uint32_t> queue;
  for (std::uint32_t start = 0; start < clusters.size(); ++start) {
    if (is_done[start]) continue;
    is_done[start] = true;
    queue.assign(1, start);
    for (std::size_t next = 0; next < queue.size(); ++next)
      around.each(queue[next], [&](std::uint32_t other, const std::array<int, 3>&) {
        if (is_done[other]) return;
        is_done[other] = true;
        if (normals[other].dot(normals[queue[next]]) < 0) normals[other] = -normals[other];
        queue.push_back(other);
      });
  }
  for (std::uint32_t i = 0; i < clusters.size(); ++i) {
    MicroCluster& c = clusters[i];
    const Eigen::Vector3d n = normals[i];
    Eigen::Matrix3d m;
    m << c.sums[0], c.sums[3], c.sums[5], c.sums[3], c.sums[1], c.sums[4], c.sums[5], c.sums[4], c.sums[2];
    const double d = -n.dot(Eigen::Vector3d(c.position[0], c.position[1], c.position[2]));  // the sum of all d
    const double count = c.count;
    const std::array<double, 10> quadric{count * n[0] * n[0],
                                         count * n[1] * n[1],
                                         count * n[2] * n[2],
                                         count * n[0] * n[1],
                                         count * n[1] * n[2],
                                         count * n[2] * n[0],
                                         n[0] * d,
                                         n[1] * d,
                                         n[2] * d,
                                         n.dot(m * n)};
    for (std::size_t k = 0; k < quadric.size(); ++k) c.sums[k] = static_cast<float>(quadric[k]);
    for (int k = 0; k < 3; ++k) c.normal[static_cast<std::size_t>(k)] = static_cast<float>(count * n[k]);
  }
}

}  // namespace glark::stream
