// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The error of a picture of a surface on the screen: at its silhouettes, and in the depth buffer.
#pragma once

#include <vector>

#include "tests/bench/interleave.h"

namespace glark::bench {

struct ScreenErrors {
  double silhouette = 0;  // the mean distance from the true silhouette, also where one part covers another; pixels
  double depth = 0;       // the root mean square of the distance from the true surface along the line of sight; pixels
};

// Measures with a picture that is `zoom` times as large as that of the benchmarks.
class ErrorMeter {
 public:
  static constexpr int zoom = 4;

  // `pixels_at_one`: the length of one unit at distance 1 in the picture of the benchmarks.
  ErrorMeter(const Competitor& true_surface, double pixels_at_one);
  // The program in use has a uniform "projection". Leaves the viewport of the benchmarks.
  ScreenErrors of(const Competitor& competitor) const;

 private:
  double pixels_at_one_;
  std::vector<double> truth_;  // distance from the eye; 0: background
  double contour_ = 0;         // length of the silhouettes, in pixels of the large picture
};

}  // namespace glark::bench
