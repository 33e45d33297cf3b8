// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/shapes/clouds.h"

#include <algorithm>
#include <cmath>

namespace glark::shapes {
namespace {

constexpr int cells = 96;  // along the longest side of the box

// Finds points that are evenly distributed over the surface. A point in a thin shell around the surface moves onto it.
class SurfacePoints {
 public:
  SurfacePoints(const Statue& statue, std::mt19937& random) : statue_(statue), random_(random) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, statue.high()[i] - statue.low()[i]);
    side_ = longest / cells;
    for (double x = statue.low()[0]; x < statue.high()[0]; x += side_) {
      for (double y = statue.low()[1]; y < statue.high()[1]; y += side_) {
        for (double z = statue.low()[2]; z < statue.high()[2]; z += side_) {
          const Point middle{x + side_ / 2, y + side_ / 2, z + side_ / 2};
          if (std::abs(statue.distance(middle)) < 1.2 * side_) lows_.push_back({x, y, z});
        }
      }
    }
  }

  Point next() {
    std::uniform_int_distribution<std::size_t> which(0, lows_.size() - 1);
    std::uniform_real_distribution<double> part(0, side_);
    for (;;) {
      Point point = lows_[which(random_)];
      for (double& number : point) number += part(random_);
      if (std::abs(statue_.distance(point)) < 0.1 * side_) return statue_.on_surface(point);
    }
  }

 private:
  const Statue& statue_;
  std::mt19937& random_;
  double side_ = 0;
  std::vector<Point> lows_;
};

void add(Cloud& cloud, const Point& point, const Point& normal) {
  for (const double number : point) cloud.positions.push_back(static_cast<float>(number));
  for (const double number : normal) cloud.normals.push_back(static_cast<float>(number));
}

Point random_direction(std::mt19937& random) {
  std::normal_distribution<double> number;
  Point direction{number(random), number(random), number(random)};
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  for (double& part : direction) part /= length;
  return direction;
}

}  // namespace

Cloud cloud_of(const Statue& statue, unsigned seed, const CloudOptions& options) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> noise(0, 1);
  SurfacePoints surface(statue, random);
  std::vector<Point> holes;
  for (int i = 0; i < 3 && options.hole > 0; ++i) holes.push_back(surface.next());
  const Point shift = random_direction(random);
  const double height = statue.high()[2] - statue.low()[2];
  Cloud cloud;
  while (cloud.size() < options.samples) {
    if (share(random) < options.outliers) {
      Point point{};
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = statue.low()[i] + share(random) * (statue.high()[i] - statue.low()[i]);
      add(cloud, point, random_direction(random));
      continue;
    }
    Point point = surface.next();
    while (share(random) > std::pow(options.density_ratio, (statue.low()[2] - point[2]) / height))
      point = surface.next();
    if (std::any_of(holes.begin(), holes.end(), [&](const Point& hole) {
          return std::hypot(point[0] - hole[0], point[1] - hole[1], point[2] - hole[2]) < options.hole;
        }))
      continue;
    const Point normal = statue.normal(point);
    const double off = options.noise * noise(random);
    const double moved = cloud.size() % 2 == 0 ? options.layers : 0;
    for (std::size_t i = 0; i < 3; ++i) point[i] += off * normal[i] + moved * shift[i];
    add(cloud, point, normal);
  }
  return cloud;
}

Cloud fog(unsigned seed, std::size_t samples) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Cloud cloud;
  while (cloud.size() < samples) {
    Point point = random_direction(random);
    const double radius = std::cbrt(share(random));
    for (double& number : point) number *= radius;
    add(cloud, point, random_direction(random));
  }
  return cloud;
}

}  // namespace glark::shapes
