// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The curvature of a mesh at its vertices.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::depth {

// Based on: S. Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 3DPVT 2004. The tensor of
// a face best explains how the normals of its corners differ (section 3.1). It is rotated into the tangent planes of
// the corners (3.2). At a corner, its weight is the part of the face that is nearest to the corner (3.3).
class CurvatureTensors {
 public:
  using Vector = common::Vector3f;
  // The numbers (e, f, g) of the second fundamental form [e f; f g].
  using Tensor = Vector;
  struct Axes {
    Vector first, second;
  };

  CurvatureTensors(std::size_t vertices, std::size_t triangles)
      : normals_(vertices), axes_(vertices), tensors_(vertices), areas_(vertices), corner_areas_(triangles) {}

  // Normals may have any length. The normals of the faces replace zero normals and an empty array.
  void find(std::span<const std::uint32_t> triangles, std::span<const float> positions, std::span<const float> normals);
  // The principal curvatures at a vertex, the greater one first.
  std::pair<float, float> principal(std::size_t vertex) const;

 private:
  void find_normals(std::span<const std::uint32_t> triangles, std::span<const float> positions,
                    std::span<const float> normals);
  void find_areas(std::span<const std::uint32_t> triangles, std::span<const float> positions);
  void find_axes(std::span<const std::uint32_t> triangles, std::span<const float> positions);
  void add_tensor(std::span<const std::uint32_t> triangles, std::span<const float> positions, std::size_t triangle);

  std::vector<Vector> normals_;
  std::vector<Axes> axes_;  // the axes of the tangent planes
  std::vector<Tensor> tensors_;
  std::vector<float> areas_;          // for each vertex: the sum of the parts of faces that are nearest to it
  std::vector<Vector> corner_areas_;  // for each triangle: the parts nearest to its corners
};

}  // namespace glark::depth
