// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/parse/ply_values.h"

#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry::ply {
namespace {

constexpr double longest_list = 1 << 20;

template <class Value>
double decode_as(const char* bytes, bool swapped) {
  std::array<char, sizeof(Value)> value{};
  std::memcpy(value.data(), bytes, sizeof(Value));
  if (swapped) std::reverse(value.begin(), value.end());
  return static_cast<double>(std::bit_cast<Value>(value));
}

double decode(const char* bytes, Type type, bool swapped) {
  switch (type) {
    case Type::int8: return decode_as<std::int8_t>(bytes, swapped);
    case Type::uint8: return decode_as<std::uint8_t>(bytes, swapped);
    case Type::int16: return decode_as<std::int16_t>(bytes, swapped);
    case Type::uint16: return decode_as<std::uint16_t>(bytes, swapped);
    case Type::int32: return decode_as<std::int32_t>(bytes, swapped);
    case Type::uint32: return decode_as<std::uint32_t>(bytes, swapped);
    case Type::float32: return decode_as<float>(bytes, swapped);
    case Type::float64: return decode_as<double>(bytes, swapped);
  }
  return 0;
}

bool is_swapped(Encoding encoding) {
  return (encoding == Encoding::big_endian) != (std::endian::native == std::endian::big);
}

}  // namespace

void Values::fail(const std::string& problem) const {
  throw Error(fmt::format("{}: {} {} of {}: {}", input_.name(), element_->name, index_, element_->count, problem));
}

double Values::parse_word(Type type) {
  std::string_view word = input_.word();
  if (word.empty()) fail("the file ends here; it is cut off or its header wrong, get it again");
  const std::string_view whole = word;
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  if ((error != std::errc() && error != std::errc::result_out_of_range) || end != word.data() + word.size())
    fail("\"" + std::string(whole.substr(0, 40)) + "\" is not a number; repair the file or export it again");
  return type == Type::float32 ? static_cast<double>(static_cast<float>(value)) : value;
}

double Values::number(Type type) {
  if (encoding_ == Encoding::text) return parse_word(type);
  const std::span<const char> bytes = input_.take(size_of(type));
  if (bytes.size() < size_of(type)) fail("the file ends here; it is cut off or its header wrong, get it again");
  return decode(bytes.data(), type, is_swapped(encoding_));
}

void Values::record(std::span<double> values) {
  if (encoding_ == Encoding::text) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = parse_word(element_->properties[i].type);
    return;
  }
  const std::size_t size = element_->least_size(encoding_);
  const std::span<const char> bytes = input_.take(size);
  if (bytes.size() < size) fail("the file ends here; it is cut off or its header wrong, get it again");
  const bool swapped = is_swapped(encoding_);
  const char* next = bytes.data();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Type type = element_->properties[i].type;
    values[i] = decode(next, type, swapped);
    next += size_of(type);
  }
}

void Values::list(const Property& property, std::vector<double>& values) {
  const double count = number(*property.count_type);
  if (count != std::floor(count))
    fail(fmt::format("the list {} has {} entries, which is not a whole number; the file is damaged, get it again",
                     property.name, count));
  if (!(count >= 0 && count <= longest_list))
    fail(fmt::format(
        "the list {} has {} entries, which no polygon has (the limit is {}); the file is damaged, get it again",
        property.name, static_cast<long long>(std::clamp(count, -9e18, 9e18)), static_cast<long long>(longest_list)));
  values.clear();
  for (auto left = static_cast<std::size_t>(count); left > 0; --left) values.push_back(number(property.type));
}

}  // namespace glark::geometry::ply
