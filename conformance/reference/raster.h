// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles as section 14.6 of the OpenGL specification rasterizes them: perspectively correct colours, a depth buffer,
// and the rule that a pixel centre on an edge belongs to the triangle above or to the right of it.
#pragma once

#include <array>
#include <vector>

#include "conformance/suite/picture.h"

namespace glark::conformance::reference {

struct RasterVertex {
  std::array<float, 4> position = {0, 0, 0, 1};  // in clip coordinates; w > 0
  std::array<float, 4> colour = {1, 1, 1, 1};
};

class Raster {
 public:
  // Begins black, with the greatest depth. A pixel whose centre is closer than `uncertainty` pixels to an edge is
  // uncertain: a GL snaps window coordinates to a grid of 2^-SUBPIXEL_BITS pixels, so the pixel may be on either side.
  Raster(int width, int height, double uncertainty);

  void set_depth_test(bool is_on) { has_depth_test_ = is_on; }
  // Additive: each triangle adds its colour.
  void set_additive(bool is_on) { is_additive_ = is_on; }

  // Throws std::invalid_argument if w is not positive.
  void triangle(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c);

  Picture picture() const;
  bool is_uncertain(int x, int y) const { return uncertain_[index(x, y)]; }
  int uncertain_count() const;
  // Counts the pixels that are certain and differ from `actual` by more than `tolerance` in a channel.
  int count_different(const Picture& actual, int tolerance) const;

 private:
  struct WindowVertex;
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  WindowVertex to_window(const RasterVertex& vertex) const;
  void pixel(int x, int y, const std::array<WindowVertex, 3>& v, double area);

  int width_;
  int height_;
  double uncertainty_;
  bool has_depth_test_ = false;
  bool is_additive_ = false;
  std::vector<std::array<double, 4>> colours_;
  std::vector<double> depths_;
  std::vector<bool> uncertain_;
};

}  // namespace glark::conformance::reference
