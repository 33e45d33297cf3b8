// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/local_points.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/vector.h"
#include "glark/clients/stream/sample/pass/stored_point.h"

namespace glark::stream {
namespace {

constexpr float normal_steps = 32767;

}  // namespace

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
  const std::array<std::uint32_t, 3> cube = plan_.lattice.cube(position);
  if (cell_ != no_cell && cube == cube_) return cell_;
  const std::size_t cell = cell_of(plan_.cells, Lattice::key(cube));
  if (cell == none) fail_as_changed(source_);
  cube_ = cube;
  if (cell_ == cell) return cell_;
  cell_ = static_cast<std::uint32_t>(cell);
  frame_ = CellFrame(plan_.corner(cell), plan_.side(cell), plan_.bits(cell));
  centre_ = plan_.centre(cell);
  return cell_;
}

CellFrame::CellFrame(const std::array<double, 3>& corner, double side, unsigned bits)
    : corner_(corner),
      small_(std::ldexp(side, -static_cast<int>(bits))),
      cubes_a_unit_(1 / small_),
      last_(static_cast<double>((1U << bits) - 1)) {}

void CellFrame::place(const std::array<double, 3>& position, LocalPoint& point) const {
  std::array<std::uint32_t, 3> cube{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = position[k] - corner_[k];
    cube[k] = static_cast<std::uint32_t>(std::clamp(at * cubes_a_unit_, 0.0, last_));
    point.position[k] = static_cast<float>(at - (cube[k] + 0.5) * small_);
  }
  point.key = static_cast<std::uint32_t>(morton_code(cube));
}

LocalPoint local_point(const CellFinder& finder, std::uint32_t cell, const PointKind& kind, const Points& points,
                       std::size_t i) {
  LocalPoint point;
  point.cell = cell;
  if (cell == no_cell) return point;
  const double* position = &points.positions[3 * i];
  finder.frame().place({position[0], position[1], position[2]}, point);
  if (kind.has_normals) point.normal = unit_normal_of(points, i);
  point.colour = kind.colour_of(points, i);
  return point;
}

StoredPoint stored_point(const std::array<double, 3>& centre, const PointKind& kind, const Points& points,
                         std::size_t i) {
  StoredPoint point;
  const std::array<float, 3> normal = kind.has_normals ? unit_normal_of(points, i) : std::array<float, 3>{};
  for (std::size_t k = 0; k < 3; ++k) {
    point.from_centre[k] = static_cast<float>(points.positions[3 * i + k] - centre[k]);
    point.normal[k] = static_cast<std::int16_t>(std::lround(normal_steps * normal[k]));
  }
  point.colour = kind.colour_of(points, i);
  return point;
}

void add_stored(const StoredPoint& stored, const CellFrame& frame, const PointKind& kind, MicroTable& table) {
  LocalPoint point;
  frame.place({stored.from_centre[0], stored.from_centre[1], stored.from_centre[2]}, point);
  for (std::size_t k = 0; k < 3; ++k) point.normal[k] = static_cast<float>(stored.normal[k]) / normal_steps;
  point.colour = stored.colour;
  table.add(MicroTable::part_of(point.key), point, kind.has_normals);
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
