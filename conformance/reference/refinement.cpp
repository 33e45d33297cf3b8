// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/reference/refinement.h"

#include <algorithm>

namespace glark::conformance::reference {
namespace {

struct ScalarTags {
  double sharpness;
  double tension;
  double bias;
};

double clamped(float value, double low, double high) {
  return std::isnan(value) ? 0 : std::clamp(static_cast<double>(value), low, high);
}

ScalarTags tags_of(const Corner& corner) {
  return {clamped(corner.tags[0], 0, 65536), clamped(corner.tags[1], -1, 1), clamped(corner.tags[2], -1, 1)};
}

bool is_tagged(const Corner& corner) {
  const Vector d = vector_of(corner.discontinuity);
  return dot(d, d) > 0 && dot(d, d) < 1e12;  // false for not-a-number
}

bool is_sharp(const Corner& i, const Corner& j) {
  const float a = i.discontinuity[3];
  const float b = j.discontinuity[3];
  return is_tagged(i) && is_tagged(j) && (a == b || a == 0 || b == 0);
}

Vector unit_normal(const Corner& corner) { return direction(vector_of(corner.normal)); }

// l_ij of (11.R.5).
double side_of_edge(const Corner& i, const Corner& j) {
  const Vector d = direction(vector_of(j.position) - vector_of(i.position));
  const Vector m = is_tagged(j) ? Vector{} : unit_normal(j);
  return dot(d, vector_of(i.discontinuity)) * dot(d, unit_normal(i) + m);
}

// The direction of N_i + s_i D_i if `side` is negative, of N_i - s_i D_i if it is positive.
Vector normal_on_side(const Corner& i, double side) {
  const Vector jump = tags_of(i).sharpness * vector_of(i.discontinuity);
  if (side < 0) return direction(unit_normal(i) + jump);
  if (side > 0) return direction(unit_normal(i) - jump);
  return unit_normal(i);
}

// (P_j - P_i) . n, for an edge that no other rule makes straight.
double height(const Corner& i, const Corner& j, const Vector& n) {
  return i.position[3] == j.position[3] ? dot(vector_of(j.position) - vector_of(i.position), n) : 0;
}

bool same_place(const Corner& i, const Corner& j) { return length(vector_of(j.position) - vector_of(i.position)) == 0; }

// Weights that make a triangle with coinciding corners cover nothing.
Vec3 collapsed(const Corners& corners, const Vec3& weights) {
  if (same_place(corners[0], corners[1]) && same_place(corners[1], corners[2])) return {1, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (!same_place(corners[i], corners[j])) continue;
    Vec3 sum = weights;
    sum[j] += sum[i];
    sum[i] = 0;
    return sum;
  }
  return weights;
}

double k(double s, double t) { return ((3 * s) * s) * t; }

Vector plane_normal(const Corners& c) {
  const Vector p = vector_of(c[0].position);
  const Vector f = cross(vector_of(c[1].position) - p, vector_of(c[2].position) - p);
  const Vector sum = unit_normal(c[0]) + unit_normal(c[1]) + unit_normal(c[2]);
  return dot(f, sum) < 0 ? -1.0 * f : f;
}

// Negative if the triangle is on the side of N+ at corner i.
double side_of_triangle(const Corners& corners, std::size_t i) {
  double sum = 0;
  bool is_all_sharp = true;
  for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) {
    if (is_sharp(corners[i], corners[j])) continue;
    is_all_sharp = false;
    sum += side_of_edge(corners[i], corners[j]);
  }
  if (!is_all_sharp && sum != 0) return sum;
  return -dot(vector_of(corners[i].discontinuity), plane_normal(corners));
}

template <typename ControlPoint>
ControlPoints control_points(const Corners& corners, ControlPoint control_point) {
  ControlPoints b;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j) b[i][j] = control_point(corners[i], corners[j]);
  return b;
}

Vector edge_normal(const Corner& i, const Corner& j, const Vector& ni, const Vector& nj) {
  const Vector d = vector_of(j.position) - vector_of(i.position);
  const Vector sum = ni + nj;
  const double fraction = dot(d, d) > 0 ? 2 * dot(d, sum) / dot(d, d) : 0;
  return direction(sum - fraction * d);
}

}  // namespace

float refined(const Vec3& weights, float a0, float a1, float a2) {
  // volatile prevents contraction.
  volatile const float first = weights[0] * a0;
  volatile const float second = weights[1] * a1;
  volatile const float third = weights[2] * a2;
  volatile const float sum = first + second;
  return sum + third;
}

Vector curved_control_point(const Corner& i, const Corner& j) {
  const Vector pi = vector_of(i.position);
  const Vector pj = vector_of(j.position);
  const Vector n = unit_normal(i);
  return (2 * pi + pj - height(i, j, n) * n) / 3;
}

