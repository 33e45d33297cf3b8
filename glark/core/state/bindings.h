// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The part of the context's state that a refined draw changes or depends on. The hooks keep it up to date, so that
// drawing needs no glGet.
#pragma once

#include <array>
#include <cstdint>

#include "glark/core/state/active_queries.h"
#include "glark/core/state/capabilities.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

inline constexpr int tracked_storage_bindings = 5;  // indexed bindings of shader storage that our compute passes use

struct IndexedBuffer {
  GLuint buffer = 0;
  GLintptr offset = 0;
  GLsizeiptr size = 0;  // 0: the whole buffer (glBindBufferBase)
};

struct TransformFeedbackBindings {
  GLuint object = 0;
  bool active = false;
  bool paused = false;
  bool ours = false;  // it captures refined triangles: between our draws we pause it
  GLuint buffer = 0;  // generic binding point of GL_TRANSFORM_FEEDBACK_BUFFER
};

struct PolygonModes {
  GLenum front = GL_FILL;
  GLenum back = GL_FILL;
  // GL_FILL only if both faces have it.
  GLenum either() const { return front == GL_FILL ? back : front; }
  bool operator==(const PolygonModes&) const = default;
};

struct Culling {
  bool enabled = false;
  GLenum face = GL_BACK;  // glCullFace
  GLenum front_face = GL_CCW;
  bool operator==(const Culling&) const = default;
};

// The modes that the plan of a draw depends on. keep/repeated_draws.h compares all of them.
struct PlannedModes {
  bool rasterizer_discard = false;
  std::uint8_t clip_distances = 0;  // bit i: GL_CLIP_DISTANCEi; not in OpenGL ES
  bool blend = false;               // of draw buffer 0
  bool depth_test = false;
  bool depth_writes = true;
  GLenum depth_function = GL_LESS;
  bool stencil_test = false;
  bool polygon_offset = false;  // GL_POLYGON_OFFSET_FILL
  bool color_writes = true;     // of draw buffer 0, of any channel
  bool primitive_restart = false;
  bool primitive_restart_fixed = false;
  bool vertex_program = false;  // GL_VERTEX_PROGRAM_ARB
  bool two_side = false;        // GL_VERTEX_PROGRAM_TWO_SIDE
  PolygonModes polygon_modes = {};
  Culling culling = {};
  GLenum shade_model = GL_SMOOTH;
  bool clamp_vertex_color = true;      // compatibility only
  bool clamps_by_framebuffer = false;  // GL_FIXED_ONLY: not if the framebuffer has floating-point colours
  GLenum provoking_vertex = GL_LAST_VERTEX_CONVENTION;
  GLenum render_mode = GL_RENDER;
  bool operator==(const PlannedModes&) const = default;
};

struct Bindings : PlannedModes {
  bool stale = true;  // a call that the hooks cannot follow may have changed any of them
  GLuint program = 0;
  GLuint pipeline = 0;
  GLuint vertex_array = 0;
  TransformFeedbackBindings transform_feedback = {};
  GLuint draw_indirect_buffer = 0;
  GLuint parameter_buffer = 0;
  GLuint query_buffer = 0;
  GLuint storage_buffer = 0;
  std::array<IndexedBuffer, tracked_storage_bindings> storage{};
  GLenum matrix_mode = GL_MODELVIEW;
  std::array<float, 2> viewport{};  // width and height
  GLuint list_base = 0;
  bool debug_output = false;
  ActiveQueries queries = {};
};

constexpr GLenum clip_distance_count = 8;  // every OpenGL 3.0 has as many

// Reads all of them from GL, except for the queries.
void read_bindings(const gl::Dispatch& gl, const Capabilities& capabilities, Bindings& bindings);

}  // namespace glark::core
