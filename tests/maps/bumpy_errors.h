// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The errors of a model that was baked from the sphere with bumps.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/maps/bumpy_sphere.h"
#include "tests/maps/seen_model.h"

namespace glark::maps::test {

struct Errors {
  double distance = 0, degrees = 0, colour = 0;  // the greatest ones
  double degrees_squared = 0;                    // the mean
};

// Random places of the model against the known surface.
inline Errors errors_of(const Baked& model) {
  constexpr int places = 20000;
  const SeenModel seen_model(model);
  std::mt19937 random(7);
  std::exponential_distribution<double> part;
  std::uniform_int_distribution<std::size_t> triangle(0, model.triangles.size() / 3 - 1);
  Errors errors;
  for (int i = 0; i < places; ++i) {
    std::array<double, 3> weights{part(random), part(random), part(random)};
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& w : weights) w /= sum;
    const Seen seen = seen_model.at(triangle(random), weights);
    const Precise direction = common::unit(seen.position);
    errors.distance = std::max(errors.distance, common::length(seen.position - bumpy_point(direction)));
    const double cosine = std::clamp(common::dot(seen.normal, bumpy_normal(direction)), -1.0, 1.0);
    const double degrees = std::acos(cosine) * 180 / std::numbers::pi;
    errors.degrees = std::max(errors.degrees, degrees);
    errors.degrees_squared += degrees * degrees / places;
    for (std::size_t k = 0; k < 3; ++k)
      errors.colour = std::max(errors.colour, std::abs(seen.colour[k] - bumpy_colour(direction).at(k)));
  }
  return errors;
}

}  // namespace glark::maps::test
