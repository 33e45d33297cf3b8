// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/simplify/within_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "glark/clients/geometry/measure/distance.h"

namespace glark::tool {
namespace {

constexpr int most_rounds = 7;
constexpr double near_enough = 0.9;     // a distance of this part of the most allowed one ends the search
constexpr double near_bounds = 1.05;    // so does this ratio of a bound that fails to one that holds
constexpr std::size_t few_samples = 8;  // the search takes one of so many samples
constexpr double infinity = std::numeric_limits<double>::infinity();

// The bounds of the estimate that were tried. All numbers are relative to the diagonal.
class Bounds {
 public:
  explicit Bounds(double most) : most_(most), bound_(std::min(most, 1.0)) {}

  double bound() const { return bound_; }
  bool is_closed() const { return fails_ <= near_bounds * holds_; }

  // Chooses the next bound after one whose result has this distance.
  void next(double distance) {
    const bool holds = distance <= most_;
    (holds ? holds_ : fails_) = bound_;
    if (holds_ > 0 && fails_ < infinity)
      bound_ = std::sqrt(holds_ * fails_);
    else
      bound_ *= holds ? 2 : std::clamp(near_enough * most_ / distance, 0.1, 0.7);
  }

 private:
  double most_, bound_;
  double holds_ = 0, fails_ = infinity;
};

class Search {
 public:
  Search(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options)
      : geometry_(geometry),
        options_(options),
        distance_to_(geometry::hausdorff_from(geometry)),
        diagonal_(geometry::diagonal_of(geometry)) {}

  // The results that seem to hold, by few samples. The last one has the fewest triangles.
  std::vector<Coarse> find() {
    const double most = options_.max_error, least = near_enough * most;
    std::vector<Coarse> found;
    std::size_t fewest = geometry_.triangle_count();
    Bounds bounds(most);
    for (int round = 0; round < most_rounds && !bounds.is_closed(); ++round) {
      vstree::SimplifyOptions tried = options_;
      tried.max_error = static_cast<float>(bounds.bound());
      Coarse coarse = simplified(geometry_, tried);
      const std::size_t count = coarse.geometry.triangle_count();
      // The first distance tells how far the bound is off. For later ones, it only matters whether they hold.
      const double distance =
          distance_to(coarse, {least * diagonal_, round == 0 ? infinity : most * diagonal_, few_samples});
      if (distance <= most && count < fewest) {
        fewest = count;
        found.push_back(std::move(coarse));
      }
      const bool is_at_target = options_.target > 0 && count <= options_.target;
      if (distance <= most && (is_at_target || distance > least * (1 + 1e-6))) break;
      bounds.next(distance);
    }
    return found;
  }

  // Relative to the diagonal. An empty result has no distance.
  double distance_to(const Coarse& coarse, const geometry::Needed& needed) const {
    return coarse.geometry.triangles.empty() ? infinity : distance_to_(coarse.geometry, needed) / diagonal_;
  }

 private:
  const geometry::Geometry& geometry_;
  const vstree::SimplifyOptions& options_;
  geometry::HausdorffDistance distance_to_;
  double diagonal_;
};

}  // namespace

Coarse simplified_within_error(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options) {
  Search search(geometry, options);
  const auto holds = [&](Coarse& coarse) {
    const double distance = search.distance_to(coarse, {});
    if (distance <= options.max_error) coarse.measured = distance;
    return coarse.measured.has_value();
  };
  std::vector<Coarse> found = search.find();
  // Few samples may miss where a result is farthest, and all that were found lie just below the bound.
  vstree::SimplifyOptions tighter = options;
  tighter.max_error = std::min(options.max_error, 1.0F);
  for (; !found.empty(); found.pop_back())
    if (holds(found.back())) return std::move(found.back());
  for (int round = 0; round < most_rounds; ++round) {
    tighter.max_error /= 2;
    Coarse coarse = simplified(geometry, tighter);
    if (coarse.geometry.triangle_count() >= geometry.triangle_count()) break;
    if (holds(coarse)) return coarse;
  }
  return {geometry, vstree::Method::collapse, 0, 0.0};
}

}  // namespace glark::tool
