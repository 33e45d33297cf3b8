// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Files whose points are records of one size: binary PLY, LAS, STL and triples of floats. A layout says where the
// numbers of a point lie. So one reader and one rewriter serve all of these formats.
#pragma once

#include <glark/point_stream.h>

#include <array>
#include <string>
#include <vector>

#include "glark/clients/stream/format/numbers.h"

namespace glark::stream {

// Squares of larger numbers leave the range of floats.
inline constexpr double largest_coordinate = 1e18;

struct Layout {
  std::string element = "vertex";  // the word for a point in messages, as the format has it
  std::uint64_t begin = 0;         // the byte of the file where the records begin
  std::uint64_t records = 0;
  std::uint32_t record_size = 0;  // in bytes
  // A record of STL has three points. Their positions follow one another; they share the normal.
  std::uint32_t points_per_record = 1;
  std::uint32_t point_size = 0;  // bytes from a point of a record to the next
  bool swapped = false;          // numbers have the other byte order
  std::array<Field, 3> position;
  std::array<Field, 3> normal;  // no_field: there is none
  std::vector<Field> channels;  // in the order of the schema
  Schema schema;

  std::uint64_t points() const { return records * points_per_record; }
  bool has_normals() const { return normal[0].offset != no_field; }
  // The number of bytes of the records; what follows them stays as it is.
  std::uint64_t size() const { return records * record_size; }
};

// The points of some records, decoded. The arrays grow once.
struct PointArrays {
  std::vector<double> positions;
  std::vector<float> normals;
  std::vector<double> channels;

  Points points(std::uint64_t first) const { return {first, positions, normals, channels}; }
};

// Decodes records. wanted: false values leave their arrays empty.
void decode(const Layout& layout, const char* records, std::size_t count, const ReadOptions& wanted, PointArrays& to);

// Writes positions, and normals if there are any, into the records. Errors: Error for a position that does not fit.
// first: the index of the first point, for messages.
void encode(const Layout& layout, const std::string& file, std::uint64_t first, std::span<const double> positions,
            std::span<const float> normals, std::span<char> records);

// Throws Error for the first point whose coordinates are not finite.
void require_finite(const Points& points, const std::string& file, const std::string& element);

}  // namespace glark::stream
