// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edge depths that nobody has tagged: from the ends of an edge on the screen, and from the normals there. All on the GPU: the
// captured corners run once more through the application's vertex stage, and a compute pass looks at pairs of them.
#pragma once

#include <array>
#include <string>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/depth/measured_depths.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/refinement.h"
#include "glark/core/state/bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::depth {

struct MeasureRequest {
  const capture::Layout* layout = nullptr;
  capture::CoarseTriangles triangles;
  GLuint corner_program = 0;  // gives gl_Position of one captured corner; 0: the screen does not count
  int normal_offset = -1;     // of the normal in a captured corner; -1: normals do not count
  unsigned pool_level = 0;
  int depth_steps = 1;  // to a level: 1, or pattern::morph_steps
};

class MeasureStage {
 public:
  MeasureStage(const gl::Dispatch& gl, capture::Language language) : gl_(gl), language_(language) {}

  bool has_room(std::uint32_t triangles) const;
  // Compiles the passes when first called; false without memory. Rare path: wrap in an ErrorScope.
  bool reserve(std::uint32_t triangles);
  // A frame has ended: what it drew decides, under a budget, how coarse the next one is.
  void frame_finished() { frame_finished_ = true; }
  // `work`: BinStage::work_buffer(). Changes the program, the vertex array and the storage buffer bindings 0 to 2, which the
  // caller restores. The ends are valid until the next call.
  EdgeEnds find_ends(const MeasureRequest& request, const core::EdgeMeasure& rule, GLuint work,
                     const core::Bindings& bindings);
  // From what find_ends() has left.
  MeasuredDepths measure(const MeasureRequest& request, const core::Bindings& bindings);
  void release();

 private:
  struct LimitsPass {
    GLuint program = 0;
    GLint pixels = -1;
    GLint radians = -1;
    GLint budget = -1;
    GLint restart = -1;
    GLint most_change = -1;
  };
  struct DepthPass {
    GLuint program = 0;
    std::array<GLint, 10> uniform{};
    GLint half_size = -1;
  };

  GLuint compile(int pass) const;
  bool prepare();
  void update_limits(const core::EdgeMeasure& rule, bool morphs, GLuint work);
  void capture_positions(const MeasureRequest& request, const core::Bindings& bindings);

  const gl::Dispatch& gl_;
  capture::Language language_;
  LimitsPass limits_pass_;
  DepthPass depth_pass_;
  core::GpuBuffer limits_;
  core::GpuBuffer ends_;  // four words for each corner, then a word for each triangle
  GLuint feedback_ = 0;
  GLuint vertex_array_ = 0;
  int enabled_chunks_ = 0;
  core::EdgeMeasure rule_;  // that the limits were made for
  bool frame_finished_ = false;
};

}  // namespace glark::depth
