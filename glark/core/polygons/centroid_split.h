// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_POLYGON_CENTROID_ARK: each polygon of n vertices becomes n coarse triangles (V_k, V_k+1, centroid). They replace
// the triangles that GL made. If the layout holds tags, the new records hold the depths of edges 0, 1 and 2 in their
// place.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <span>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/polygons/decomposition.h"
#include "glark/gl/dispatch.h"

namespace glark::polygons {

struct SplitRequest {
  const capture::Layout* layout = nullptr;
  capture::CoarseTriangles triangles;  // triangles of quads, or of one polygon; then their count is exact
  Decomposition decomposition;
  unsigned pool_level = 0;
  int depth_steps = 1;  // steps of a level
  std::span<const std::uint32_t> sides =
      {};  // sides of each polygon, if there are several fans; counts need not be exact then

  std::uint32_t polygons() const {
    return !sides.empty() ? static_cast<std::uint32_t>(sides.size()) : decomposition.fan ? 1 : triangles.count / 2;
  }
  // Sides of every polygon; 0: they differ.
  std::uint32_t equal_sides() const { return !sides.empty() ? 0 : decomposition.fan ? triangles.count + 2 : 4; }
  std::uint32_t records() const {
    return sides.empty() ? polygons() * equal_sides() : std::accumulate(sides.begin(), sides.end(), 0U);
  }
};

class CentroidSplit {
 public:
  explicit CentroidSplit(const gl::Dispatch& gl) : gl_(gl) {}

  bool has_room(const SplitRequest& request) const;
  // Compiles the passes when first called; false without memory. Rare path: wrap in an ErrorScope.
  bool reserve(const SplitRequest& request);
  // Changes the program and the storage buffer bindings 0 to 4, which the caller restores. The records are valid until
  // the next split. `captured_count`: holds the CountCommand of triangles that are counted on the GPU.
  capture::CoarseTriangles split(const SplitRequest& request, GLuint captured_count);

  // The count of the last split, if it is on the GPU.
  const core::GpuBuffer& count_command() const { return count_command_; }
  void release();

 private:
  static constexpr std::size_t uniform_count = 11;
  bool compile();
  bool prepare();
  void write_table(const SplitRequest& request);
  void set_uniforms(const core::ComputePass& pass, const SplitRequest& request) const;

  const gl::Dispatch& gl_;
  std::array<core::ComputePass, 2> passes_;
  core::GpuBuffer records_;  // and the centroids
  core::GpuBuffer count_command_;
  core::GpuBuffer table_;  // sizes of polygons that differ
  GLint64 largest_block_ = 0;
};

}  // namespace glark::polygons