Vector tagged_control_point(const Corner& i, const Corner& j) {
  const Vector pi = vector_of(i.position);
  const Vector pj = vector_of(j.position);
  const ScalarTags tags = tags_of(i);
  Vector m = unit_normal(i);
  Vector l = m;
  if (is_sharp(i, j)) {
    l = direction(m + tags.bias * vector_of(i.discontinuity));
  } else if (is_tagged(i)) {
    const double s = std::min(tags.sharpness, 1.0);
    m = direction((1 - s) * m + s * normal_on_side(i, side_of_edge(i, j)));
    l = m;
  }
  const double t = tags.tension;
  return ((2 + t) * pi + (1 - t) * pj - ((1 - t) * height(i, j, m)) * l) / 3;
}

Vector welded_control_point(const Corner& i, const Corner& j, const Vec3& other) {
  const Vector pi = vector_of(i.position);
  const Vector pj = vector_of(j.position);
  const Vector n = unit_normal(i);
  const Vector m = direction(vector_of(other));
  const Vector s = n + m;
  const Vector r = n - m;
  const Vector d = pj - pi;
  const double c = 0.12;
  return (2 * pi + pj - (dot(d, s) / std::max(dot(s, s), c)) * s - (dot(d, r) / std::max(dot(r, r), c)) * r) / 3;
}

ControlPoints curved_control_points(const Corners& corners) { return control_points(corners, curved_control_point); }
ControlPoints tagged_control_points(const Corners& corners) { return control_points(corners, tagged_control_point); }

Vector patch_position(const Corners& corners, const ControlPoints& b, const Vec3& weights) {
  const Vector p0 = vector_of(corners[0].position);
  const Vector p1 = vector_of(corners[1].position);
  const Vector p2 = vector_of(corners[2].position);
  const Vec3 used = collapsed(corners, weights);
  const double w = used[0];
  const double u = used[1];
  const double v = used[2];
  const Vector mean = (b[0][1] + b[1][0] + b[1][2] + b[2][1] + b[2][0] + b[0][2]) / 6;
  const Vector centre = mean + (mean - (p0 + p1 + p2) / 3) / 2;
  return w * w * w * p0 + u * u * u * p1 + v * v * v * p2 + k(w, u) * b[0][1] + k(u, w) * b[1][0] + k(u, v) * b[1][2] +
         k(v, u) * b[2][1] + k(v, w) * b[2][0] + k(w, v) * b[0][2] + (6 * w * u * v) * centre;
}

Vector patch_normal(const Corners& corners, const std::array<Vector, 3>& normals, const Vec3& weights) {
  const double w = weights[0];
  const double u = weights[1];
  const double v = weights[2];
  const Vector n01 = edge_normal(corners[0], corners[1], normals[0], normals[1]);
  const Vector n12 = edge_normal(corners[1], corners[2], normals[1], normals[2]);
  const Vector n20 = edge_normal(corners[2], corners[0], normals[2], normals[0]);
  const Vector n =
      w * w * normals[0] + u * u * normals[1] + v * v * normals[2] + (w * u) * n01 + (u * v) * n12 + (v * w) * n20;
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) lengths[i] = length(vector_of(corners[i].normal));
  if (length(n) < 1e-12) return w * lengths[0] * normals[0] + u * lengths[1] * normals[1] + v * lengths[2] * normals[2];
  return (w * lengths[0] + u * lengths[1] + v * lengths[2]) * direction(n);
}

std::array<Vector, 3> tagged_normals(const Corners& corners) {
  std::array<Vector, 3> normals;
  for (std::size_t i = 0; i < 3; ++i)
    normals[i] =
        is_tagged(corners[i]) ? normal_on_side(corners[i], side_of_triangle(corners, i)) : unit_normal(corners[i]);
  return normals;
}

Vector phong_position(const Corners& corners, const ControlPoints& b, const Vec3& weights, double shape) {
  const auto p = [&](std::size_t i) { return vector_of(corners[i].position); };
  const auto q = [&](std::size_t i, std::size_t j) { return 3 * b[i][j] - 2 * p(i); };
  const Vec3 used = collapsed(corners, weights);
  const double w = used[0];
  const double u = used[1];
  const double v = used[2];
  const Vector flat = w * p(0) + u * p(1) + v * p(2);
  const Vector bent = w * w * p(0) + u * u * p(1) + v * v * p(2) + (w * u) * (q(0, 1) + q(1, 0)) +
                      (u * v) * (q(1, 2) + q(2, 1)) + (v * w) * (q(2, 0) + q(0, 2));
  return (1 - shape) * flat + shape * bent;
}

Surface curved_pn(const Corners& corners, const Vec3& weights) {
  return {patch_position(corners, curved_control_points(corners), weights),
          patch_normal(corners, {unit_normal(corners[0]), unit_normal(corners[1]), unit_normal(corners[2])}, weights)};
}

Surface scalar_tagged_pn(const Corners& corners, const Vec3& weights) {
  return {patch_position(corners, tagged_control_points(corners), weights),
          patch_normal(corners, tagged_normals(corners), weights)};
}

Surface phong(const Corners& corners, const Vec3& weights, double shape) {
  Vector normal;
  for (std::size_t i = 0; i < 3; ++i) normal = normal + static_cast<double>(weights[i]) * vector_of(corners[i].normal);
  return {phong_position(corners, curved_control_points(corners), weights, shape), normal};
}

}  // namespace glark::conformance::reference
