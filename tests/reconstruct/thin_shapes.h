// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples of thin sheets with two sides. The distance between neighbouring samples of a side is about 1.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "tests/vstree/shapes.h"

namespace glark::reconstruct::test {

// A rotation, as rows.
using Rotation = std::array<std::array<double, 3>, 3>;
inline constexpr Rotation upright{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Rotation random_rotation(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> number;
  std::array<double, 4> q{number(random), number(random), number(random), number(random)};
  const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  for (double& part : q) part /= size;
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

// A sheet over a region of the plane z = 0, between the heights -height(x, y) and height(x, y).
struct ThinSheet {
  double width = 0, depth = 0;  // of the region's bounding rectangle, which begins at 0, 0
  std::function<double(double, double)> height;
  std::function<bool(double, double)> contains = [](double, double) { return true; };
};

// Two parallel squares, `apart` from each other.
inline ThinSheet plates(double side, double apart) {
  return {side, side, [apart](double, double) { return apart / 2; }};
}

inline ThinSheet ellipsoid(double width, double depth, double thickness) {
  const auto square = [=](double x, double y) {
    return std::pow(2 * x / width - 1, 2) + std::pow(2 * y / depth - 1, 2);
  };
  return {width, depth, [=](double x, double y) { return thickness / 2 * std::sqrt(std::max(0.0, 1 - square(x, y))); },
          [=](double x, double y) { return square(x, y) <= 1; }};
}

// The profile is blunt in front (x = 0) and sharp behind. It is thinner towards both tips, where it ends in a point.
inline ThinSheet wing(double chord, double span, double thickness) {
  const auto from_front = [=](double x, double y) {
    const double part = std::sqrt(std::max(0.0, 1 - std::pow(2 * y / span - 1, 2)));
    return part > 0 ? std::max(0.0, x / (chord * part)) : 2;
  };
  return {chord, span,
          [=](double x, double y) {
            const double t = std::min(1.0, from_front(x, y));
            const double part = std::sqrt(std::max(0.0, 1 - std::pow(2 * y / span - 1, 2)));
            return thickness / 2 * part * 2.6 * std::sqrt(t) * (1 - t);
          },
          [=](double x, double y) { return from_front(x, y) <= 1; }};
}

// Samples both sides on a grid of its own each, with samples shifted by at most `shift` along x and y.
inline vstree::test::Shape samples_of(const ThinSheet& sheet, const Rotation& rotation, unsigned seed, double shift) {
  vstree::test::Shape shape;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto add = [&](std::vector<float>& out, double x, double y, double z) {
    for (const auto& row : rotation) out.push_back(static_cast<float>(row[0] * x + row[1] * y + row[2] * z));
  };
  for (const double side : {-1.0, 1.0}) {
    const double begin_x = 0.5 * (1 + number(random)), begin_y = 0.5 * (1 + number(random));
    for (double row = begin_y; row < sheet.depth; ++row) {
      for (double column = begin_x; column < sheet.width; ++column) {
        const double x = column + shift * number(random), y = row + shift * number(random);
        if (x < 0 || y < 0 || x > sheet.width || y > sheet.depth || !sheet.contains(x, y)) continue;
        constexpr double step = 1e-4;
        const auto slope = [&](double dx, double dy) {
          return (sheet.height(x + dx, y + dy) - sheet.height(x - dx, y - dy)) / (2 * step);
        };
        const double u = slope(step, 0), v = slope(0, step), size = std::sqrt(1 + u * u + v * v);
        add(shape.positions, x, y, side * sheet.height(x, y));
        add(shape.normals, -u / size, -v / size, side / size);
      }
    }
  }
  return shape;
}

// Returns the point in the coordinates of the sheet.
inline std::array<double, 3> turned_back(const Rotation& rotation, const float* point) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] += rotation[k][i] * static_cast<double>(point[k]);
  }
  return result;
}

}  // namespace glark::reconstruct::test
