// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/triangle_tree.h"

#include <Eigen/Geometry>

#include <limits>
#include <numeric>

#include <unsupported/Eigen/BVH>

namespace glark::geometry {
namespace {

using Box = Eigen::AlignedBox3d;

Eigen::Vector3d eigen(const Vector& v) { return {v.x, v.y, v.z}; }

}  // namespace

struct TriangleTree::Boxes {
  Eigen::KdBVH<double, 3, std::uint32_t> tree;
};

namespace {

// What BVMinimize() asks for. Boxes that cannot have a nearer triangle are infinitely far.
class Search {
 public:
  using Scalar = double;

  Search(const TriangleTree& tree, const Vector& from, std::uint32_t guess, double enough)
      : tree_(tree), from_(from), point_(eigen(from)), enough_(enough), best_{guess, square_to(guess)} {}

  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  double minimumOnVolume(const Box& box) const {
    const double square = box.squaredExteriorDistance(point_);
    return square < best_.square && best_.square > enough_ ? square : std::numeric_limits<double>::infinity();
  }
  double minimumOnObject(std::uint32_t triangle) {
    if (best_.square > enough_) {
      if (const double square = square_to(triangle); square < best_.square) best_ = {triangle, square};
    }
    return best_.square;
  }
  // NOLINTEND(readability-identifier-naming)
  const TriangleTree::Nearest& best() const { return best_; }

 private:
  double square_to(std::uint32_t triangle) const {
    return squared_distance(from_, nearest_on_triangle(from_, tree_.corners_of(triangle)));
  }

  const TriangleTree& tree_;
  Vector from_;
  Eigen::Vector3d point_;
  double enough_;
  TriangleTree::Nearest best_;
};

}  // namespace

TriangleTree::TriangleTree(const Geometry& geometry, const std::array<double, 3>& shift)
    : geometry_(geometry), shift_(shift), boxes_(std::make_unique<Boxes>()) {
  std::vector<std::uint32_t> triangles(geometry.triangle_count());
  std::iota(triangles.begin(), triangles.end(), 0U);
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const Vector& corner : corners_of(i)) boxes[i].extend(eigen(corner));
  boxes_->tree.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
}

TriangleTree::~TriangleTree() = default;

std::array<Vector, 3> TriangleTree::corners_of(std::size_t triangle) const {
  std::array<Vector, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t point = geometry_.triangles[3 * triangle + k];
    for (std::size_t axis = 0; axis < 3; ++axis)
      corners[k][axis] = static_cast<double>(geometry_.positions[3 * point + axis]) + shift_[axis];
  }
  return corners;
}

TriangleTree::Nearest TriangleTree::nearest_to(const Vector& from, std::uint32_t guess, double enough) const {
  Search search(*this, from, guess, enough);
  Eigen::BVMinimize(boxes_->tree, search);
  return search.best();
}

}  // namespace glark::geometry
