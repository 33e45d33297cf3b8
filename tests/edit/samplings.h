// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samplings of known surfaces, and what tests compare of an editor.
#pragma once

#include <glark/edit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glark/clients/common/vector.h"

namespace glark::edit {

using common::Vector3d;

// A square in the plane z = 0 over [-1, 1]^2 with side x side samples, and the normal 0 0 1.
inline Sampling plane(std::size_t side) {
  Sampling all;
  const double step = 2 / static_cast<double>(side - 1);
  for (std::size_t i = 0; i < side * side; ++i) {
    const std::size_t row = i / side, column = i % side;
    const double x = -1 + step * static_cast<double>(row), y = -1 + step * static_cast<double>(column);
    all.positions.insert(all.positions.end(), {x, y, 0});
    all.normals.insert(all.normals.end(), {0, 0, 1});
  }
  return all;
}

// A unit sphere whose samples are mirrored at x = 0: the samples 2 i and 2 i + 1 are a pair.
inline Sampling sphere(std::size_t pairs) {
  Sampling all;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(pairs), r = std::sqrt(1 - z * z);
    const double turn = 2.399963229728653 * static_cast<double>(i);
    const double x = r * std::abs(std::cos(turn)), y = r * std::sin(turn);
    all.positions.insert(all.positions.end(), {x, y, z, -x, y, z});
    const auto fx = static_cast<float>(x), fy = static_cast<float>(y), fz = static_cast<float>(z);
    all.normals.insert(all.normals.end(), {fx, fy, fz, -fx, fy, fz});
  }
  return all;
}

inline Vector3d position(std::span<const double> positions, std::size_t i) { return common::vector_at(positions, i); }
inline double distance(const Vector3d& a, const Vector3d& b) { return common::length(a - b); }

// All that an editor holds, as bytes.
inline std::string bytes_of(const Editor& editor) {
  std::string bytes;
  const auto add = [&](auto span) {
    bytes.append(reinterpret_cast<const char*>(span.data()), span.size_bytes());
    bytes += "|";
  };
  add(editor.positions());
  add(editor.normals());
  add(editor.colours());
  add(editor.positions_before());
  add(editor.normals_before());
  add(editor.colours_before());
  return bytes;
}

inline void apply(Editor& editor, std::string_view line) { editor.apply(parse(line)); }

// Returns the message of the Error that `step` throws, or an empty text.
template <class Step>
std::string problem_of(const Step& step) {
  try {
    step();
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

}  // namespace glark::edit
