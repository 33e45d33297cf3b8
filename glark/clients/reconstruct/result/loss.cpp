// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/result/loss.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/points/point_set.h"
#include "glark/clients/reconstruct/density/neighbours.h"
#include "glark/clients/reconstruct/result/balls_in_cells.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t neighbours_looked_at = 16;  // of both sides of a thin sheet
constexpr std::size_t sixth = 5;
constexpr float sixth_neighbour = 1.38F;  // its distance, in spacings
constexpr float most_spacings = 3;
constexpr float most_noise = 3;
constexpr std::size_t grain = 256;

// The spacing and the noise of the points that face the same way as one of them.
class LocalBound {
 public:
  explicit LocalBound(const Neighbours& neighbours) : neighbours_(neighbours) {}

  float around(std::uint32_t entry) {
    neighbours_.find(entry, neighbours_looked_at, near_);
    heights_.clear();
    float distance = 0;
    const Float4 point = neighbours_.point(entry), normal = neighbours_.normal(entry);
    for (const Neighbours::Near& near : near_) {
      const Float4 other = neighbours_.normal(near.entry);
      if (dot(normal, other) <= 0) continue;
      // On a quadratic surface, half the slope of the normals gives the height over the plane.
      heights_.push_back(std::abs(dot(neighbours_.point(near.entry) - point, normal + other)) / 2);
      if (heights_.size() <= sixth + 1) distance = std::sqrt(near.square);
    }
    if (heights_.size() <= sixth && !near_.empty()) distance = std::sqrt(near_.back().square);
    return most_spacings * distance / sixth_neighbour + most_noise * noise();
  }

 private:
  // The standard deviation of the heights. If they are normally distributed, a quarter of them is below a third of it.
  // The lowest quarter lies on the sheet of the point itself, so other sheets that face the same way do not count.
  float noise() {
    if (heights_.empty()) return 0;
    const auto quarter = heights_.begin() + static_cast<std::ptrdiff_t>(heights_.size() / 4);
    std::nth_element(heights_.begin(), quarter, heights_.end());
    return 3 * *quarter;
  }

  const Neighbours& neighbours_;
  std::vector<Neighbours::Near> near_;
  std::vector<float> heights_;
};

// The entries that are no outliers, in the order of the cells.
std::vector<std::uint32_t> chosen(const std::vector<Entry>& entries, std::span<const std::uint32_t> outliers) {
  std::vector<std::uint32_t> counting;
  counting.reserve(entries.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (!std::binary_search(outliers.begin(), outliers.end(), entries[i].index)) counting.push_back(i);
  }
  return counting;
}

// Keeps at most most_measured entries, spread evenly over the cells.
void keep_some(std::vector<std::uint32_t>& counting) {
  const std::size_t all = counting.size();
  if (all <= most_measured) return;
  for (std::size_t i = 0; i < most_measured; ++i) counting[i] = counting[i * all / most_measured];
  counting.resize(most_measured);
}

Float4 normal_at(std::span<const float> normals, std::size_t i) {
  return Float4{normals[3 * i], normals[3 * i + 1], normals[3 * i + 2], 0};
}

// Returns how many balls the mesh does not reach. Most balls have many vertices, so a few vertices take most of them,
// and triangles the last ones.
std::size_t beyond_reach(std::vector<Ball> balls, const MeshView& mesh, const Cube& cube) {
  const std::size_t vertices = mesh.positions.size() / 3;
  const auto vertex = [&](std::size_t i) { return cube.inside(&mesh.positions[3 * i]); };
  for (const std::size_t step : {std::size_t{8}, std::size_t{1}}) {
    if (mesh.normals.empty()) break;
    BallsInCells cells(balls);
    for (std::size_t i = 0; i < vertices; i += step) cells.take(vertex(i), normal_at(mesh.normals, i));
    balls = cells.left();
    if (balls.empty()) return 0;
  }
  BallsInCells cells(balls);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    cells.take(vertex(mesh.triangles[i]), vertex(mesh.triangles[i + 1]), vertex(mesh.triangles[i + 2]));
  return cells.left().size();
}

}  // namespace

Loss loss_of(const PointSet& points, std::span<const std::uint32_t> outliers, const MeshView& mesh, float tolerance,
             const Workers& workers) {
  const SortedSamples sorted = sort_by_cells(points, workers);
  std::vector<std::uint32_t> measured = chosen(sorted.entries, outliers);
  Loss loss;
  loss.points = measured.size();
  keep_some(measured);
  loss.measured = measured.size();
  if (measured.empty()) return loss;

  const Neighbours neighbours(points, sorted.cube, sorted.entries);
  std::vector<Ball> balls(measured.size());
  workers.each(measured.size(), grain, [&](std::size_t begin, std::size_t end) {
    LocalBound bound(neighbours);
    for (std::size_t i = begin; i < end; ++i)
      balls[i] = {neighbours.point(measured[i]), neighbours.normal(measured[i]),
                  bound.around(measured[i]) + tolerance * sorted.cube.scale};
  });
  loss.lost = beyond_reach(std::move(balls), mesh, sorted.cube);
  return loss;
}

}  // namespace glark::reconstruct
