// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/shape/shape.h"

#include <fmt/format.h>
#include <glark/vstree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glark::edit {
namespace {

constexpr std::uint8_t white = 255;
constexpr double most = 1e18;

[[noreturn]] void fail(std::size_t index, const std::string& what) {
  throw Error(Element::array, index, "glark-edit: " + what);
}

void check(const Sampling& sampling) {
  const std::size_t numbers = sampling.positions.size();
  if (numbers == 0) fail(0, "the sampling has no samples; give at least one position");
  if (numbers % 3 != 0 || numbers / 3 > std::numeric_limits<std::int32_t>::max())
    fail(0, fmt::format("positions has {} numbers; three for each of at most 2^31 samples are needed", numbers));
  if (!sampling.normals.empty() && sampling.normals.size() != numbers)
    fail(0, fmt::format("normals has {} numbers, positions has {}; give none or as many", sampling.normals.size(),
                        numbers));
  if (!sampling.colours.empty() && sampling.colours.size() != numbers)
    fail(0, fmt::format("colours has {} numbers, positions has {}; give none or as many", sampling.colours.size(),
                        numbers));
  for (std::size_t i = 0; i < numbers; ++i)
    if (!(std::abs(sampling.positions[i]) <= most))
      fail(i / 3, fmt::format("sample {} has the coordinate {}; leave it out", i / 3, sampling.positions[i]));
  if (sampling.triangles.size() % 3 != 0)
    fail(0, fmt::format("triangles has {} indices; three for each triangle are needed", sampling.triangles.size()));
  for (std::size_t i = 0; i < sampling.triangles.size(); ++i)
    if (sampling.triangles[i] >= numbers / 3)
      fail(i / 3, fmt::format("triangle {} has the index {}; the sampling has {} samples", i / 3, sampling.triangles[i],
                              numbers / 3));
}

bool is_missing(const float* normal) {
  const float length = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  return !(length > 0) || !std::isfinite(length);
}

// Estimates the normals that are missing, zero or not finite. Positions become floats from the first sample on: the scan
// may be far from the origin.
void complete_normals(Samples& samples, unsigned threads) {
  std::vector<float>& normals = samples.normals;
  bool is_complete = !normals.empty();
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    if (!is_missing(&normals[i])) continue;
    is_complete = false;
    std::fill_n(&normals[i], 3, 0.0F);
  }
  if (is_complete) return;
  std::vector<float> near(samples.positions.size());
  for (std::size_t i = 0; i < near.size(); ++i)
    near[i] = static_cast<float>(samples.positions[i] - samples.positions[i % 3]);
  normals = vstree::estimate_normals({.positions = near, .normals = normals}, {.threads = threads});
}

}  // namespace

Graph make_graph(const Shape& shape, const common::Workers& workers) {
  return shape.triangles.empty() ? nearest_graph(shape.before.positions, workers)
                                 : triangle_graph(shape.size(), shape.triangles);
}

Shape make_shape(Sampling sampling, const common::Workers& workers) {
  check(sampling);
  Shape shape;
  Samples& before = shape.before;
  before.positions = std::move(sampling.positions);
  before.normals = std::move(sampling.normals);
  complete_normals(before, static_cast<unsigned>(workers.count()));
  for (std::size_t i = 0; i < before.size(); ++i) before.set_normal(i, common::unit(before.normal(i)));
  shape.had_colours = shape.has_colours = !sampling.colours.empty();
  before.colours = std::move(sampling.colours);
  before.colours.resize(before.positions.size(), white);
  shape.now = before;
  shape.triangles = std::move(sampling.triangles);
  shape.graph = make_graph(shape, workers);
  return shape;
}

}  // namespace glark::edit
