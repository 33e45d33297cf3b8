// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The numbers of a PLY file after its header, in any encoding.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/parse/ply_header.h"

namespace glark::geometry::ply {

class Values {
 public:
  Values(Input& input, Encoding encoding) : input_(input), encoding_(encoding) {}

  // Sets the element that messages name: "vertex 17".
  void at(const Element& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }
  // Reads the scalars of an element without lists.
  void record(std::span<double> values);
  double number(Type type);
  void list(const Property& property, std::vector<double>& values);
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  double parse_word(Type type);

  Input& input_;
  Encoding encoding_;
  const Element* element_ = nullptr;
  std::uint64_t index_ = 0;
};

}  // namespace glark::geometry::ply
