// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/paint.h"

#include <cmath>

#include "glark/clients/edit/brush/ball.h"

namespace glark::edit {

Colour mixed(const Colour& from, const Colour& to, double strength) {
  Colour result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround(from[k] + strength * (to[k] - from[k])));
  return result;
}

// The mirrored paint has the same colour. So a sample that lies in both balls is painted once.
Colouring colouring_of(std::span<const Paint> paints, const Samples& now) {
  Colouring colouring;
  for (const Paint& paint : paints) {
    const InBall inside = samples_in(paint.ball, now);
    colouring.samples.insert(colouring.samples.end(), inside.samples.begin(), inside.samples.end());
  }
  std::vector<std::uint32_t>& samples = colouring.samples;
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  for (const std::uint32_t i : samples)
    colouring.colours.push_back(mixed(now.colour(i), paints[0].colour, paints[0].strength));
  return colouring;
}

}  // namespace glark::edit
