// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples that move, and how operations find them. Each function gets an operation, or two: the second one is mirrored.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

// New positions of samples, in ascending order.
struct Motion {
  std::vector<std::uint32_t> samples;
  std::vector<Vector3d> positions;
};

// How an operation moves samples, in ascending order.
struct Field {
  std::vector<std::uint32_t> samples;
  std::vector<double> weights;  // above 0, at most 1
  std::vector<Vector3d> by;     // with the weight
};

// Where several fields reach a sample, it moves by the mean of them with their weights.
Motion motion_of(std::span<const Field> fields, const Samples& now);

Field field_of(const Inflate& inflate, const Samples& now);
Field field_of(const Move& move, const Samples& now);
Field field_of(const Bend& bend, const Samples& now);
Field field_of(const Twist& twist, const Samples& now);

template <class Kind>
Motion motion_of(std::span<const Kind> operations, const Shape& shape) {
  std::vector<Field> fields;
  for (const Kind& operation : operations) fields.push_back(field_of(operation, shape.now));
  return motion_of(std::span<const Field>(fields), shape.now);
}
Motion motion_of(std::span<const Smooth> smooths, const Shape& shape);
Motion motion_of(std::span<const Deform> deforms, const Shape& shape);

}  // namespace glark::edit
