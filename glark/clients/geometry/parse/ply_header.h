// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glark/clients/geometry/parse/input.h"

namespace glark::geometry::ply {

enum class Encoding { text, little_endian, big_endian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(Type type);

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  // the type of a list's length
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;

  bool has_lists() const;
  // The minimum number of bytes of one element in the file.
  std::uint64_t least_size(Encoding encoding) const;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

// Reads the header. The next byte of the input is the first one after the header. Throws Error, for example if the file
// is too short for the announced elements.
Header read_header(Input& input);

}  // namespace glark::geometry::ply
