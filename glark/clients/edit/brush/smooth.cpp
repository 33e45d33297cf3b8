// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/ball.h"
#include "glark/clients/edit/brush/motion.h"

namespace glark::edit {
namespace {

constexpr int steps = 4;
// Half of the way to the mean: no step can make the sum of the squared edges greater.
constexpr double most_of_the_way = 0.5;

}  // namespace

// Moving along the normals alone keeps a plane with its boundary as it is, and the distances of the samples.
Motion motion_of(std::span<const Smooth> smooths, const Shape& shape) {
  std::vector<double> weights(shape.size());
  for (const Smooth& smooth : smooths) {
    const InBall inside = samples_in(smooth.ball, shape.now);
    for (std::size_t k = 0; k < inside.samples.size(); ++k)
      weights[inside.samples[k]] = std::max(weights[inside.samples[k]], smooth.strength * inside.weights[k]);
  }
  Motion motion;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0 && !shape.graph.of(i).empty()) motion.samples.push_back(static_cast<std::uint32_t>(i));
  motion.positions.resize(motion.samples.size());
  Samples moved;
  moved.positions = shape.now.positions;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t k = 0; k < motion.samples.size(); ++k) {
      const std::uint32_t i = motion.samples[k];
      const std::span<const std::uint32_t> neighbours = shape.graph.of(i);
      const Vector3d p = moved.position(i);
      Vector3d sum;
      for (const std::uint32_t j : neighbours) sum += moved.position(j) - p;
      const Vector3f normal = shape.now.normal(i);
      const Vector3d n{normal.x, normal.y, normal.z};
      const double way = most_of_the_way * weights[i] / static_cast<double>(neighbours.size());
      motion.positions[k] = p + n * (way * common::dot(sum, n));
    }
    for (std::size_t k = 0; k < motion.samples.size(); ++k) moved.set_position(motion.samples[k], motion.positions[k]);
  }
  return motion;
}

}  // namespace glark::edit
