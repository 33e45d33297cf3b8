// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/format/layout.h"

#include <fmt/format.h>

#include <cmath>

#include "glark/clients/common/error_message.h"

namespace glark::stream {
namespace {

// Calls step(column, first byte, first point) for the points at each place of a record; never if there is no record.
template <class Step>
void each_place(const Layout& layout, std::size_t records, const Step& step) {
  if (records == 0) return;
  const Column column{layout.record_size, records, layout.swapped};
  for (std::uint32_t place = 0; place < layout.points_per_record; ++place)
    step(column, std::size_t{place} * layout.point_size, std::size_t{place});
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what) : ElementError(element, index, what) {}

std::size_t channel_index(const Schema& schema, const std::string& name) {
  for (std::size_t i = 0; i < schema.channels.size(); ++i)
    if (schema.channels[i].name == name) return i;
  return none;
}

void decode(const Layout& layout, const char* records, std::size_t count, const ReadOptions& wanted, PointArrays& to) {
  const std::size_t each = layout.points_per_record;
  const std::size_t points = count * each, channels = layout.channels.size();
  to.positions.resize(3 * points);
  to.normals.resize(wanted.normals && layout.has_normals() ? 3 * points : 0);
  to.channels.resize(wanted.channels ? channels * points : 0);
  each_place(layout, count, [&](const Column& column, std::size_t byte, std::size_t place) {
    for (std::size_t k = 0; k < 3; ++k) {
      read_column(layout.position[k], column, records + byte, &to.positions[3 * place + k], 3 * each);
      if (!to.normals.empty()) read_column(layout.normal[k], column, records, &to.normals[3 * place + k], 3 * each);
    }
    for (std::size_t k = 0; k < channels && !to.channels.empty(); ++k)
      read_column(layout.channels[k], column, records, &to.channels[channels * place + k], channels * each);
  });
}

void encode(const Layout& layout, const std::string& file, std::uint64_t first, std::span<const double> positions,
            std::span<const float> normals, std::span<char> records) {
  const std::size_t each = layout.points_per_record;
  const std::size_t count = positions.size() / 3 / each;
  each_place(layout, count, [&](const Column& column, std::size_t byte, std::size_t place) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t bad =
          write_column(layout.position[k], column, records.data() + byte, &positions[3 * place + k], 3 * each);
      if (bad < count) {
        const std::uint64_t point = first + bad * each + place;
        throw Error(Element::point, point,
                    fmt::format("{}: {} {} gets the coordinate {}, which the numbers of the file ({}, steps of {}) "
                                "cannot hold; convert the file to PLY with doubles first",
                                file, layout.element, point, positions[3 * (bad * each + place) + k],
                                name_of(layout.position[k].type), layout.position[k].scale));
      }
      if (!normals.empty() && layout.has_normals())
        write_column(layout.normal[k], column, records.data(), &normals[3 * place + k], 3 * each);
    }
  });
}

void require_finite(const Points& points, const std::string& file, const std::string& element) {
  double sum = 0;  // x - x is zero, or NaN if x is not finite
  for (const double coordinate : points.positions) sum += coordinate - coordinate;
  if (sum == 0) return;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    if (std::isfinite(points.positions[i])) continue;
    const std::uint64_t point = points.first + i / 3;
    throw Error(
        Element::point, point,
        fmt::format("{}: {} {} has a coordinate that is NaN or infinite; repair the file, or leave the point out", file,
                    element, point));
  }
}

}  // namespace glark::stream
