// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/edit/brush.h"

#include <algorithm>

namespace glark::tool {
namespace {

constexpr double greatest_step = 0.25;  // of the radius, that inflate moves by
constexpr double free_part = 3;         // of the radius: what a deformation may bend around its handle

std::uint8_t byte_of(float fraction) {
  return static_cast<std::uint8_t>(255 * std::clamp(fraction, 0.0F, 1.0F) + 0.5F);
}

}  // namespace

edit::Operation operation_of(const Brush& brush, const edit::Vector& centre, const edit::Vector& by) {
  const edit::Ball ball{centre, static_cast<double>(brush.radius)};
  const auto strength = static_cast<double>(brush.strength);
  switch (brush.tool) {
    case Tool::paint:
      return edit::Paint{ball, {byte_of(brush.colour.x), byte_of(brush.colour.y), byte_of(brush.colour.z)}, strength};
    case Tool::inflate: return edit::Inflate{ball, (brush.inwards ? -1 : 1) * greatest_step * strength * ball.radius};
    case Tool::smooth: return edit::Smooth{ball, strength};
    case Tool::move: return edit::Move{ball, by};
    case Tool::deform: {
      edit::Deform deform;
      deform.handle = ball;
      deform.free = {centre, free_part * ball.radius};
      deform.by = by;
      return deform;
    }
    case Tool::refine: break;
  }
  return edit::Refine{ball, 0};
}

}  // namespace glark::tool
