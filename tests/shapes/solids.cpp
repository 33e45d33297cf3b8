// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/shapes/solids.h"

#include <algorithm>
#include <cmath>

namespace glark::shapes {
namespace {

constexpr double blend = 0.06;  // limbs are joined smoothly over this distance

Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

}  // namespace

Statue::Statue(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto near = [&](double x, double y, double z) {
    return Point{x + 0.08 * number(random), y + 0.08 * number(random), z + 0.08 * number(random)};
  };
  const Point hips = near(0, 0, 0.9), chest = near(0, 0, 1.35), neck = near(0, 0, 1.62), head = near(0.02, 0, 1.8);
  add(hips, chest, 0.19 + 0.02 * number(random));
  add(chest, neck, 0.08);
  add(head, head, 0.14 + 0.02 * number(random));
  for (const double side : {-1.0, 1.0}) {
    const Point shoulder = near(0.02, 0.24 * side, 1.45), elbow = near(0.1, 0.5 * side, 1.2),
                hand = near(0.35, 0.55 * side, 1.15);
    add(chest, shoulder, 0.09);
    add(shoulder, elbow, 0.07);
    add(elbow, hand, 0.05 + 0.01 * number(random));
    const Point knee = near(0.05, 0.16 * side, 0.5), foot = near(0, 0.2 * side, 0.08);
    add(hips, knee, 0.1);
    add(knee, foot, 0.07);
    add(foot, between(foot, {foot[0] + 0.4, foot[1], foot[2] - 0.02}, 0.6), 0.05);
  }
}

void Statue::add(const Point& from, const Point& to, double radius) {
  limbs_.push_back({from, to, radius});
  for (const Point& end : {from, to}) {
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], end[i] - radius - 0.02);
      high_[i] = std::max(high_[i], end[i] + radius + 0.02);
    }
  }
}

// The smooth minimum of the distances from all limbs.
double Statue::distance(const Point& point) const {
  double result = 1e9;
  for (const Limb& limb : limbs_) {
    const Point along{limb.to[0] - limb.from[0], limb.to[1] - limb.from[1], limb.to[2] - limb.from[2]};
    const Point from{point[0] - limb.from[0], point[1] - limb.from[1], point[2] - limb.from[2]};
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0;
    const double one = apart(point, between(limb.from, limb.to, t)) - limb.radius;
    const double h = std::max(blend - std::abs(result - one), 0.0) / blend;
    result = std::min(result, one) - h * h * blend / 4;
  }
  return result;
}

Point Statue::normal(const Point& point) const {
  constexpr double step = 1e-5;
  Point gradient{};
  for (std::size_t i = 0; i < 3; ++i) {
    Point more = point, less = point;
    more[i] += step;
    less[i] -= step;
    gradient[i] = distance(more) - distance(less);
  }
  const double length = std::sqrt(dot(gradient, gradient));
  for (double& part : gradient) part /= length;
  return gradient;
}

Point Statue::on_surface(Point point) const {
  for (int round = 0; round < 3; ++round) {
    const double off = distance(point);
    const Point direction = normal(point);
    for (std::size_t i = 0; i < 3; ++i) point[i] -= off * direction[i];
  }
  return point;
}

double Statue::diagonal() const { return apart(low_, high_); }

}  // namespace glark::shapes
