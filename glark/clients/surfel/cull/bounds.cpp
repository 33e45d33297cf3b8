// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/cull/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glark::surfel {
namespace {

constexpr std::size_t lanes = 8;

// Vectors of several triangles, stored coordinate by coordinate, so that the compiler uses SIMD instructions.
struct Lanes {
  std::array<float, lanes> x, y, z;

  void set(std::size_t i, const Vector& vector) {
    x[i] = vector.x;
    y[i] = vector.y;
    z[i] = vector.z;
  }
  Vector at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

struct Planes {
  Lanes points, normals;  // normals of degenerate triangles are zero
};

struct Boxes {
  Lanes low, high;

  void add(const Lanes& points) {
    for (std::size_t i = 0; i < lanes; ++i) {
      low.set(i, least(low.at(i), points.at(i)));
      high.set(i, greatest(high.at(i), points.at(i)));
    }
  }
  Box box() const {
    Box all;
    for (std::size_t i = 0; i < lanes; ++i) all.add({low.at(i), high.at(i)});
    return all;
  }
};

// The greatest angle between an axis and the planes' normals, and the greatest distance from a centre back to a plane,
// along the axis.
struct ConeFit {
  std::array<float, lanes> squared_cosine, behind;  // the sign of squared_cosine is the sign of the cosine

  void add(const Planes& planes, Vector axis, Vector centre) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vector normal = planes.normals.at(i);
      const float along = dot(normal, axis), squared = dot(normal, normal);
      const float cosine = along * std::fabs(along) / squared;
      const float back = dot(centre - planes.points.at(i), normal) / along;
      const float least = cosine < squared_cosine[i] ? cosine : squared_cosine[i];
      const float farthest = back > behind[i] ? back : behind[i];
      squared_cosine[i] = squared > 0 ? least : squared_cosine[i];
      behind[i] = squared > 0 ? farthest : behind[i];
    }
  }
};

struct LaneTriangles {
  Lanes p, q, r;
};

// Loads at most as many triangles as there are lanes. Unused lanes repeat the last triangle.
LaneTriangles load(const Level& level, std::span<const Triangle> triangles) {
  LaneTriangles loaded;
  for (std::size_t i = 0; i < lanes; ++i) {
    const Triangle& triangle = triangles[std::min(i, triangles.size() - 1)];
    loaded.p.set(i, level.positions[triangle[0]]);
    loaded.q.set(i, level.positions[triangle[1]]);
    loaded.r.set(i, level.positions[triangle[2]]);
  }
  return loaded;
}

// Computes the triangles' planes and extends the box. Returns the sum of the normals, weighted by area.
Vector measure(const Level& level, std::span<const Triangle> triangles, Box& box, std::vector<Planes>& all) {
  Boxes boxes;
  for (std::size_t i = 0; i < lanes; ++i) {
    boxes.low.set(i, box.low);
    boxes.high.set(i, box.high);
  }
  Vector sum;
  all.resize((triangles.size() + lanes - 1) / lanes);
  for (std::size_t first = 0; first < triangles.size(); first += lanes) {
    const std::size_t count = std::min(lanes, triangles.size() - first);
    const auto [p, q, r] = load(level, triangles.subspan(first, count));
    Planes& planes = all[first / lanes];
    planes.points = p;
    std::array<float, lanes> squared;
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vector normal = cross(q.at(i) - p.at(i), r.at(i) - p.at(i));
      planes.normals.set(i, normal);
      squared[i] = dot(normal, normal);
    }
    boxes.add(p);
    boxes.add(q);
    boxes.add(r);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector normal = planes.normals.at(i);
      sum = sum + normal;
      constexpr float small = 1e-28F;  // smaller squares are not accurate
      if (!(squared[i] > small)) planes.normals.set(i, unit(normal));
    }
  }
  box = boxes.box();
  return sum;
}

}  // namespace

// The axis is the mean of the normals, weighted by area. The apex lies behind the planes of all triangles, as near to
// the box as possible.
Bounds compute_bounds(const Level& level, std::span<const Triangle> triangles) {
  thread_local std::vector<Planes> all;
  Bounds bounds;
  bounds.cone_axis = unit(measure(level, triangles, bounds.box, all));
  const Vector centre = bounds.box.centre();
  ConeFit fit;
  fit.squared_cosine.fill(1);
  fit.behind.fill(-Box::far);
  for (const Planes& planes : all) fit.add(planes, bounds.cone_axis, centre);
  const float squared_cosine = *std::min_element(fit.squared_cosine.begin(), fit.squared_cosine.end());
  const float behind = *std::max_element(fit.behind.begin(), fit.behind.end());
  const float margin = cone_margin * length(bounds.box.extent());
  bounds.cone_cosine = std::copysign(std::sqrt(std::fabs(squared_cosine)), squared_cosine);
  // Planes across the axis have no point on it: they are infinitely far behind, and no cone is used then.
  const bool has_apex = behind > -Box::far && bounds.cone_cosine > 2 * cone_margin;
  bounds.cone_apex = has_apex ? centre - bounds.cone_axis * (behind + margin) : centre;
  return bounds;
}

}  // namespace glark::surfel
