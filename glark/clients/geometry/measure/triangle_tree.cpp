// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/triangle_tree.h"

#include <limits>
#include <numeric>
#include <utility>

namespace glark::geometry {
namespace {

constexpr std::uint32_t most_in_leaf = 4;
constexpr std::size_t deepest = 64;  // each level halves the number of triangles

double square_to_box(const Vector& from, const Vector& low, const Vector& high) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double outside = std::max({low[axis] - from[axis], 0.0, from[axis] - high[axis]});
    square += outside * outside;
  }
  return square;
}

}  // namespace

TriangleTree::TriangleTree(const Geometry& geometry, const std::array<double, 3>& shift)
    : geometry_(geometry), shift_(shift), order_(geometry.triangle_count()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Box> boxes(order_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::array<Vector, 3> corners = corners_of(i);
    boxes[i] = {least(least(corners[0], corners[1]), corners[2]),
                greatest(greatest(corners[0], corners[1]), corners[2])};
  }
  nodes_.reserve(order_.size());
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size()), 0});
  for (std::size_t i = 0; i < nodes_.size(); ++i) split(i, boxes);
}

std::array<Vector, 3> TriangleTree::corners_of(std::size_t triangle) const {
  std::array<Vector, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t point = geometry_.triangles[3 * triangle + k];
    for (std::size_t axis = 0; axis < 3; ++axis)
      corners[k][axis] = static_cast<double>(geometry_.positions[3 * point + axis]) + shift_[axis];
  }
  return corners;
}

// Computes the box of the node. Divides its triangles in two halves, along the axis on which their middles extend most.
void TriangleTree::split(std::size_t node, const std::vector<Box>& boxes) {
  const std::uint32_t begin = nodes_[node].begin, end = nodes_[node].end;
  Box box = boxes[order_[begin]];
  Vector low = box.low + box.high, high = low;  // twice the middles
  for (std::uint32_t i = begin; i < end; ++i) {
    const Box& other = boxes[order_[i]];
    box = {least(box.low, other.low), greatest(box.high, other.high)};
    low = least(low, other.low + other.high);
    high = greatest(high, other.low + other.high);
  }
  nodes_[node].box = box;
  if (end - begin <= most_in_leaf) return;
  const Vector size = high - low;
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return boxes[a].low[axis] + boxes[a].high[axis] < boxes[b].low[axis] + boxes[b].high[axis];
                   });
  nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, middle, 0});
  nodes_.push_back({{}, middle, end, 0});
}

double TriangleTree::square_to(const Vector& from, std::uint32_t triangle) const {
  return squared_distance(from, nearest_on_triangle(from, corners_of(triangle)));
}

TriangleTree::Nearest TriangleTree::nearest_to(const Vector& from, std::uint32_t guess, double enough) const {
  Nearest best{guess, square_to(from, guess)};
  std::array<std::pair<std::uint32_t, double>, deepest> waiting;  // nodes and their squared distances
  std::size_t count = 0;
  waiting[count++] = {0, 0};
  while (count > 0 && best.square > enough) {
    const auto [index, square] = waiting[--count];
    if (square >= best.square) continue;
    const Node& node = nodes_[index];
    for (std::uint32_t i = node.begin; node.children == 0 && i < node.end; ++i) {
      if (const double other = square_to(from, order_[i]); other < best.square) best = {order_[i], other};
    }
    if (node.children == 0) continue;
    std::pair<std::uint32_t, double> near{node.children, 0}, far{node.children + 1, 0};
    for (auto* const child : {&near, &far})
      child->second = square_to_box(from, nodes_[child->first].box.low, nodes_[child->first].box.high);
    if (far.second < near.second) std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  return best;
}

}  // namespace glark::geometry
