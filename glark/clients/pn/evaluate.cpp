// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 8.3; A. Vlachos, J. Peters, C. Boyd, J. L. Mitchell, Curved PN Triangles, I3D 2001. We
// tell a triangle's side of a crease by edges: section 11.R.7a of the extension.
#include <algorithm>

#include "glark/clients/common/vector.h"
#include "glark/pn.h"

namespace glark::pn {
namespace {

using Vector = common::Vector3d;

double within(double value, double least, double most) {
  return std::isnan(value) ? 0 : std::clamp(value, least, most);
}

// A corner in the letters of the thesis: P, N, Delta, sigma, theta, beta.
struct TaggedVertex {
  Vector p, n, delta;
  double size;  // the length of the given normal
  double crease, sigma, theta, beta;
  bool tagged;
};

TaggedVertex read(const Corner& c) {
  TaggedVertex v{};
  v.p = {c.position[0], c.position[1], c.position[2]};
  const Vector normal = {c.normal[0], c.normal[1], c.normal[2]};
  v.n = unit(normal);
  v.size = length(normal);
  v.delta = {c.discontinuity[0], c.discontinuity[1], c.discontinuity[2]};
  v.tagged = dot(v.delta, v.delta) > 0 && dot(v.delta, v.delta) < 1e12;
  v.crease = c.discontinuity[3];
  v.sigma = within(c.tags[0], 0, 65536);
  v.theta = within(c.tags[1], -1, 1);
  v.beta = within(c.tags[2], -1, 1);
  return v;
}

bool sharp(const TaggedVertex& a, const TaggedVertex& b) {
  return a.tagged && b.tagged && (a.crease == b.crease || a.crease == 0 || b.crease == 0);
}

double lean(const TaggedVertex& near, const TaggedVertex& far) {
  if (!near.tagged) return 0;
  const Vector along = unit(far.p - near.p);
  return dot(along, near.delta) * dot(along, far.tagged ? near.n : near.n + far.n);
}

Vector sided(const TaggedVertex& v, double side) {
  if (side == 0 || !v.tagged) return v.n;
  return unit(v.n + (side < 0 ? v.sigma : -v.sigma) * v.delta);
}

// Equation 8.3: the tangent coefficient next to `near` on the edge to `far`.
Vector control(const TaggedVertex& near, const TaggedVertex& far) {
  Vector measured = near.n;
  Vector lifted = near.n;
  if (sharp(near, far)) {
    lifted = unit(near.n + near.beta * near.delta);
  } else if (const double side = lean(near, far); side != 0) {
    const double sigma = std::min(near.sigma, 1.0);
    measured = lifted = unit((1 - sigma) * near.n + sigma * sided(near, side));
  }
  const Vector d = near.p + (1 - near.theta) / 3 * (far.p - near.p);
  return d - dot(d - near.p, measured) * lifted;
}

double triangle_lean(const TaggedVertex& v, const TaggedVertex& next, const TaggedVertex& last, const Vector& up) {
  const double sum = (sharp(v, next) ? 0 : lean(v, next)) + (sharp(v, last) ? 0 : lean(v, last));
  return sum != 0 ? sum : -dot(v.delta, up);
}

Vector edge_normal(const Vector& p, const Vector& n, const Vector& q, const Vector& m) {
  const Vector along = unit(q - p);
  return unit((n + m) - 2 * dot(along, n + m) * along);
}

}  // namespace

Sample evaluate(const std::array<Corner, 3>& corners, const std::array<double, 3>& barycentric) {
  const auto [w, u, v] = barycentric;
  const std::array<TaggedVertex, 3> c = {read(corners[0]), read(corners[1]), read(corners[2])};
  const Vector b01 = control(c[0], c[1]);
  const Vector b10 = control(c[1], c[0]);
  const Vector b12 = control(c[1], c[2]);
  const Vector b21 = control(c[2], c[1]);
  const Vector b20 = control(c[2], c[0]);
  const Vector b02 = control(c[0], c[2]);
  const Vector e = 1.0 / 6 * (b01 + b10 + b12 + b21 + b20 + b02);
  const Vector b111 = 1.5 * e - 1.0 / 6 * (c[0].p + c[1].p + c[2].p);
  const Vector position = w * w * w * c[0].p + u * u * u * c[1].p + v * v * v * c[2].p + 3 * w * w * u * b01 +
                          3 * w * u * u * b10 + 3 * u * u * v * b12 + 3 * u * v * v * b21 + 3 * v * v * w * b20 +
                          3 * v * w * w * b02 + 6 * w * u * v * b111;

  Vector up = cross(c[1].p - c[0].p, c[2].p - c[0].p);
  if (dot(up, c[0].n + c[1].n + c[2].n) < 0) up = -1.0 * up;
  std::array<Vector, 3> n;
  for (std::size_t k = 0; k < 3; ++k) n[k] = sided(c[k], triangle_lean(c[k], c[(k + 1) % 3], c[(k + 2) % 3], up));
  const Vector direction =
      unit(w * w * n[0] + u * u * n[1] + v * v * n[2] + w * u * edge_normal(c[0].p, n[0], c[1].p, n[1]) +
           u * v * edge_normal(c[1].p, n[1], c[2].p, n[2]) + v * w * edge_normal(c[2].p, n[2], c[0].p, n[0]));
  const Vector linear = w * c[0].size * n[0] + u * c[1].size * n[1] + v * c[2].size * n[2];
  const Vector normal = direction == Vector{} ? linear : (w * c[0].size + u * c[1].size + v * c[2].size) * direction;
  return {to_array(position), to_array(normal)};
}

}  // namespace glark::pn
