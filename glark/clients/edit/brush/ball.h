// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples of a brush.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

// Returns the weight of a brush. `distance` is relative to the radius. The weight falls from 1 at the centre to 0 at
// the radius, where its slope is 0, too.
constexpr double falloff(double distance) {
  const double rest = 1 - distance * distance;
  return rest > 0 ? rest * rest : 0;
}

struct InBall {
  std::vector<std::uint32_t> samples;  // in ascending order
  std::vector<double> weights;         // their falloff
};

// All samples are looked at, which takes less time than a tree over positions that change would.
inline InBall samples_in(const Ball& ball, const Samples& now) {
  InBall found;
  const Vector3d centre = common::to_vector(ball.centre);
  const double most = ball.radius * ball.radius;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double square = common::squared_distance(now.position(i), centre);
    if (!(square <= most)) continue;
    found.samples.push_back(static_cast<std::uint32_t>(i));
    found.weights.push_back(falloff(std::sqrt(square / most)));
  }
  return found;
}

}  // namespace glark::edit
