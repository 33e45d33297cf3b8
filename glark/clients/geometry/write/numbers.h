// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Writes lines of numbers. Each number has enough digits to read the same value again.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace glark::geometry {

class Line {
 public:
  Line& add(std::string_view word) {
    if (!text_.empty() && text_.back() != '\n') text_ += ' ';
    text_ += word;
    return *this;
  }
  template <class Number>
  Line& number(Number value) {
    std::array<char, 64> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return add({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  // Ends the line. The text is valid until the next line begins.
  std::string_view end() {
    text_ += '\n';
    return text_;
  }
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

// Appends the coordinates of a point. With an origin, they are sums in double precision.
template <class Geometry>
void add_position(Line& line, const Geometry& geometry, std::size_t point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float relative = geometry.positions[3 * point + axis];
    if (geometry.origin[axis] == 0)
      line.number(relative);
    else
      line.number(geometry.origin[axis] + static_cast<double>(relative));
  }
}

}  // namespace glark::geometry
