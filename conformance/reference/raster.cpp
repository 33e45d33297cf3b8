// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/reference/raster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace glark::conformance::reference {

struct Raster::WindowVertex {
  double x;
  double y;
  double depth;
  double reciprocal_w;
  std::array<float, 4> colour;
};

namespace {

template <typename Vertex>
double doubled_area(const Vertex& a, const Vertex& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// Whether a pixel centre on this edge of a counter-clockwise triangle belongs to the triangle.
template <typename Vertex>
bool owns_its_points(const Vertex& a, const Vertex& b) {
  return a.y > b.y || (a.y == b.y && a.x < b.x);
}

template <typename Vertex>
double distance_to_segment(const Vertex& a, const Vertex& b, double x, double y) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x - (a.x + t * dx), y - (a.y + t * dy));
}

}  // namespace

Raster::Raster(int width, int height, double uncertainty)
    : width_(width),
      height_(height),
      uncertainty_(uncertainty),
      colours_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {0, 0, 0, 1}),
      depths_(colours_.size(), 1),
      uncertain_(colours_.size(), false) {}

Raster::WindowVertex Raster::to_window(const RasterVertex& vertex) const {
  const double w = vertex.position[3];
  if (!(w > 0)) throw std::invalid_argument("the reference rasterizer does not clip");
  return {(vertex.position[0] / w + 1) / 2 * width_, (vertex.position[1] / w + 1) / 2 * height_,
          (vertex.position[2] / w + 1) / 2, 1 / w, vertex.colour};
}

void Raster::triangle(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
  std::array<WindowVertex, 3> v = {to_window(a), to_window(b), to_window(c)};
  double area = doubled_area(v[0], v[1], v[2].x, v[2].y);
  if (area < 0) {
    std::swap(v[1], v[2]);
    area = -area;
  }
  const auto first = [](double low, double reach) {
    return std::max(0, static_cast<int>(std::floor(low - reach - 1)));
  };
  const auto last = [](double high, double reach, int size) {
    return std::min(size - 1, static_cast<int>(std::ceil(high + reach)));
  };
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [low, high] = std::minmax({v[0].y, v[1].y, v[2].y});
  for (int y = first(low, uncertainty_); y <= last(high, uncertainty_, height_); ++y)
    for (int x = first(left, uncertainty_); x <= last(right, uncertainty_, width_); ++x) pixel(x, y, v, area);
}

void Raster::pixel(int x, int y, const std::array<WindowVertex, 3>& v, double area) {
  const double px = x + 0.5;
  const double py = y + 0.5;
  std::array<double, 3> weights{};
  bool is_inside = area > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& from = v[(i + 1) % 3];
    const WindowVertex& to = v[(i + 2) % 3];
    if (distance_to_segment(from, to, px, py) < uncertainty_) uncertain_[index(x, y)] = true;
    weights[i] = doubled_area(from, to, px, py) / area;
    is_inside = is_inside && (weights[i] > 0 || (weights[i] == 0 && owns_its_points(from, to)));
  }
  if (!is_inside) return;
  const double depth = weights[0] * v[0].depth + weights[1] * v[1].depth + weights[2] * v[2].depth;
  if (has_depth_test_ && depth >= depths_[index(x, y)]) return;
  if (has_depth_test_) depths_[index(x, y)] = depth;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += weights[i] * v[i].reciprocal_w;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    double value = 0;
    for (std::size_t i = 0; i < 3; ++i) value += weights[i] * v[i].reciprocal_w * v[i].colour[channel];
    double& stored = colours_[index(x, y)][channel];
    stored = std::clamp(value / sum + (is_additive_ ? stored : 0), 0.0, 1.0);
  }
}

Picture Raster::picture() const {
  Picture picture(width_, height_);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      std::array<std::uint8_t, 4> bytes{};
      for (std::size_t i = 0; i < 4; ++i)
        bytes[i] = static_cast<std::uint8_t>(std::lround(255 * colours_[index(x, y)][i]));
      picture.set(x, y, bytes);
    }
  return picture;
}

int Raster::uncertain_count() const { return static_cast<int>(std::count(uncertain_.begin(), uncertain_.end(), true)); }

int Raster::count_different(const Picture& actual, int tolerance) const {
  const Picture expected = picture();
  int count = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      if (is_uncertain(x, y)) continue;
      const auto a = actual.at(x, y);
      const auto e = expected.at(x, y);
      bool differs = false;
      for (std::size_t i = 0; i < 4; ++i) differs = differs || std::abs(a[i] - e[i]) > tolerance;
      count += differs ? 1 : 0;
    }
  return count;
}

}  // namespace glark::conformance::reference
