// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/ball.h"
#include "glark/clients/edit/brush/motion.h"

namespace glark::edit {
namespace {

// A field over a ball; direction(i) is how sample i moves with the weight 1.
template <class Direction>
Field field_in(const Ball& ball, const Samples& now, const Direction& direction) {
  const InBall inside = samples_in(ball, now);
  Field field;
  for (std::size_t k = 0; k < inside.samples.size(); ++k) {
    if (!(inside.weights[k] > 0)) continue;
    field.samples.push_back(inside.samples[k]);
    field.weights.push_back(inside.weights[k]);
    field.by.push_back(inside.weights[k] * direction(inside.samples[k]));
  }
  return field;
}

}  // namespace

Field field_of(const Inflate& inflate, const Samples& now) {
  return field_in(inflate.ball, now, [&](std::uint32_t i) {
    const Vector3f n = now.normal(i);
    return inflate.amount * Vector3d{n.x, n.y, n.z};
  });
}

Field field_of(const Move& move, const Samples& now) {
  return field_in(move.ball, now, [&](std::uint32_t /*i*/) { return common::to_vector(move.by); });
}

}  // namespace glark::edit
