// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/segmentation.h"

#include <glark/vstree.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "glark/clients/maps/charts/overlap.h"

namespace glark::maps {
namespace {

// A triangle that is steeper over its chart's plane loses half of its texels or more.
constexpr float least_chart_cosine = 0.5F;

using Labels = std::vector<std::uint32_t>;  // the chart of each triangle

// The transition node of each triangle's centre, or its leaf where there is none.
Labels label_by_tree(const Surface& surface) {
  std::vector<float> centres, normals;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vector centre = (surface.positions[a] + surface.positions[b] + surface.positions[c]) * (1 / 3.0F);
    const Vector& normal = surface.triangle_normals[t];
    centres.insert(centres.end(), {centre.x, centre.y, centre.z});
    normals.insert(normals.end(), {normal.x, normal.y, normal.z});
  }
  vstree::Options options;
  options.threshold = 0;
  options.delta_a = least_chart_cosine;
  options.delta_d = 1;
  const vstree::Tree tree({.positions = centres, .normals = normals}, options);
  Labels labels(surface.triangles.size());
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const vstree::Node& node = tree.nodes()[i];
    const bool is_chart = node.kind == vstree::Kind::transition || (node.is_leaf() && node.frame == vstree::none);
    if (!is_chart) continue;
    for (const std::uint32_t t : tree.samples(node)) labels[t] = i;
  }
  return labels;
}

// Divides each label into its parts that are connected across edges. Labels are 0, 1, ... afterwards.
std::uint32_t connect(const Surface& surface, bool cut, Labels& labels) {
  Labels parts(labels.size(), none);
  std::uint32_t count = 0;
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < labels.size(); ++first) {
    if (parts[first] != none) continue;
    parts[first] = count;
    open.assign(1, first);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t neighbour = surface.neighbours[t][k];
        if (cut && is_hard(surface, t, k)) continue;
        if (neighbour == none || parts[neighbour] != none || labels[neighbour] != labels[first]) continue;
        parts[neighbour] = count;
        open.push_back(neighbour);
      }
    }
    ++count;
  }
  labels = std::move(parts);
  return count;
}

// Joins charts while their triangles face one side. Small charts come first: each has a gutter and seams, which cost
// texels.
class Merger {
 public:
  Merger(const Surface& surface, bool cut, Labels& labels, std::uint32_t count)
      : surface_(surface), cut_(cut), labels_(labels), triangles_(count), normals_(count) {
    for (std::uint32_t t = 0; t < labels.size(); ++t) {
      triangles_[labels[t]].push_back(t);
      normals_[labels[t]] += area_normal(t);
    }
  }

  void merge() {
    std::vector<std::uint32_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return triangles_[a].size() < triangles_[b].size(); });
    for (const std::uint32_t chart : order) merge_into_neighbour(chart);
  }

 private:
  Vector area_normal(std::uint32_t t) const {
    const auto& [a, b, c] = surface_.triangles[t];
    return common::cross(surface_.positions[b] - surface_.positions[a], surface_.positions[c] - surface_.positions[a]);
  }

  void merge_into_neighbour(std::uint32_t chart) {
    if (triangles_[chart].empty()) return;
    std::map<std::uint32_t, float> borders;  // neighbour -> length of the common border; below 0: it is partly hard
    for (const std::uint32_t t : triangles_[chart]) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t neighbour = surface_.neighbours[t][k];
        if (neighbour == none || labels_[neighbour] == chart) continue;
        const auto& corners = surface_.triangles[t];
        float& border = borders[labels_[neighbour]];
        const float length = common::length(surface_.positions[corners[(k + 1) % 3]] - surface_.positions[corners[k]]);
        border = border < 0 || (cut_ && is_hard(surface_, t, k)) ? -1 : border + length;
      }
    }
    std::vector<std::pair<float, std::uint32_t>> longest;
    for (const auto& [neighbour, length] : borders)
      if (length >= 0) longest.emplace_back(-length, neighbour);
    std::sort(longest.begin(), longest.end());
    for (const auto& [unused, neighbour] : longest) {
      if (!faces_one_side(chart, neighbour)) continue;
      join(chart, neighbour);
      return;
    }
  }

  bool faces_one_side(std::uint32_t a, std::uint32_t b) const {
    const Vector normal = common::unit(normals_[a] + normals_[b]);
    const auto is_flat = [&](std::uint32_t t) {
      const Vector& n = surface_.triangle_normals[t];
      return common::is_zero(n) || common::dot(n, normal) >= least_chart_cosine;
    };
    return std::all_of(triangles_[a].begin(), triangles_[a].end(), is_flat) &&
           std::all_of(triangles_[b].begin(), triangles_[b].end(), is_flat);
  }

  void join(std::uint32_t from, std::uint32_t to) {
    for (const std::uint32_t t : triangles_[from]) labels_[t] = to;
    triangles_[to].insert(triangles_[to].end(), triangles_[from].begin(), triangles_[from].end());
    triangles_[from].clear();
    normals_[to] += normals_[from];
  }

  const Surface& surface_;
  bool cut_;
  Labels& labels_;
  std::vector<std::vector<std::uint32_t>> triangles_;
  std::vector<Vector> normals_;
};

}  // namespace

std::vector<Chart> segment(const Surface& surface, bool cut) {
  Labels labels = label_by_tree(surface);
  const std::uint32_t count = connect(surface, cut, labels);
  Merger(surface, cut, labels, count).merge();
  std::vector<Chart> charts(connect(surface, cut, labels));
  for (std::uint32_t t = 0; t < labels.size(); ++t) charts[labels[t]].triangles.push_back(t);
  // New charts are appended, and divided as well if they overlap.
  for (std::size_t i = 0; i < charts.size(); ++i) {
    lay_out(charts[i], surface);
    Chart rest = cut_overlap(charts[i], surface);
    if (rest.triangles.empty()) continue;
    charts.push_back(std::move(rest));
    --i;  // the remaining triangles may overlap, too
  }
  return charts;
}

}  // namespace glark::maps
