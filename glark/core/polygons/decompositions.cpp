// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/decompositions.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "glark/core/capture/feedback_aside.h"
#include "glark/core/report/log.h"

namespace glark::polygons {
namespace {

std::int64_t bytes_of(const std::vector<float>& words) {
  return static_cast<std::int64_t>(words.size() * sizeof(float));
}

// Binds a new vertex array whose attribute 0 reads one float a vertex from the buffer.
GLuint bind_number_array(const gl::Dispatch& gl, GLuint buffer) {
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.BindVertexBuffer(0, buffer, 0, sizeof(float));
  gl.VertexAttribFormat(0, 1, GL_FLOAT, GL_FALSE, 0);
  gl.VertexAttribBinding(0, 0);
  gl.EnableVertexAttribArray(0);
  return array;
}

}  // namespace

std::optional<Decomposition> Decompositions::find(GLenum mode, GLenum convention) {
  const auto known = known_.find({mode, convention});
  if (known != known_.end()) {
    return known->second;
  }
  const std::vector<float> numbers = probe(mode, convention);
  if (numbers.empty()) {
    return std::nullopt;
  }
  const auto found = decomposition_of(mode, numbers);
  if (!found) {
    const char* name = mode == GL_QUADS ? "GL_QUADS" : mode == GL_QUAD_STRIP ? "GL_QUAD_STRIP" : "GL_POLYGON";
    core::log(core::LogLevel::warning,
              std::string("this GL cuts ") + name +
                  " into triangles that do not form polygons again: GL_POLYGON_CENTROID_ARK has no effect on them");
  }
  known_[{mode, convention}] = found;
  return found;
}

// Draws numbered vertices, and returns the numbers in the order of the corners that GL makes. Empty if GL captures
// nothing (conditional rendering, no memory).
std::vector<float> Decompositions::probe(GLenum mode, GLenum convention) {
  core::ErrorScope errors(env_.errors);
  const std::uint64_t triangles = core::triangles_of(mode, static_cast<std::uint64_t>(probe_vertices(mode)));
  const capture::Layout layout = capture::make_layout({{.name = "number", .type = GL_FLOAT, .location = 0}}, false);
  capture::CapturePlan plan{.layout = &layout, .convention = convention};
  {
    const capture::FeedbackAside aside(env_.gl, capture_.stage(), env_.bindings());
    plan.program = capture_.stage().program_for(layout, env_.ark.tag_attribute);
  }
  std::vector<float> corners(static_cast<std::size_t>(3 * triangles), -1.0F);
  const bool drawn =
      plan.program != 0 && capture_.stage().reserve(layout, triangles) && draw_probe(mode, plan, corners);
  if (!drawn || std::find(corners.begin(), corners.end(), -1.0F) != corners.end()) {
    corners.clear();
  }
  return corners;
}

bool Decompositions::draw_probe(GLenum mode, const capture::CapturePlan& plan, std::vector<float>& corners) {
  std::vector<float> numbers(static_cast<std::size_t>(probe_vertices(mode)));
  std::iota(numbers.begin(), numbers.end(), 0.0F);
  core::GpuBuffer input;
  core::GpuBuffer output;
  const bool allocated = input.allocate(env_.gl, bytes_of(numbers), numbers.data(), GL_STATIC_DRAW) &&
                         output.allocate(env_.gl, bytes_of(corners), corners.data(), GL_STREAM_READ);
  if (allocated) {
    const GLuint array = bind_number_array(env_.gl, input.name());
    capture_.begin(plan, {.count = capture::Count::known, .own = &output});
    env_.gl.DrawArrays(mode, 0, static_cast<GLsizei>(numbers.size()));
    capture_.end(plan, corners.size() / 3, true);
    programs_.use_application();
    env_.gl.BindVertexArray(env_.bindings().vertex_array);
    env_.gl.DeleteVertexArrays(1, &array);
    output.read(env_.gl, 0, bytes_of(corners), corners.data());
  }
  input.release(env_.gl);
  output.release(env_.gl);
  return allocated;
}

}  // namespace glark::polygons
