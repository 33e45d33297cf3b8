// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What each operation of GLSL does to the variation of its arguments.
#pragma once

#include <optional>
#include <string_view>

namespace glark::refine {

enum class Effect {
  linear,      // sums, conversions between floats: an affine argument gives an affine result
  product,     // affine if at most one argument varies
  fused,       // a product of two, and a sum
  quotient,    // affine if the divisor does not vary
  mixture,     // affine if the share does not vary
  continuous,  // keeps continuous arguments continuous
  switched,    // jumps
  undefined,   // has no meaning between vertices
};

struct Operation {
  Effect effect = Effect::undefined;
  bool by_component = false;  // otherwise each component of the result depends on all components of the arguments
  std::string_view name;      // completes "... of 'x'": "floor()"; empty if unknown
};
// `words` name the operation as a syntax tree does. Operations that are not listed have no meaning between vertices.
Operation operation(std::string_view words);

// The operation that an assignment such as += contains, empty for a plain assignment. Nothing if it is no assignment.
std::optional<std::string_view> within_assignment(std::string_view words);

}  // namespace glark::refine
