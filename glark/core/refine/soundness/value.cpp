// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/value.h"

#include <algorithm>

namespace glark::refine {

Value worse(const Value& a, const Value& b) {
  Value result = b.variation > a.variation ? b : a;
  result.inputs = a.inputs | b.inputs;
  return result;
}

Shape shape_of(const Type& type, const Value& value) {
  Shape shape;
  shape.value = value;
  if (type.is_structure()) {
    for (const TypeMember& member : type.members) shape.parts.push_back(shape_of(member.type, value));
  } else if (type.is_vector()) {
    shape.parts.resize(type.vector_size, Shape{value, {}});
  }
  return shape;
}

Value merged(const Shape& shape) {
  if (shape.parts.empty()) return shape.value;
  Value result;
  for (const Shape& part : shape.parts) result = worse(result, merged(part));
  return result;
}

void fill(Shape& shape, const Value& value) {
  shape.value = value;
  for (Shape& part : shape.parts) fill(part, value);
}

void worsen(Shape& shape, const Value& value) {
  shape.value = worse(shape.value, value);
  for (Shape& part : shape.parts) worsen(part, value);
}

bool join(Shape& into, const Shape& other) {
  const Value before = into.value;
  into.value = worse(into.value, other.value);
  bool changed = into.value.variation != before.variation || into.value.inputs != before.inputs;
  const std::size_t count = std::min(into.parts.size(), other.parts.size());
  for (std::size_t i = 0; i < count; ++i) changed = join(into.parts[i], other.parts[i]) || changed;
  return changed;
}

const Shape& component(const Shape& shape, std::size_t index) {
  return index < shape.parts.size() ? shape.parts[index] : shape;
}

}  // namespace glark::refine
