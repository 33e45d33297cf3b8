// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glark::vstree {
namespace {

constexpr std::size_t least_neighbours = 12;  // fewer do not show which of them are on another side
constexpr float flat = 0.02F;                 // the flatness of neighbours that lie near to one plane
constexpr float two_sided = 0.1F;             // the flatness of neighbours on two sides; curvature has less
constexpr std::size_t near = 7;               // neighbours whose planes are tried
constexpr float band = 0.05F;                 // the height over a plane that counts as on it, relative to the radius
constexpr std::size_t least_on_plane = 7;     // samples
constexpr float clear = 0.1F;        // their root mean square height, relative to the band; noise fills the band
constexpr float noise_band = 2.5F;   // the band of noisy samples, relative to the noise
constexpr float widest_band = 0.3F;  // relative to the radius; more noise hides the two sides
constexpr float better = 0.75F;      // the misfit of the plane of one side, relative to that of all samples
constexpr float reach = 1.5F;        // the height up to which a sample has weight, relative to the band
constexpr int rounds = 3;            // of fitting a plane to the samples near it

struct Plane {
  Float4 point{}, normal{};
  float flatness = 0;  // the variance along the normal, relative to the sum over all directions; none has 1/3
};

class Sums {
 public:
  void add(Float4 d, float weight) {
    sum_ += d * weight;
    rows_[0] += splat<0>(d) * d * weight;
    rows_[1] += splat<1>(d) * d * weight;
    rows_[2] += splat<2>(d) * d * weight;
    weight_ += weight;
  }
  Plane plane() const {
    Eigen::Matrix3f products;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) products(i, k) = rows_[i][k] - sum_[i] * sum_[k] / weight_;
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(products);
    const Eigen::Vector3f& values = solver.eigenvalues();
    if (!(values[1] > 1e-6F * values[2])) return {};
    const Eigen::Vector3f vector = solver.eigenvectors().col(0);
    return {sum_ / weight_, unit(Float4{vector[0], vector[1], vector[2], 0}), values[0] / values.sum()};
  }

 private:
  Float4 sum_{}, rows_[3] = {};
  float weight_ = 0;
};

class Fit {
 public:
  Fit(std::span<const Float4> points, std::span<const std::uint32_t> which) : offsets_(storage_.data(), which.size()) {
    for (std::size_t i = 0; i < which.size(); ++i) offsets_[i] = points[which[i]] - points[which[0]];
    radius_ = std::sqrt(dot(offsets_.back(), offsets_.back()));
  }

  Float4 normal(float noise) {
    const Plane all = plane_of(offsets_.size());
    if (offsets_.size() < least_neighbours || all.flatness < flat) return all.normal;
    band_ = band * radius_;
    if (const Plane plane = best_plane(); is_clear(plane)) return plane.normal;
    const float wider = noise_band * noise;
    if (all.flatness < two_sided || wider < band || wider > widest_band) return all.normal;
    band_ = wider * radius_;
    const Plane plane = best_plane();
    return count_on(plane) > least_on_plane && misfit(plane) < better * misfit(all) ? plane.normal : all.normal;
  }

  // The root mean square height of the nearest samples over their own plane, relative to the radius.
  float noise() const {
    const std::size_t count = std::min(near, offsets_.size());
    const Plane plane = plane_of(count);
    float squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float height = dot(offsets_[i] - plane.point, plane.normal);
      squares += height * height;
    }
    return count > 3 ? std::sqrt(squares / static_cast<float>(count - 3)) / radius_ : 0;
  }

 private:
  Plane plane_of(std::size_t count) const {
    Sums sums;
    for (std::size_t i = 0; i < count; ++i) sums.add(offsets_[i], 1);
    return sums.plane();
  }

  // The squared height over a plane, relative to the band.
  float square_over(const Plane& plane, Float4 offset) const {
    const float height = dot(offset - plane.point, plane.normal) / band_;
    return height * height;
  }

  // The sum of the squared heights. Each counts at most 1.
  float misfit(const Plane& plane) const {
    float sum = 0;
    for (const Float4 offset : offsets_) sum += std::min(square_over(plane, offset), 1.0F);
    return sum;
  }

  std::size_t count_on(const Plane& plane) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(offsets_, [&](Float4 offset) { return square_over(plane, offset) <= 1; }));
  }

  bool is_clear(const Plane& plane) const {
    const std::size_t count = count_on(plane);
    // Each of the others adds 1 to the misfit.
    const float squares = misfit(plane) - static_cast<float>(offsets_.size() - count);
    return count >= least_on_plane && squares < clear * clear * static_cast<float>(count);
  }

  // Tries the planes through the sample. Then fits the best one to the samples near it.
  Plane best_plane() const {
    Plane best{Float4{}, plane_of(near).normal};
    float least = misfit(best);
    for (std::size_t i = 1; i <= near; ++i) {
      for (std::size_t k = i + 1; k <= near; ++k) {
        const Float4 normal = cross(offsets_[i], offsets_[k]);
        if (!(dot(normal, normal) > 0)) continue;
        const Plane plane{Float4{}, unit(normal)};
        const float value = misfit(plane);
        if (value >= least) continue;
        least = value;
        best = plane;
      }
    }
    if (least > static_cast<float>(offsets_.size() - least_on_plane)) return best;  // it has too few samples
    for (int round = 0; round < rounds; ++round) {
      Sums sums;
      for (const Float4 offset : offsets_) {
        const float rest = 1 - square_over(best, offset) / (reach * reach);
        if (rest > 0) sums.add(offset, rest * rest);
      }
      const Plane plane = sums.plane();
      if (!(dot(plane.normal, plane.normal) > 0)) break;
      best = plane;
    }
    return best;
  }

  std::array<Float4, most_neighbours> storage_;  // no allocation for each sample
  std::span<Float4> offsets_;                    // from the sample to its neighbours
  float radius_ = 0, band_ = 0;
};

}  // namespace

float median_noise(std::span<const Float4> points, std::span<const std::uint32_t> neighbours, std::size_t each) {
  constexpr std::size_t most_examined = 4096;
  if (each < least_neighbours) return 0;
  const std::size_t step = std::max<std::size_t>(1, points.size() / most_examined);
  std::vector<float> noises;
  for (std::size_t i = 0; i < points.size(); i += step)
    noises.push_back(Fit(points, neighbours.subspan(i * each, each)).noise());
  const auto middle = noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 2);
  std::ranges::nth_element(noises, middle);
  return *middle;
}

Float4 fit_normal(std::span<const Float4> points, std::span<const std::uint32_t> which, float noise) {
  return Fit(points, which).normal(noise);
}

}  // namespace glark::vstree
