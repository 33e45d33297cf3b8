// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/measure/screen_positions.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "glark/core/pattern/pieces.glsl.h"

namespace glark::depth {
namespace {

constexpr std::int64_t position_bytes = 16;
constexpr GLsizei chunk_bytes = 16;
constexpr GLuint record_binding = 0;
constexpr GLuint lattice_binding = 1;

// The barycentrics of corners 1 and 2, in units of the lattice. The order is that of curve_points.glsl.
using Point = std::array<std::uint16_t, 2>;
constexpr std::uint16_t one = 32768;
static_assert(one == pattern::lattice_one);
constexpr std::uint16_t quarter = one / 4;
constexpr std::uint16_t half = one / 2;
constexpr std::uint16_t three_quarters = 3 * quarter;
constexpr std::uint16_t third = 10923;  // of the centre: the nearest number
constexpr std::array<Point, points_of_any_curve> lattice_points{{{0, 0},
                                                                 {one, 0},
                                                                 {0, one},
                                                                 {quarter, 0},
                                                                 {three_quarters, 0},
                                                                 {three_quarters, quarter},
                                                                 {quarter, three_quarters},
                                                                 {0, three_quarters},
                                                                 {0, quarter},
                                                                 {third, third},
                                                                 {half, 0},
                                                                 {half, half},
                                                                 {0, half}}};

struct Lattice {
  std::array<Point, points_of_any_curve> points = lattice_points;
  // The last one or two triangles, which the feedback needs as three vertices.
  std::array<std::array<std::uint8_t, 3>, 2> tails{{{0, 0, 0}, {0, 1, 1}}};
};
constexpr std::int64_t bytes_a_triangle(int points) { return points * position_bytes + 4; }

void enable_chunks(const gl::Dispatch& gl, GLuint first, int from, int to) {
  for (int chunk = from; chunk < to; ++chunk) {
    const GLuint location = first + static_cast<GLuint>(chunk);
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribFormat(location, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(chunk * chunk_bytes));
    gl.VertexAttribBinding(location, record_binding);
  }
  for (int chunk = to; chunk < from; ++chunk) {
    gl.DisableVertexAttribArray(first + static_cast<GLuint>(chunk));
  }
}

}  // namespace

// The positions of the last triangles take whole threes.
GLintptr ScreenPositions::words_offset(int points) const {
  const std::int64_t triangles = (buffer_.size() - 2 * points * position_bytes) / bytes_a_triangle(points);
  return static_cast<GLintptr>((triangles + 2) * points * position_bytes);
}

bool ScreenPositions::has_room(std::uint32_t triangles, int points) const {
  return feedback_ != 0 &&
         (std::int64_t{triangles} * bytes_a_triangle(points)) + 2 * points * position_bytes <= buffer_.size();
}

bool ScreenPositions::reserve(std::uint32_t triangles, int points) {
  prepare();
  const bool has_points = points == corners_only || lattice_.name() != 0 ||
                          lattice_.allocate(gl_, sizeof(Lattice), std::array{Lattice{}}.data(), GL_STATIC_DRAW);
  const std::int64_t bytes = (std::int64_t{triangles} * bytes_a_triangle(points)) + 2 * points * position_bytes;
  return has_points && buffer_.reserve(gl_, bytes, GL_DYNAMIC_COPY);
}

void ScreenPositions::prepare() {
  if (feedback_ == 0) {
    gl_.GenTransformFeedbacks(1, &feedback_);
    gl_.GenVertexArrays(1, &corner_array_);
    gl_.GenVertexArrays(1, &point_array_);
  }
}

void ScreenPositions::capture(const PositionRequest& request, const core::Bindings& bindings) {
  gl_.UseProgram(request.program.name);
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  gl_.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_.name(), 0, words_offset(request.program.points));
  gl_.BindBuffer(
      GL_TRANSFORM_FEEDBACK_BUFFER,
      bindings.transform_feedback.buffer);  // only the generic binding point: the indexed one belongs to the object
  if (!bindings.rasterizer_discard) {
    gl_.Enable(GL_RASTERIZER_DISCARD);
  }
  gl_.BeginTransformFeedback(GL_TRIANGLES);
  if (request.program.points == corners_only) {
    draw_corners(request);
  } else {
    draw_points(request);
  }
  gl_.EndTransformFeedback();
  if (!bindings.rasterizer_discard) {
    gl_.Disable(GL_RASTERIZER_DISCARD);
  }
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings.transform_feedback.object);
}

void ScreenPositions::draw_corners(const PositionRequest& request) {
  const capture::Layout& layout = request.layout;
  gl_.BindVertexArray(corner_array_);
  enable_chunks(gl_, 0, corner_chunks_, layout.corner_chunk_count());
  corner_chunks_ = layout.corner_chunk_count();
  gl_.BindVertexBuffer(record_binding, request.triangles.buffer, request.triangles.offset, layout.corner_words * 4);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * request.triangles.count));
}

// A vertex is a triangle, and an instance is a point: a triangle for each instance would cost several times as much.
void ScreenPositions::draw_points(const PositionRequest& request) {
  const capture::Layout& layout = request.layout;
  const ScreenProgram& program = request.program;
  gl_.BindVertexArray(point_array_);
  const int chunks = program.first_word < 0 ? layout.chunk_count() : 0;
  enable_chunks(gl_, program.first_chunk, point_chunks_, chunks);
  point_chunks_ = chunks;
  gl_.EnableVertexAttribArray(program.lattice);
  gl_.VertexAttribFormat(program.lattice, 2, GL_UNSIGNED_SHORT, GL_FALSE, 0);
  gl_.VertexAttribBinding(program.lattice, lattice_binding);
  gl_.VertexBindingDivisor(lattice_binding, 1);
  gl_.BindVertexBuffer(lattice_binding, lattice_.name(), 0, sizeof(Point));
  gl_.BindVertexBuffer(record_binding, request.triangles.buffer, request.triangles.offset, layout.triangle_words() * 4);
  if (program.first_word >= 0) {
    gl_.ProgramUniform1i(program.name, program.first_word, static_cast<GLint>(request.triangles.offset / 4));
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, program.records_binding, request.triangles.buffer);
  }
  const auto whole = static_cast<GLsizei>(request.triangles.count - request.triangles.count % 3);
  if (whole > 0) {
    gl_.DrawArraysInstanced(GL_TRIANGLES, 0, whole, program.points);
  }
  draw_tail(request);
}

// The feedback takes triangles, as the application's own feedback may: Mesa keeps the mode of a paused one in the
// context. So the vertices of an instance must come in threes.
void ScreenPositions::draw_tail(const PositionRequest& request) {
  const auto count = static_cast<GLint>(request.triangles.count);
  const GLint left = count % 3;
  if (left == 0) {
    return;
  }
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, lattice_.name());
  const std::size_t at = offsetof(Lattice, tails) + 3 * (static_cast<std::size_t>(left) - 1);
  gl_.DrawElementsInstancedBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, reinterpret_cast<const void*>(at),
                                      request.program.points, count - left);
}

void ScreenPositions::release() {
  if (feedback_ != 0) {
    gl_.DeleteTransformFeedbacks(1, &feedback_);
    gl_.DeleteVertexArrays(1, &corner_array_);
    gl_.DeleteVertexArrays(1, &point_array_);
    feedback_ = 0;
  }
  corner_chunks_ = point_chunks_ = 0;
  buffer_.release(gl_);
  lattice_.release(gl_);
}

}  // namespace glark::depth
