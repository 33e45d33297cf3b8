// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Abstract values: how a value of the vertex stage varies, for each component of a vector and each member of a
// structure.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/refine/syntax/type.h"
#include "glark/core/state/programs/variation.h"

namespace glark::refine {

struct Value {
  Variation variation = Variation::constant;
  std::uint64_t inputs = 0;  // bit i: it depends on input i
  int reason = -1;           // index of the reason, if it is switched or undefined

  bool varies() const { return variation != Variation::constant; }
};

// The worse of the two, which depends on the inputs of both.
Value worse(const Value& a, const Value& b);

// The elements of an array, and the components of a matrix, share one value.
struct Shape {
  Value value;               // if there are no parts
  std::vector<Shape> parts;  // components of a vector, members of a structure
};

Shape shape_of(const Type& type, const Value& value = {});
Value merged(const Shape& shape);
// Sets every component.
void fill(Shape& shape, const Value& value);
// Makes every component at least as bad as `value`.
void worsen(Shape& shape, const Value& value);
// Returns whether `into` has changed.
bool join(Shape& into, const Shape& other);
// The component of a vector, or the scalar that stands for all components.
const Shape& component(const Shape& shape, std::size_t index);

}  // namespace glark::refine
