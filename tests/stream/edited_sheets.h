// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans and samplings of a wavy sheet, and their edits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {

using Point = std::array<double, 3>;
using Edit = std::function<Point(const Point&)>;

// Points of a wavy sheet over [0, 10] x [0, 4], `side` of them along the shorter edge.
inline AllPoints sheet(std::size_t side) {
  AllPoints all;
  const double step = 4.0 / static_cast<double>(side);
  for (std::size_t i = 0; i < side * side * 5 / 2; ++i) {
    const std::size_t row = i / side, column = i % side;
    const double x = (static_cast<double>(row) + 0.5) * step, y = (static_cast<double>(column) + 0.5) * step;
    const double slope = 0.05 * std::cos(x);
    const double length = std::hypot(slope, 1);
    all.positions.insert(all.positions.end(), {x, y, 0.05 * std::sin(x)});
    all.normals.insert(all.normals.end(), {static_cast<float>(-slope / length), 0, static_cast<float>(1 / length)});
  }
  return all;
}

inline const Schema plain{Number::float32, true, {}};
inline const Schema painted{
    Number::float32, true, {{"red", Number::uint8}, {"green", Number::uint8}, {"blue", Number::uint8}}};

class Edited : public TemporaryFolder {
 protected:
  void write(const char* name, const AllPoints& all, const Schema& schema) const {
    const auto writer = create_points(path(name), schema, all.positions.size() / 3);
    writer->write(all.points());
    writer->finish();
  }
  static AllPoints moved(AllPoints all, const Edit& edit) {
    for (std::size_t i = 0; i < all.positions.size(); i += 3) {
      const Point to = edit({all.positions[i], all.positions[i + 1], all.positions[i + 2]});
      std::copy(to.begin(), to.end(), all.positions.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return all;
  }
  // Moves the sampling, transfers this, and returns the root mean square distance from the edit of the scan itself.
  double error_of(const Edit& edit) const {
    const AllPoints large = sheet(100), small = sheet(18);  // 3 %
    write("large.ply", large, plain);
    write("small.ply", small, plain);
    write("edited.ply", moved(small, edit), plain);
    transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply"));
    const AllPoints out = read_all(*open_points(path("out.ply"))), wanted = moved(large, edit);
    double sum = 0;
    for (std::size_t i = 0; i < wanted.positions.size(); ++i)
      sum += (out.positions[i] - wanted.positions[i]) * (out.positions[i] - wanted.positions[i]);
    const std::size_t points = wanted.positions.size() / 3;
    return std::sqrt(sum / static_cast<double>(points));
  }
};

}  // namespace glark::stream
