// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/local_points.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/vector.h"

namespace glark::stream {

PointKind::PointKind(const Schema& schema) : has_normals(schema.normals), channels(schema.channels.size()) {
  constexpr std::array names{"red", "green", "blue"};
  for (std::size_t k = 0; k < 3; ++k) colour[k] = channel_index(schema, names[k]);
  if (std::find(colour.begin(), colour.end(), none) != colour.end()) colour.fill(none);
  if (!has_colours()) return;
  const Number type = schema.channels[colour[0]].type;
  if (type == Number::uint16) colour_scale = 1.0 / 257;
  if (type == Number::float32 || type == Number::float64) colour_scale = 255;
}

std::array<std::uint8_t, 4> PointKind::colour_of(const Points& points, std::size_t i) const {
  std::array<std::uint8_t, 4> result{};
  for (std::size_t k = 0; k < 3 && has_colours(); ++k) {
    const double value = colour_scale * points.channels[channels * i + colour[k]];
    result[k] = static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) + 0.5 : 0);
  }
  return result;
}

std::uint32_t CellFinder::find(const double* position) {
  const double sum = position[0] + position[1] + position[2];
  if (!std::isfinite(sum)) return no_cell;
  const std::uint64_t key = Lattice::key(plan_.lattice.cube(position));
  if (key == key_) return cell_;
  const std::size_t cell = cell_of(plan_.cells, key);
  if (cell == none) fail_as_changed(source_);
  key_ = key;
  cell_ = static_cast<std::uint32_t>(cell);
  return cell_;
}

void place_in_cell(const std::array<double, 3>& from_centre, double side, unsigned bits, LocalPoint& point) {
  const double small = std::ldexp(side, -static_cast<int>(bits));
  const double last = static_cast<double>((1U << bits) - 1);
  std::array<std::uint32_t, 3> cube{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = from_centre[k] + side / 2;
    cube[k] = static_cast<std::uint32_t>(std::clamp(at / small, 0.0, last));
    point.position[k] = static_cast<float>(at - (cube[k] + 0.5) * small);
  }
  point.key = static_cast<std::uint32_t>(Lattice::key(cube));
}

std::array<float, 3> unit_normal_of(const Points& points, std::size_t i) {
  return common::to_array(common::unit(common::vector_at(points.normals, i)));
}

void fail_as_changed(const std::string& source) {
  throw Error(Element::file, 0,
              source +
                  ": the second pass found other points than the first; the file changed while it was read: start "
                  "again when nothing writes to it");
}

}  // namespace glark::stream
