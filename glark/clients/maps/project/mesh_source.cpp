// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The vertices of a fine mesh, then the centres of small triangles into which each of its triangles is divided.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "glark/clients/common/vector.h"
#include "glark/clients/maps/project/mesh_points.h"

namespace glark::maps {
namespace {

using Precise = common::Vector3d;

void require(const FineMesh& mesh, double spacing) {
  if (!(spacing > 0))
    throw Error(Element::option, 0, fmt::format("spacing is {}; a length above zero is possible", spacing));
  const std::size_t vertices = mesh.positions.size() / 3;
  const auto fits = [&](std::size_t values) { return values == 0 || values == 3 * vertices; };
  if (mesh.positions.size() % 3 != 0 || mesh.triangles.size() % 3 != 0 || !fits(mesh.normals.size()) ||
      !fits(mesh.colours.size()))
    throw Error(Element::array, 0,
                fmt::format("the fine mesh has {} coordinates, {} of normals, {} of colours and {} indices; give three "
                            "for each vertex and triangle",
                            mesh.positions.size(), mesh.normals.size(), mesh.colours.size(), mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i] >= vertices)
      throw Error(Element::triangle, i / 3,
                  fmt::format("of the fine mesh has the vertex {}, but there are {}", mesh.triangles[i], vertices));
}

Precise vector_at(std::span<const float> values, std::size_t index) {
  return {static_cast<double>(values[3 * index]), static_cast<double>(values[3 * index + 1]),
          static_cast<double>(values[3 * index + 2])};
}

}  // namespace

MeshPoints::MeshPoints(const FineMesh& mesh, double spacing, std::string name)
    : mesh_(mesh), name_(std::move(name)), vertices_(mesh.positions.size() / 3) {
  schema_.position = stream::Number::float64;
  schema_.normals = !mesh.normals.empty() || !mesh.triangles.empty();
  if (!mesh.colours.empty())
    for (const char* colour : {"red", "green", "blue"}) schema_.channels.push_back({colour, stream::Number::uint8});
  first_.push_back(vertices_);
  constexpr double most_parts = 4096;  // of an edge
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, common::length(vector_at(mesh.positions, mesh.triangles[3 * t + (k + 1) % 3]) -
                                                 vector_at(mesh.positions, mesh.triangles[3 * t + k])));
    const double parts = std::isfinite(longest) ? std::clamp(std::ceil(longest / spacing), 1.0, most_parts) : 1;
    parts_.push_back(static_cast<std::uint16_t>(parts));
    first_.push_back(first_.back() + std::uint64_t{parts_.back()} * parts_.back());
  }
  add_vertex_normals();
}

// Vertices without a normal get the mean normal of their triangles.
void MeshPoints::add_vertex_normals() {
  normals_.resize(3 * vertices_);
  if (!mesh_.normals.empty()) {
    std::copy(mesh_.normals.begin(), mesh_.normals.end(), normals_.begin());
    return;
  }
  std::vector<Precise> sums(vertices_);
  for (std::size_t t = 0; t < mesh_.triangles.size(); t += 3) {
    const Precise a = vector_at(mesh_.positions, mesh_.triangles[t]);
    const Precise normal = common::cross(vector_at(mesh_.positions, mesh_.triangles[t + 1]) - a,
                                         vector_at(mesh_.positions, mesh_.triangles[t + 2]) - a);
    for (std::size_t k = 0; k < 3; ++k) sums[mesh_.triangles[t + k]] += normal;
  }
  for (std::size_t i = 0; i < vertices_; ++i) {
    const Precise normal = common::unit(sums[i]);
    for (std::size_t k = 0; k < 3; ++k) normals_[3 * i + k] = static_cast<float>(normal[k]);
  }
}

void MeshPoints::seek(std::uint64_t point) {
  if (point > first_.back())
    throw Error(Element::point, point, fmt::format("is beyond the {} points of {}", first_.back(), name_));
  next_ = point;
}

stream::Points MeshPoints::read(std::size_t most) {
  if (most == 0) throw Error(Element::option, 0, "most is 0; 1 or more is possible");
  const std::uint64_t end = std::min(first_.back(), next_ + most);
  positions_.clear();
  out_normals_.clear();
  channels_.clear();
  stream::Points points;
  points.first = next_;
  for (; next_ < end; ++next_) add_point(next_);
  points.positions = positions_;
  points.normals = out_normals_;
  points.channels = channels_;
  return points;
}

void MeshPoints::add_point(std::uint64_t index) {
  if (index < vertices_) {
    const auto vertex = static_cast<std::uint32_t>(index);
    add_mean({vertex, vertex, vertex}, {1, 0, 0});
    return;
  }
  const auto above = std::upper_bound(first_.begin(), first_.end(), index);
  const auto t = static_cast<std::size_t>(above - first_.begin()) - 1;
  const auto small = index - first_[t];
  const auto parts = static_cast<double>(parts_[t]);
  // Row r of small triangles has 2 r + 1 of them. Those with an even place point up.
  auto row = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(small)));
  while (row * row > small) --row;
  while ((row + 1) * (row + 1) <= small) ++row;
  const std::uint64_t place = small - row * row;
  const std::uint64_t pair = place / 2;
  const double third = place % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
  const double second = (static_cast<double>(pair) + third) / parts;
  const double first = (static_cast<double>(row) + (place % 2 == 0 ? 2 / 3.0 : 1 / 3.0)) / parts - second;
  add_mean({mesh_.triangles[3 * t], mesh_.triangles[3 * t + 1], mesh_.triangles[3 * t + 2]},
           {1 - first - second, first, second});
}

void MeshPoints::add_mean(const std::array<std::uint32_t, 3>& corners, const std::array<double, 3>& weights) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double position = mesh_.origin[axis];
    double normal = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      position += weights[k] * static_cast<double>(mesh_.positions[3 * std::size_t{corners[k]} + axis]);
      normal += weights[k] * static_cast<double>(normals_[3 * std::size_t{corners[k]} + axis]);
    }
    positions_.push_back(position);
    out_normals_.push_back(static_cast<float>(normal));
    if (mesh_.colours.empty()) continue;
    double colour = 0;
    for (std::size_t k = 0; k < 3; ++k)
      colour += weights[k] * static_cast<double>(mesh_.colours[3 * std::size_t{corners[k]} + axis]);
    channels_.push_back(colour);
  }
}

stream::Source mesh_source(const FineMesh& mesh, double spacing) {
  require(mesh, spacing);
  const std::string name = "the fine mesh";
  return {.name = name,
          .open = [mesh, spacing, name](const stream::ReadOptions&) -> std::unique_ptr<stream::PointReader> {
            return std::make_unique<MeshPoints>(mesh, spacing, name);
          },
          .identity = {}};
}

}  // namespace glark::maps
