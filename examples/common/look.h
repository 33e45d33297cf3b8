// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where the eye is. Dragging the mouse turns the view.
#pragma once

#include <array>
#include <functional>

namespace lesson {

// Column by column, as OpenGL takes it.
using Matrix = std::array<float, 16>;

struct Camera {
  Matrix projection;
  Matrix view;
};

// Draws into one of several equal parts, side by side. Part 0 is on the left. Call it before camera() or look().
void use_part(int part, int parts);

// The eye looks at the origin from `distance`. The model turns about its vertical axis, then tilts towards the eye.
// Both angles are in degrees.
Camera camera(float distance, float turn = 0, float tilt = 0);

// The product: first b, then a.
Matrix multiply(const Matrix& a, const Matrix& b);

// For the fixed function: loads camera() into the two matrix stacks.
void look(float distance, float turn = 0, float tilt = 0);

// For the fixed function: one white light over the left shoulder, and a material that takes glColor.
void light();

// Draws the surface, then the edges of its triangles darker over it. Not for OpenGL ES.
void draw_with_edges(const std::function<void()>& draw);

}  // namespace lesson
