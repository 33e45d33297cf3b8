// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where coarse triangles are on the screen: the captured records run through the application's vertex stage, at their
// corners, or at some points of the refined triangles too (curve_points.glsl).
#pragma once

#include <cstdint>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/state/bindings.h"

namespace glark::depth {

struct PositionRequest {
  const capture::Layout& layout;
  capture::CoarseTriangles triangles;
  const ScreenProgram& program;
};

class ScreenPositions {
 public:
  explicit ScreenPositions(const gl::Dispatch& gl) : gl_(gl) {}

  bool has_room(std::uint32_t triangles, int points) const;
  // False without memory. Rare path: wrap in an ErrorScope.
  bool reserve(std::uint32_t triangles, int points);
  // Writes the positions (vec4) to the start of buffer(). Changes the program and the vertex array, and for stored
  // records a storage buffer binding, which the caller restores.
  void capture(const PositionRequest& request, const core::Bindings& bindings);
  GLuint buffer() const { return buffer_.name(); }
  // Behind the positions there is room for a word for each triangle. Its place does not depend on their number.
  GLintptr words_offset(int points) const;
  void release();

 private:
  void prepare();
  void draw_corners(const PositionRequest& request);
  void draw_points(const PositionRequest& request);
  void draw_tail(const PositionRequest& request);

  const gl::Dispatch& gl_;
  core::GpuBuffer buffer_;
  core::GpuBuffer lattice_;  // the points, then the indices of draw_tail()
  GLuint feedback_ = 0;
  GLuint corner_array_ = 0;
  GLuint point_array_ = 0;
  int corner_chunks_ = 0;  // enabled in the vertex arrays
  int point_chunks_ = 0;
};

}  // namespace glark::depth
