// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/overlays.h"

#include <algorithm>
#include <bit>

namespace glark::core {
namespace {

constexpr std::size_t fewest_common = 3;
constexpr std::size_t probes = 16;

std::uint64_t number_of(const Point& point) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const float coordinate : point) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(coordinate + 0.0F)) * 0xff51afd7ed558ccdU;  // -0 becomes 0
    hash ^= hash >> 32U;
  }
  return hash;
}

// A cheap look at a few points. Most pairs of draws have no common point.
bool may_lie_on(const std::vector<std::uint64_t>& overlay, const std::vector<std::uint64_t>& mesh) {
  const std::size_t step = std::max<std::size_t>(overlay.size() / probes, 1);
  for (std::size_t i = 0; i < overlay.size(); i += step) {
    if (std::binary_search(mesh.begin(), mesh.end(), overlay[i])) return true;
  }
  return false;
}

std::size_t count_common(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::size_t common = 0;
  for (auto left = a.begin(), right = b.begin(); left != a.end() && right != b.end();) {
    common += *left == *right ? 1 : 0;
    const bool left_first = *left <= *right;
    right += *right <= *left ? 1 : 0;
    left += left_first ? 1 : 0;
  }
  return common;
}

}  // namespace

std::vector<std::uint64_t> distinct_points(std::span<const Point> points) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(points.size());
  for (const Point& point : points) numbers.push_back(number_of(point));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

bool lies_on(const std::vector<std::uint64_t>& overlay, const std::vector<std::uint64_t>& mesh) {
  if (!may_lie_on(overlay, mesh)) {
    return false;
  }
  const std::size_t common = count_common(overlay, mesh);
  return common >= fewest_common && (2 * common >= overlay.size() || 4 * common >= mesh.size());
}

void Overlays::add_overlay(const MeshKey& key, std::span<const Point> points) {
  const auto [entry, added] = overlays_.emplace(key, distinct_points(points));
  points_ += added ? entry->second.size() : 0;
  for (auto& [mesh_key, mesh] : meshes_) {
    mesh.covered = mesh.covered || (!(mesh_key == key) && lies_on(entry->second, mesh.points));
  }
}

void Overlays::add_mesh(const MeshKey& key, std::span<const Point> points) {
  Mesh& mesh = meshes_[key];
  mesh.points = distinct_points(points);
  points_ += mesh.points.size();
  mesh.covered = std::any_of(overlays_.begin(), overlays_.end(), [&](const auto& overlay) {
    return !(overlay.first == key) && lies_on(overlay.second, mesh.points);
  });
}

bool Overlays::covers(const MeshKey& mesh) const {
  const auto found = meshes_.find(mesh);
  return found != meshes_.end() && found->second.covered;
}

}  // namespace glark::core
