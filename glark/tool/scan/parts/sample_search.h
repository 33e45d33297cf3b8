// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// A vertex of a large mesh.
struct MeshVertex {
  std::array<float, 3> position, normal;  // relative to the samples' origin
};

// Finds the sample that a vertex becomes.
class SampleSearch {
 public:
  static constexpr std::uint32_t no_sample = 0xFFFFFFFF;

  // samples: positions, and normals if the vertices have some. They must stay where they are.
  explicit SampleSearch(const geometry::Geometry& samples);
  ~SampleSearch();

  MeshVertex vertex_of(const std::array<double, 3>& position, const std::array<float, 3>& normal) const;
  // The nearest sample on the same side of the surface, if the normals tell the side; else the nearest one. no_sample
  // for a position that is not finite. Several threads may call it.
  std::uint32_t sample_of(const MeshVertex& vertex) const;

 private:
  struct Tree;
  const geometry::Geometry& samples_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace glark::tool
