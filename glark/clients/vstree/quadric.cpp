// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/quadric.h"

#include <algorithm>

namespace glark::vstree {

float Quadric::error_at(Float4 point) const {
  point[3] = 1;
  const Float4 gradient{dot(rows[0], point) + rows[0][3], dot(rows[1], point) + rows[1][3],
                        dot(rows[2], point) + rows[2][3], 0};
  const float linear = rows[0][3] * point[0] + rows[1][3] * point[1] + rows[2][3] * point[2];
  return std::max(0.0F, dot(gradient, point) + linear + constant);
}

Quadric Quadric::moved(Float4 by) const {
  Quadric result = *this;
  by[3] = 0;
  const float open[3] = {dot(rows[0], by), dot(rows[1], by), dot(rows[2], by)};
  const Float4 offset{rows[0][3], rows[1][3], rows[2][3], 0};
  for (int i = 0; i < 3; ++i) result.rows[i][3] += open[i];
  result.constant += 2 * dot(offset, by) + dot(Float4{open[0], open[1], open[2], 0}, by);
  return result;
}

// Planes may leave some directions open. A small multiple of the identity keeps the point near the origin in these
// directions. The alternative, a pseudo-inverse, needs a threshold and takes ten times as long (P. Lindstrom,
// Out-of-Core Simplification of Large Polygonal Models, 2000, section 3.2).
Float4 Quadric::best_point() const {
  const double hold = 1e-4 * double{weight()};
  if (!(hold > 0)) return Float4{};
  const double xx = rows[0][0] + hold, yy = rows[1][1] + hold, zz = rows[2][2] + hold;
  const double xy = rows[0][1], xz = rows[0][2], yz = rows[1][2];
  const double bx = rows[0][3], by = rows[1][3], bz = rows[2][3];
  const double c_xx = yy * zz - yz * yz, c_xy = xz * yz - xy * zz, c_xz = xy * yz - xz * yy;
  const double c_yy = xx * zz - xz * xz, c_yz = xy * xz - xx * yz, c_zz = xx * yy - xy * xy;
  const double scale = -1 / (xx * c_xx + xy * c_xy + xz * c_xz);
  return Float4{static_cast<float>(scale * (c_xx * bx + c_xy * by + c_xz * bz)),
                static_cast<float>(scale * (c_xy * bx + c_yy * by + c_yz * bz)),
                static_cast<float>(scale * (c_xz * bx + c_yz * by + c_zz * bz)), 0};
}

float best_point_error(std::span<const Record> records, const Moments& moments) {
  if (!(moments.normals[3] > 0)) return moments.plane_error();
  const Float4 origin = without_fourth(moments.mean);
  Quadric quadric;
  for (const Record& record : records) quadric.add_plane(record.point() - origin, record.normal, record.normal[3]);
  return quadric.error_at(quadric.best_point()) / moments.normals[3];
}

}  // namespace glark::vstree
