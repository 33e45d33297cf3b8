// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/screen_error.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "tests/bench/gl.h"
#include "tests/bench/offscreen.h"

namespace glark::bench {
namespace {

constexpr int side = ErrorMeter::zoom * picture_size;
constexpr double jump = 0.05;  // of the distance from the eye, between neighbours on both sides of a silhouette

std::size_t pixel(int x, int y) { return static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x); }

// The distance of each pixel from the eye.
std::vector<double> distances(const Competitor& competitor) {
  std::vector<double> result(std::size_t{side} * side);
  std::vector<float> tile(std::size_t{picture_size} * picture_size);
  competitor.prepare();
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  std::array<GLfloat, 16> projection{};
  const auto name = static_cast<GLuint>(program);
  glGetUniformfv(name, glGetUniformLocation(name, "projection"), projection.data());
  for (int y = 0; y < side; y += picture_size) {
    for (int x = 0; x < side; x += picture_size) {
      glViewport(-x, -y, side, side);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      competitor.draw();
      glReadPixels(0, 0, picture_size, picture_size, GL_DEPTH_COMPONENT, GL_FLOAT, tile.data());
      for (int row = 0; row < picture_size; ++row) {
        for (int column = 0; column < picture_size; ++column) {
          const double depth = tile[static_cast<std::size_t>(row) * picture_size + static_cast<std::size_t>(column)];
          const double distance = projection[14] / (2 * depth - 1 + projection[10]);
          result[pixel(x + column, y + row)] = depth < 1 ? std::abs(distance) : 0;
        }
      }
    }
  }
  glViewport(0, 0, picture_size, picture_size);
  return result;
}

bool parts(double a, double b) { return (a == 0) != (b == 0) || std::abs(a - b) > jump * std::max(a, b); }

}  // namespace

ErrorMeter::ErrorMeter(const Competitor& true_surface, double pixels_at_one)
    : pixels_at_one_(pixels_at_one), truth_(distances(true_surface)) {
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const double here = truth_[pixel(x, y)];
      const bool right = parts(here, truth_[pixel(x + 1, y)]);
      const bool above = parts(here, truth_[pixel(x, y + 1)]);
      contour_ += right || above ? 1 : 0;
    }
  }
  if (contour_ == 0) throw std::runtime_error("the true surface shows nothing");
}

ScreenErrors ErrorMeter::of(const Competitor& competitor) const {
  const std::vector<double> seen = distances(competitor);
  double outside = 0;
  double squares = 0;
  double inside = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (parts(seen[i], truth_[i])) {
      outside += 1;
    } else if (seen[i] > 0) {
      const double error = (seen[i] - truth_[i]) * pixels_at_one_ / truth_[i];
      squares += error * error;
      inside += 1;
    }
  }
  return {.silhouette = outside / contour_ / zoom, .depth = std::sqrt(squares / inside)};
}

}  // namespace glark::bench
