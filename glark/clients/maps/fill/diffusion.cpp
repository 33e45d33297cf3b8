// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: T. Boubekeur, Hierarchical Processing, Editing and Rendering of Acquired Geometry, 2007, ch. 6.2.4:
// multigrid without smoothing on the way down, which sums up samples only, and with smoothing on the way up. There, the
// finest level is smoothed until it converges, which takes very many sweeps in large holes. Here, further cycles solve
// for the residual (P. Wesseling, An Introduction to Multigrid Methods, 1992, ch. 8: sawtooth cycles).
#include "glark/clients/maps/fill/diffusion.h"

#include <algorithm>
#include <cassert>

#include "glark/clients/maps/fill/finest_level.h"

namespace glark::maps {
namespace {

constexpr int finest_sweeps = 2;
// Multigrid stops if `cycles_to_judge` cycles have not halved the change: it converges too slowly, or not at all.
constexpr unsigned cycles_to_judge = 6;
constexpr float slow = 0.5F;             // relative to the change `cycles_to_judge` cycles ago
constexpr float part_of_a_step = 0.02F;  // of what conjugate gradients have still to change

struct Cycles {
  unsigned iterations = 0;
  bool has_converged = true;
};

// Fills the channels from `first` on. The lists and levels are made.
template <unsigned channels>
Cycles fill_channels(const Raster& raster, unsigned first, const DiffusionOptions& options, const TexelLists& lists,
                     CoarseLevels& levels) {
  constexpr unsigned blocks = blocks_of(channels);
  FinestLevel<channels> finest(raster.values.data() + first, raster.channels, lists, raster.weights);
  Cycles done;
  finest.fill_single();
  if (lists.inner.empty() && lists.border.empty()) return done;
  finest.find_range();
  const auto begin = [&] {
    levels.clear_right_sides<blocks>();
    finest.restrict_samples(levels.first());
    levels.solve<blocks>(Solution::values);
    finest.set(levels.first());
    for (int sweep = 0; sweep < finest_sweeps; ++sweep) finest.smooth();
  };
  begin();
  done.has_converged = false;
  std::vector<float> changes;
  bool is_slow = false;
  for (done.iterations = 1; done.iterations < options.max_iterations && !done.has_converged && !is_slow;
       ++done.iterations) {
    levels.clear_right_sides<blocks>();
    finest.restrict_residuals(levels.first());
    levels.solve<blocks>(Solution::correction);
    float change = finest.correct(levels.first());
    for (int sweep = 1; sweep < finest_sweeps; ++sweep) finest.smooth();
    change = std::max(change, finest.smooth_and_measure());
    done.has_converged = change <= options.tolerance;
    is_slow = changes.size() >= cycles_to_judge && change > slow * changes[changes.size() - cycles_to_judge];
    changes.push_back(change);
  }
  if (!done.has_converged) begin();  // the cycles may have made the values worse
  return done;
}

using FillChannels = Cycles (*)(const Raster&, unsigned, const DiffusionOptions&, const TexelLists&, CoarseLevels&);
constexpr FillChannels fill_functions[most_channels_at_once] = {fill_channels<1>, fill_channels<2>, fill_channels<3>,
                                                                fill_channels<4>, fill_channels<5>, fill_channels<6>,
                                                                fill_channels<7>, fill_channels<8>};

}  // namespace

Diffusion Diffuser::fill(const Raster& raster, const DiffusionOptions& options) {
  const std::size_t texels = std::size_t{raster.width} * raster.height;
  assert(texels > 0 && texels < no_cell && raster.channels > 0);
  assert(raster.values.size() == texels * raster.channels && raster.weights.size() == texels);
  lists_.build(raster.width, raster.height, raster.weights);
  if (lists_.known == 0) std::fill(raster.values.begin(), raster.values.end(), 0.0F);
  Diffusion all;
  if (lists_.known == 0 || lists_.known == texels) return all;
  all.filled = texels - lists_.known;
  if (!lists_.inner.empty() || !lists_.border.empty()) {
    levels_.build(lists_.map);
    const std::vector<std::uint32_t>& numbers = levels_.first().numbers;
    for (ListedTexel& texel : lists_.inner) texel.child = 4 * numbers[texel.child / 4] + texel.child % 4;
    for (BorderTexel& texel : lists_.border) texel.child = 4 * numbers[texel.child / 4] + texel.child % 4;
  }
  for (unsigned first = 0; first < raster.channels; first += most_channels_at_once) {
    const unsigned count = std::min(raster.channels - first, most_channels_at_once);
    const Cycles part = fill_functions[count - 1](raster, first, options, lists_, levels_);
    all.iterations = std::max(all.iterations, part.iterations);
    for (unsigned channel = 0; channel < count && !part.has_converged; channel += 4)
      all.gradient_steps = std::max(
          all.gradient_steps, gradients_.improve(raster, first + channel, lists_, part_of_a_step * options.tolerance));
  }
  return all;
}

Diffusion diffuse(const Raster& raster, const DiffusionOptions& options) { return Diffuser().fill(raster, options); }

}  // namespace glark::maps
