// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the pointer does to the surface that it touches.
#pragma once

#include <glark/edit.h>

#include <glm/vec3.hpp>
#include <optional>

namespace glark::tool {

enum class Tool { paint, inflate, smooth, move, deform, refine };

struct Brush {
  Tool tool = Tool::inflate;
  float radius = 1;       // in the unit of the positions
  float strength = 0.5F;  // 0 to 1; inflate: a quarter of the radius at 1
  bool inwards = false;   // inflate
  glm::vec3 colour{0.9F, 0.25F, 0.15F};

  // Tools that move a part are applied when the button is released; the others along the way of the pointer.
  bool is_dragged() const { return tool == Tool::move || tool == Tool::deform; }
};

// The operation of a brush that touches the surface at `centre`, dragged by `by`.
edit::Operation operation_of(const Brush& brush, const edit::Vector& centre, const edit::Vector& by);

}  // namespace glark::tool
