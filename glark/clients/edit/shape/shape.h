// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The sampling before and after the edit, and its neighbours.
#pragma once

#include <glark/edit.h>

#include <algorithm>
#include <vector>

#include "glark/clients/common/vector.h"
#include "glark/clients/edit/shape/graph.h"

namespace glark::edit {

using common::Vector3d;
using common::Vector3f;

// The arrays of Sampling, with colours in any case.
struct Samples {
  std::vector<double> positions;
  std::vector<float> normals;
  std::vector<std::uint8_t> colours;

  std::size_t size() const { return positions.size() / 3; }
  Vector3d position(std::size_t i) const { return common::vector_at(std::span<const double>(positions), i); }
  Vector3f normal(std::size_t i) const { return common::vector_at(std::span<const float>(normals), i); }
  Colour colour(std::size_t i) const { return {colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]}; }
  void set_position(std::size_t i, const Vector3d& p) {
    for (std::size_t k = 0; k < 3; ++k) positions[3 * i + k] = p[k];
  }
  void set_normal(std::size_t i, const Vector3f& n) {
    for (std::size_t k = 0; k < 3; ++k) normals[3 * i + k] = n[k];
  }
  void set_colour(std::size_t i, const Colour& colour) {
    std::copy(colour.begin(), colour.end(), colours.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  // Adds the samples of `more`.
  void append(const Samples& more) {
    positions.insert(positions.end(), more.positions.begin(), more.positions.end());
    normals.insert(normals.end(), more.normals.begin(), more.normals.end());
    colours.insert(colours.end(), more.colours.begin(), more.colours.end());
  }
  // Returns the samples from `first` on.
  Samples from(std::size_t first) const {
    const auto at = static_cast<std::ptrdiff_t>(3 * first);
    return {{positions.begin() + at, positions.end()},
            {normals.begin() + at, normals.end()},
            {colours.begin() + at, colours.end()}};
  }
  void cut(std::size_t size) {
    positions.resize(3 * size);
    normals.resize(3 * size);
    colours.resize(3 * size);
  }
};

struct Shape {
  Samples before, now;
  bool had_colours = false;  // before the edit
  bool has_colours = false;  // now: had or painted
  std::vector<std::uint32_t> triangles;
  Graph graph;  // of the positions before the edit, so that parts that come near do not stick

  std::size_t size() const { return now.size(); }
};

// Checks the arrays, estimates normals that are missing, and finds the neighbours. Throws Error.
Shape make_shape(Sampling sampling, const common::Workers& workers);
Graph make_graph(const Shape& shape, const common::Workers& workers);

}  // namespace glark::edit
