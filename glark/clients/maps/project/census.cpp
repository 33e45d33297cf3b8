// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/census.h"

#include <algorithm>
#include <cmath>

namespace glark::maps {

Census take_census(SampleStream& stream, const Shell& shell, std::size_t triangles, const common::Workers& workers) {
  constexpr std::uint64_t run = 2048;
  constexpr std::uint64_t enough = 1 << 18;
  constexpr std::uint64_t one_of = 16;  // where the number of points is not known
  const std::uint64_t step = stream.count() ? std::max<std::uint64_t>(*stream.count() / enough, 1) : one_of;
  Census census;
  census.points.assign(triangles, 0);
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
    for (const Foot& foot : feet) {
      if (foot.triangle == none) continue;
      census.points[foot.triangle] += static_cast<double>(step);
      squares += static_cast<double>(foot.height) * static_cast<double>(foot.height);
      ++looked_at;
    }
  }
  census.points_with_foot = static_cast<double>(looked_at * step);
  census.root_mean_square = looked_at > 0 ? std::sqrt(squares / static_cast<double>(looked_at)) : 0;
  return census;
}

}  // namespace glark::maps
