// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/edit.h>

#include <string>
#include <vector>

namespace glark::edit {

class Picture {
 public:
  // Throws Error if the file is no picture.
  explicit Picture(const std::string& file);

  double width() const { return width_; }
  double height() const { return height_; }
  // The colour at a place, 0 0 for the upper left corner, to width() and height(). It is interpolated.
  Colour at(double x, double y) const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> pixels_;  // rows from the top, red green blue
};

}  // namespace glark::edit
