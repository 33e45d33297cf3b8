// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/seams.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <list>

#include "glark/clients/maps/seams/equaliser.h"
#include "glark/clients/maps/seams/mip_levels.h"
#include "glark/clients/maps/seams/samples.h"

namespace glark::maps {
namespace {

constexpr float measured_samples_per_texel = 8;

[[maybe_unused]] bool are_valid(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams) {
  return std::all_of(charts.begin(), charts.end(),
                     [&](const ChartImage& chart) {
                       return chart.width > 0 && chart.height > 0 &&
                              chart.values.size() == std::size_t{chart.width} * chart.height * channels;
                     }) &&
         std::all_of(seams.begin(), seams.end(),
                     [&](const Seam& seam) { return seam.a.chart < charts.size() && seam.b.chart < charts.size(); });
}

}  // namespace

SeamDifferences seam_jumps(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams) {
  assert(are_valid(charts, channels, seams));
  SeamDifferences jumps{std::vector<float>(channels), std::vector<float>(channels)};
  std::vector<double> squares(channels);
  std::size_t count = 0;
  for_all_samples(charts, seams, measured_samples_per_texel,
                  [&](std::size_t i, float, const BilinearSample& a, const BilinearSample& b) {
                    for (unsigned c = 0; c < channels; ++c) {
                      const float jump = std::abs(value_of(charts[seams[i].a.chart], a, channels, c) -
                                                  value_of(charts[seams[i].b.chart], b, channels, c));
                      jumps.greatest[c] = std::max(jumps.greatest[c], jump);
                      squares[c] += static_cast<double>(jump) * jump;
                    }
                    ++count;
                  });
  for (unsigned c = 0; c < channels && count > 0; ++c)
    jumps.root_mean_square[c] = static_cast<float>(std::sqrt(squares[c] / static_cast<double>(count)));
  return jumps;
}

void equalise(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
              const SeamOptions& options, std::span<const SeamFrames> frames) {
  assert(are_valid(charts, channels, seams) && (frames.empty() || frames.size() == seams.size()));
  if (seams.empty()) return;
  std::list<MipLevel> levels;  // equalisers have spans of them
  std::list<Equaliser> equalisers;
  for (unsigned k = 0; k < options.levels; ++k) {
    const MipLevel& level = levels.emplace_back(charts, channels, seams, frames, k);
    SeamOptions of_level = options;
    if (k > 0) of_level.fidelity = options.mip_fidelity;
    equalisers.emplace_back(level.images(), channels, level.seams(), level.frames(), of_level);
  }
  // What one level needs changes the others a little, so each has several turns. The first level has the last word.
  const int cycles = options.levels > 1 ? 3 : 1;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const bool is_last = cycle + 1 == cycles;
    auto equaliser = equalisers.rbegin();
    for (auto level = levels.rbegin(); level != levels.rend(); ++level, ++equaliser) {
      const bool is_first = std::next(level) == levels.rend();
      level->restrict_from(charts);
      constexpr int rounds = 2, last_rounds = 6;
      equaliser->equalise_normals(is_first && is_last ? last_rounds : rounds, is_first);
      for (unsigned c = frames.empty() ? 0 : normal_channels; c < channels; ++c)
        if (c != options.first_level_channel || (is_first && is_last)) equaliser->equalise(c);
      level->add_changes_to(charts);
    }
  }
}

}  // namespace glark::maps
