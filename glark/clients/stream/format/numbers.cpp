// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/format/numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace glark::stream {
namespace {

// Calls step(Value{}) with the C++ type of the numbers.
template <class Step>
auto with_type(Number type, const Step& step) {
  switch (type) {
    case Number::int8: return step(std::int8_t{});
    case Number::uint8: return step(std::uint8_t{});
    case Number::int16: return step(std::int16_t{});
    case Number::uint16: return step(std::uint16_t{});
    case Number::int32: return step(std::int32_t{});
    case Number::uint32: return step(std::uint32_t{});
    case Number::float64: return step(double{});
    case Number::float32: break;
  }
  return step(float{});
}

template <class Value>
Value reversed(Value value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Value>(bytes);
}

template <class Value>
Value load(const char* from, bool swapped) {
  Value value;
  std::memcpy(&value, from, sizeof(Value));
  return swapped ? reversed(value) : value;
}

// The usual case is a loop of its own, which the compiler can unroll.
template <class Value, class To>
void read_as(const Field& field, const Column& column, const char* records, To* to, std::size_t step) {
  const char* at = records + field.offset;
  const bool plain = !column.swapped && field.scale == 1 && field.shift == 0 && field.mask == 0xFF;
  if (plain) {
    for (std::size_t i = 0; i < column.count; ++i, at += column.stride, to += step)
      *to = static_cast<To>(load<Value>(at, false));
    return;
  }
  for (std::size_t i = 0; i < column.count; ++i, at += column.stride, to += step) {
    Value value = load<Value>(at, column.swapped);
    if constexpr (std::is_same_v<Value, std::uint8_t>) value = static_cast<Value>(value & field.mask);
    *to = static_cast<To>(field.scale * static_cast<double>(value) + field.shift);
  }
}

template <class To>
void read_any(const Field& field, const Column& column, const char* records, To* to, std::size_t step) {
  with_type(field.type, [&](auto sample) { read_as<decltype(sample)>(field, column, records, to, step); });
}

// Returns whether the number fits.
template <class Value>
bool store(char* to, double number, const Field& field, bool swapped) {
  Value value;
  bool fits = true;
  if constexpr (std::is_floating_point_v<Value>) {
    value = static_cast<Value>(number);
    fits = std::isfinite(value) || !std::isfinite(number);
  } else {
    constexpr auto low = static_cast<double>(std::numeric_limits<Value>::min());
    constexpr auto high = static_cast<double>(std::numeric_limits<Value>::max());
    const double whole = std::nearbyint(number);
    fits = whole >= low && whole <= high;
    value = fits ? static_cast<Value>(whole) : Value{};
    if constexpr (std::is_same_v<Value, std::uint8_t>) {
      fits = fits && (value & ~field.mask) == 0;
      value = static_cast<Value>((load<Value>(to, false) & ~field.mask) | (value & field.mask));
    }
  }
  if (swapped) value = reversed(value);
  std::memcpy(to, &value, sizeof(Value));
  return fits;
}

template <class Value, class From>
std::size_t write_as(const Field& field, const Column& column, char* records, const From* from, std::size_t step) {
  char* at = records + field.offset;
  std::size_t first_bad = column.count;
  for (std::size_t i = 0; i < column.count; ++i, at += column.stride, from += step) {
    double number = static_cast<double>(*from);
    if (field.scale != 1 || field.shift != 0) number = (number - field.shift) / field.scale;
    if (!store<Value>(at, number, field, column.swapped)) first_bad = std::min(first_bad, i);
  }
  return first_bad;
}

template <class From>
std::size_t write_any(const Field& field, const Column& column, char* records, const From* from, std::size_t step) {
  return with_type(field.type,
                   [&](auto sample) { return write_as<decltype(sample)>(field, column, records, from, step); });
}

}  // namespace

std::size_t size_of(Number type) {
  return with_type(type, [](auto sample) { return sizeof(sample); });
}

const char* name_of(Number type) {
  constexpr std::array names{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

bool is_float(Number type) { return type == Number::float32 || type == Number::float64; }

void read_column(const Field& field, const Column& column, const char* records, double* to, std::size_t step) {
  read_any(field, column, records, to, step);
}
void read_column(const Field& field, const Column& column, const char* records, float* to, std::size_t step) {
  read_any(field, column, records, to, step);
}
std::size_t write_column(const Field& field, const Column& column, char* records, const double* from,
                         std::size_t step) {
  return write_any(field, column, records, from, step);
}
std::size_t write_column(const Field& field, const Column& column, char* records, const float* from, std::size_t step) {
  return write_any(field, column, records, from, step);
}

}  // namespace glark::stream
