// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/census.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace glark::maps {
namespace {

// How much the normals of points differ from those of the triangles.
class NormalSpreads {
 public:
  explicit NormalSpreads(const Surface& surface) : surface_(surface), counts_(surface.triangles.size()) {}

  void add(std::uint32_t triangle, Vector normal) {
    if (common::is_zero(normal)) return;
    const float cosine = common::dot(normal, surface_.triangle_normals[triangle]);
    const float angle = std::acos(std::clamp(cosine, -1.0F, 1.0F));
    std::uint16_t& count = counts_[triangle][std::min(static_cast<std::size_t>(angle / width_of_bin), bins - 1)];
    if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  }
  std::vector<float> medians() const {
    std::vector<float> medians;
    for (const Counts& counts : counts_) medians.push_back(median_of(counts));
    return medians;
  }

 private:
  static constexpr std::size_t bins = 16;
  static constexpr float width_of_bin = 0.05F;  // 3 degrees
  using Counts = std::array<std::uint16_t, bins>;

  static float median_of(const Counts& counts) {
    const float half = std::accumulate(counts.begin(), counts.end(), 0.0F) / 2;
    float before = 0;
    for (std::size_t i = 0; i + 1 < bins && half > 0; ++i) {
      const float count = counts[i];
      if (before + count >= half) return width_of_bin * (static_cast<float>(i) + (half - before) / count);
      before += count;
    }
    return std::numeric_limits<float>::infinity();
  }

  const Surface& surface_;
  std::vector<Counts> counts_;  // of the points on each triangle, by their angle
};

}  // namespace

Census take_census(SampleStream& stream, const Shell& shell, std::size_t triangles, const common::Workers& workers) {
  constexpr std::uint64_t run = 2048;
  constexpr std::uint64_t enough = 1 << 18;
  constexpr std::uint64_t one_of = 16;  // where the number of points is not known
  const std::uint64_t step = stream.count() ? std::max<std::uint64_t>(*stream.count() / enough, 1) : one_of;
  Census census;
  census.points.assign(triangles, 0);
  NormalSpreads spreads(shell.surface());
  std::vector<Sample> samples;
  std::vector<Foot> feet;
  double squares = 0;
  std::uint64_t looked_at = 0;
  bool may_skip = true;
  for (std::uint64_t i = 0; stream.next(run, samples); ++i) {
    const std::uint64_t next = (i + 1) * step * run;
    if (may_skip && step > 1) {
      if (stream.count() && next >= *stream.count())
        may_skip = false;
      else
        may_skip = stream.skip_to(next);
    } else if (step > 1 && i % step != 0) {
      continue;
    }
    feet.assign(samples.size(), {});
    workers.each(samples.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        if (const auto foot = shell.foot_of(samples[k].position, samples[k].normal)) feet[k] = *foot;
    });
    for (std::size_t k = 0; k < feet.size(); ++k) {
      const Foot& foot = feet[k];
      if (foot.triangle == none) continue;
      spreads.add(foot.triangle, samples[k].normal);
      census.points[foot.triangle] += static_cast<double>(step);
      squares += static_cast<double>(foot.height) * static_cast<double>(foot.height);
      ++looked_at;
    }
  }
  if (stream.has_normals()) census.spreads = spreads.medians();
  census.points_with_foot = static_cast<double>(looked_at * step);
  census.root_mean_square = looked_at > 0 ? std::sqrt(squares / static_cast<double>(looked_at)) : 0;
  return census;
}

}  // namespace glark::maps
