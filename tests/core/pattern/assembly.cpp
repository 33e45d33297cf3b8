// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/core/pattern/assembly.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace glark::pattern::testing {
namespace {

// All coordinates of all tiles down to 2^-5 are multiples of 2^-20.
constexpr std::int64_t lattice_shift = 5;

Point place(LatticeVertex vertex, const Instance& instance) {
  std::int64_t local[3] = {lattice_one - vertex.u - vertex.v, vertex.u, vertex.v};
  std::int64_t tile[3];
  for (int k = 0; k < 3; ++k) tile[(k + static_cast<int>(instance.r)) % 3] = local[k];
  auto scale = static_cast<std::int64_t>(std::ldexp(instance.s, lattice_shift));
  return {static_cast<std::int64_t>(std::ldexp(instance.ou, 20)) + scale * tile[1],
          static_cast<std::int64_t>(std::ldexp(instance.ov, 20)) + scale * tile[2]};
}

// Computes as the vertex shader does.
bool float_agrees(LatticeVertex vertex, const Instance& instance, Point exact) {
  float lu = static_cast<float>(vertex.u) * 0x1p-15f;
  float lv = static_cast<float>(vertex.v) * 0x1p-15f;
  float local[3] = {1.0f - lu - lv, lu, lv};
  float tile[3];
  for (int k = 0; k < 3; ++k) tile[(k + static_cast<int>(instance.r)) % 3] = local[k];
  float u = instance.ou + instance.s * tile[1];
  float v = instance.ov + instance.s * tile[2];
  float w = 1.0f - u - v;
  return u == std::ldexp(static_cast<double>(exact.u), -20) && v == std::ldexp(static_cast<double>(exact.v), -20) &&
         w == std::ldexp(static_cast<double>(whole - exact.u - exact.v), -20) && w + u + v == 1.0f && u + v + w == 1.0f;
}

std::int64_t doubled_area(const Triangle& t) {
  return (t[1].u - t[0].u) * (t[2].v - t[0].v) - (t[2].u - t[0].u) * (t[1].v - t[0].v);
}

std::string text(Point p) {
  std::ostringstream out;
  out << '(' << p.u << ", " << p.v << ")/2^20";
  return out.str();
}

// Returns the edge of the whole triangle on which both points lie, and their places along it; -1 if there is none.
int common_edge(Point a, Point b, std::int64_t along[2]) {
  if (a.v == 0 && b.v == 0) return along[0] = a.u, along[1] = b.u, 0;
  if (a.u + a.v == whole && b.u + b.v == whole) return along[0] = a.v, along[1] = b.v, 1;
  if (a.u == 0 && b.u == 0) return along[0] = whole - a.v, along[1] = whole - b.v, 2;
  return -1;
}

struct Side {
  Point low, high;
  bool reversed;
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  auto key = [](Point p) { return (p.u << 32) | p.v; };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      Point a = t[k];
      Point b = t[(k + 1) % 3];
      bool reversed = key(b) < key(a);
      sides.push_back(reversed ? Side{b, a, true} : Side{a, b, false});
    }
  }
  std::sort(sides.begin(), sides.end(), [&](const Side& x, const Side& y) {
    return key(x.low) != key(y.low) ? key(x.low) < key(y.low) : key(x.high) < key(y.high);
  });
  return sides;
}

std::string defect_of_areas(const std::vector<Triangle>& triangles) {
  std::int64_t sum = 0;
  for (const Triangle& t : triangles) {
    for (Point p : t) {
      if (p.u < 0 || p.v < 0 || p.u + p.v > whole) return "outside: " + text(p);
    }
    if (doubled_area(t) <= 0) return "area not positive at " + text(t[0]) + text(t[1]) + text(t[2]);
    sum += doubled_area(t);
  }
  return sum == whole * whole ? "" : "sum of areas " + std::to_string(sum);
}

// Checks a side that only one triangle has: it must be one of the 2^depth equal segments of an edge.
std::string defect_of_border_side(const Side& side, std::array<int, 3> depths, std::array<int, 3>& segments) {
  std::int64_t along[2];
  int edge = common_edge(side.low, side.high, along);
  if (edge < 0) return "open inner edge " + text(side.low) + text(side.high);
  auto k = static_cast<std::size_t>(edge);
  std::int64_t length = whole >> depths[k];
  ++segments[k];
  std::int64_t run = side.reversed ? along[0] - along[1] : along[1] - along[0];
  if (run != length || along[0] % length != 0)
    return "wrong segment on edge " + std::to_string(edge) + " at " + text(side.low);
  return "";
}

}  // namespace

Assembly assemble(const Pool& pool, const std::vector<Instance>& instances) {
  Assembly assembly;
  for (const Instance& instance : instances) {
    const Piece& piece = pool.pieces[static_cast<std::size_t>(instance.piece)];
    std::vector<Point> points;
    for (std::size_t k = 0; k < piece.index_count; ++k) {
      LatticeVertex vertex = pool.vertices[piece.base_vertex + pool.indices[piece.first_index + k]];
      points.push_back(place(vertex, instance));
      assembly.floats_exact = assembly.floats_exact && float_agrees(vertex, instance, points.back());
    }
    for (std::size_t k = 0; k < points.size(); k += 3)
      assembly.triangles.push_back({points[k], points[k + 1], points[k + 2]});
  }
  return assembly;
}

std::string defect_of(const Assembly& assembly, std::array<int, 3> depths) {
  if (std::string defect = defect_of_areas(assembly.triangles); !defect.empty()) return defect;
  std::array<int, 3> segments{};
  std::vector<Side> sides = sorted_sides(assembly.triangles);
  for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
    const Side& side = sides[first];
    while (next < sides.size() && sides[next].low == side.low && sides[next].high == side.high) ++next;
    if (next - first == 1) {
      if (std::string defect = defect_of_border_side(side, depths, segments); !defect.empty()) return defect;
    } else if (next - first != 2 || side.reversed == sides[first + 1].reversed) {
      return "edge not shared by two opposite triangles: " + text(side.low) + text(side.high);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (segments[k] != 1 << depths[k])
      return "edge " + std::to_string(k) + " has " + std::to_string(segments[k]) + " segments";
  }
  return assembly.floats_exact ? "" : "the float patch formula is not exact";
}

double least_angle(const Assembly& assembly) {
  double least = 180.0;
  for (const Triangle& t : assembly.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      auto x = [&](std::size_t n) { return static_cast<double>(t[n % 3].u) + static_cast<double>(t[n % 3].v) / 2; };
      auto y = [&](std::size_t n) { return static_cast<double>(t[n % 3].v) * std::numbers::sqrt3 / 2; };
      double ax = x(k + 1) - x(k), ay = y(k + 1) - y(k), bx = x(k + 2) - x(k), by = y(k + 2) - y(k);
      least = std::min(least, std::atan2(ax * by - ay * bx, ax * bx + ay * by) * 180.0 / std::numbers::pi);
    }
  }
  return least;
}

}  // namespace glark::pattern::testing
