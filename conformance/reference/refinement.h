// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined vertices as sections 11.R.6, 11.R.7, 11.R.7a, 11.R.7c and 11.R.15 define them. Written from the text alone,
// with its names.
#pragma once

#include <array>

#include "conformance/reference/vector.h"

namespace glark::conformance::reference {

using Vec3 = std::array<float, 3>;
using Vec4 = std::array<float, 4>;

// (11.R.1) in single precision, with every operation rounded separately, for comparison by bits.
float refined(const Vec3& weights, float a0, float a1, float a2);

struct Corner {
  Vec4 position = {0, 0, 0, 1};
  Vec3 normal = {0, 0, 0};
  Vec4 discontinuity = {0, 0, 0, 1};  // D_i and the number of the crease
  Vec3 tags = {0, 0, 0};              // sharpness, tension, bias
};
using Corners = std::array<Corner, 3>;

struct Surface {
  Vector position;
  Vector normal;
};

// b_ij for i != j.
using ControlPoints = std::array<std::array<Vector, 3>, 3>;

// (11.R.2).
Vector curved_control_point(const Corner& i, const Corner& j);
ControlPoints curved_control_points(const Corners& corners);
// (11.R.6).
Vector tagged_control_point(const Corner& i, const Corner& j);
ControlPoints tagged_control_points(const Corners& corners);
// (11.R.9). `other` is the normal of another side of the edge at corner i.
Vector welded_control_point(const Corner& i, const Corner& j, const Vec3& other);

// (11.R.3).
Vector patch_position(const Corners& corners, const ControlPoints& b, const Vec3& weights);
// (11.R.4), with the normals that 11.R.7 or 11.R.7a give the corners.
Vector patch_normal(const Corners& corners, const std::array<Vector, 3>& normals, const Vec3& weights);
// N_i, N_i + s_i D_i or N_i - s_i D_i, depending on the triangle's side.
std::array<Vector, 3> tagged_normals(const Corners& corners);

// (11.R.10) with these control points; `shape` is PHONG_SHAPE_ARK.
Vector phong_position(const Corners& corners, const ControlPoints& b, const Vec3& weights, double shape);

Surface curved_pn(const Corners& corners, const Vec3& weights);
Surface scalar_tagged_pn(const Corners& corners, const Vec3& weights);
Surface phong(const Corners& corners, const Vec3& weights, double shape);

}  // namespace glark::conformance::reference
