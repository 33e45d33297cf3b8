// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Columns of numbers in records: a column is one field of many records.
#pragma once

#include <glark/point_stream.h>

#include <cstddef>
#include <cstdint>

namespace glark::stream {

inline constexpr std::uint32_t no_field = 0xFFFFFFFF;

// A number in a record. Its value is scale * n + shift, where n is the number in the file.
struct Field {
  std::uint32_t offset = no_field;  // in bytes from the beginning of the record
  Number type = Number::float32;
  std::uint8_t mask = 0xFF;  // the bits that count, for uint8
  double scale = 1, shift = 0;
};

std::size_t size_of(Number type);
const char* name_of(Number type);  // as PLY has it
bool is_float(Number type);

// Where the numbers of a column lie.
struct Column {
  std::size_t stride = 0;  // bytes from a record to the next
  std::size_t count = 0;
  bool swapped = false;  // the bytes of each number are in the other order
};

// Reads a column: to[i * step] for record i. `records` is the first byte of the first record.
void read_column(const Field& field, const Column& column, const char* records, double* to, std::size_t step);
void read_column(const Field& field, const Column& column, const char* records, float* to, std::size_t step);

// Writes a column. Whole numbers are rounded; the other bits of a masked byte stay. Returns the index of the first
// number that does not fit into its type, or column.count.
std::size_t write_column(const Field& field, const Column& column, char* records, const double* from, std::size_t step);
std::size_t write_column(const Field& field, const Column& column, char* records, const float* from, std::size_t step);

}  // namespace glark::stream
