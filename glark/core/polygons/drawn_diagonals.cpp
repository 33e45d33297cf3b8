// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/drawn_diagonals.h"

#include <utility>

#include "glark/core/objects/error_scope.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/shader.h"

namespace glark::polygons {
namespace {

constexpr float nothing_drawn = -1;

// Two corners that face each other have the value 1, the other two have 0. The middle has that of the diagonal's ends.
constexpr char vertex_source[] = R"(#version 430
layout(location = 0) in vec2 position;
out float value;
void main() {
  gl_Position = vec4(position, 0.5, 1.0);
  value = position.x * position.y > 0.0 ? 1.0 : 0.0;
}
)";
constexpr char fragment_source[] = R"(#version 430
in float value;
layout(std430, binding = 0) buffer Result { float middle; };
void main() {
  if (all(lessThan(gl_FragCoord.xy, vec2(1.0)))) {
    middle = value;
  }
  discard;
}
)";

// In the order of their numbers in `mode`. Returns x and y of each vertex. Of 3 x 3 pixels, the quad covers all samples of
// the one in the middle.
constexpr std::array<float, 8> corners_of(GLenum mode) {
  return mode == GL_QUADS ? std::array<float, 8>{-.5F, -.5F, .5F, -.5F, .5F, .5F, -.5F, .5F}
                          : std::array<float, 8>{-.5F, -.5F, .5F, -.5F, -.5F, .5F, .5F, .5F};
}

void draw_immediate(const gl::Dispatch& gl, GLenum mode) {
  const std::array<float, 8> corners = corners_of(mode);
  gl.Begin(mode);
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    gl.Vertex2f(corners[i], corners[i + 1]);
  }
  gl.End();
}

void draw_list(const gl::Dispatch& gl, GLenum mode) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  draw_immediate(gl, mode);
  gl.EndList();
  gl.CallList(list);
  gl.DeleteLists(list, 1);
}

// The vertex array is ours.
void draw_arrays(const gl::Dispatch& gl, GLenum mode, bool indexed) {
  const std::array<float, 8> corners = corners_of(mode);
  constexpr std::array<GLushort, 4> numbers{0, 1, 2, 3};
  core::GpuBuffer vertices;
  core::GpuBuffer indices;
  if (vertices.allocate(gl, sizeof(corners), corners.data(), GL_STATIC_DRAW) &&
      indices.allocate(gl, sizeof(numbers), numbers.data(), GL_STATIC_DRAW)) {
    gl.BindVertexBuffer(0, vertices.name(), 0, 2 * sizeof(float));
    gl.VertexAttribFormat(0, 2, GL_FLOAT, GL_FALSE, 0);
    gl.VertexAttribBinding(0, 0);
    gl.EnableVertexAttribArray(0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    indexed ? gl.DrawElements(mode, 4, GL_UNSIGNED_SHORT, nullptr) : gl.DrawArrays(mode, 0, 4);
  }
  vertices.release(gl);
  indices.release(gl);
}

// Switches off everything that may drop the fragment in the middle or change the way the quad is drawn. The middle is
// pixel 0, which every framebuffer has. The caller saves GL_ENABLE_BIT and GL_VIEWPORT_BIT.
void show_one_pixel(const gl::Dispatch& gl) {
  constexpr GLenum obstacles[] = {GL_SCISSOR_TEST,
                                  GL_DEPTH_TEST,
                                  GL_STENCIL_TEST,
                                  GL_CULL_FACE,
                                  GL_POLYGON_STIPPLE,
                                  GL_SAMPLE_COVERAGE,
                                  GL_SAMPLE_ALPHA_TO_COVERAGE};
  constexpr GLenum clip_distances = 8;
  for (const GLenum obstacle : obstacles) {
    gl.Disable(obstacle);
  }
  if (gl.DepthBoundsEXT != nullptr) {
    gl.Disable(GL_DEPTH_BOUNDS_TEST_EXT);
  }
  for (GLenum i = 0; i < clip_distances; ++i) {
    gl.Disable(GL_CLIP_DISTANCE0 + i);
  }
  gl.Viewport(-1, -1, 3, 3);
}

// Switched off during its lifetime. Mesa's glPopAttrib does not restore these two.
class AllSamples {
 public:
  explicit AllSamples(const gl::Dispatch& gl)
      : gl_(gl), mask_(switch_off(GL_SAMPLE_MASK)), shading_(switch_off(GL_SAMPLE_SHADING)) {}
  ~AllSamples() {
    switch_on(GL_SAMPLE_MASK, mask_);
    switch_on(GL_SAMPLE_SHADING, shading_);
  }
  AllSamples(const AllSamples&) = delete;
  AllSamples& operator=(const AllSamples&) = delete;

 private:
  bool switch_off(GLenum mode) const {
    const bool was_on = gl_.IsEnabled(mode) != GL_FALSE;
    if (was_on) {
      gl_.Disable(mode);
    }
    return was_on;
  }
  void switch_on(GLenum mode, bool was_on) const {
    if (was_on) {
      gl_.Enable(mode);
    }
  }

  const gl::Dispatch& gl_;
  bool mask_;
  bool shading_;
};

}  // namespace

std::optional<Diagonal> DrawnDiagonals::find(GLenum mode, QuadSource source) {
  const bool first = env_.bindings().provoking_vertex == GL_FIRST_VERTEX_CONVENTION;
  std::optional<Diagonal>& known =
      known_[4 * (mode == GL_QUADS ? 0U : 2U) + (first ? 4U : 0U) + static_cast<std::size_t>(source)];
  // However often GL has drawn nothing: the next draw may be outside of the conditional rendering.
  if (!known && can_probe()) {
    known = probe(mode, source);
  }
  return known;
}

bool DrawnDiagonals::can_probe() const {
  const core::Bindings& b = env_.bindings();
  return !broken_ && b.queries.none() && !b.transform_feedback.active && !b.rasterizer_discard &&
         !env_.state.lists().compiling();
}

std::optional<Diagonal> DrawnDiagonals::probe(GLenum mode, QuadSource source) {
  core::ErrorScope errors(env_.errors);
  if (program_ == 0) {
    const core::ShaderText texts[] = {{GL_VERTEX_SHADER, vertex_source}, {GL_FRAGMENT_SHADER, fragment_source}};
    program_ = core::build_program(env_.gl, "the program that looks for the diagonals of quads", texts);
    broken_ = program_ == 0;
  }
  float middle = nothing_drawn;
  core::GpuBuffer result;
  if (program_ == 0 || !result.allocate(env_.gl, sizeof(middle), &middle, GL_STREAM_READ)) {
    return std::nullopt;
  }
  env_.gl.PushAttrib(GL_ENABLE_BIT | GL_VIEWPORT_BIT);
  if (errors.take() == GL_NO_ERROR) {  // else, the application has filled the stack
    draw(program_, result.name(), mode, source);
    env_.gl.PopAttrib();
    result.read(env_.gl, 0, sizeof(middle), &middle);
  }
  result.release(env_.gl);
  if (middle == nothing_drawn) {
    return std::nullopt;
  }
  env_.gl.DeleteProgram(std::exchange(program_, 0));
  return middle > 0.5F ? Diagonal::from_first : Diagonal::from_second;
}

void DrawnDiagonals::draw(GLuint program, GLuint result, GLenum mode, QuadSource source) const {
  const core::Bindings& b = env_.bindings();
  GLuint array = 0;
  env_.gl.GenVertexArrays(1, &array);
  env_.gl.BindVertexArray(array);
  env_.gl.UseProgram(program);
  env_.gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, result);
  if (b.primitive_restart) {
    env_.gl.Disable(GL_PRIMITIVE_RESTART);
  }
  show_one_pixel(env_.gl);
  const AllSamples all_samples(env_.gl);
  switch (source) {
    case QuadSource::immediate: draw_immediate(env_.gl, mode); break;
    case QuadSource::list: draw_list(env_.gl, mode); break;
    default: draw_arrays(env_.gl, mode, source == QuadSource::elements);
  }
  env_.gl.Flush();  // GL may keep the vertices of glBegin for a while, and Mesa 22 does not draw them before a barrier
  env_.gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (b.primitive_restart) {
    env_.gl.Enable(GL_PRIMITIVE_RESTART);
  }
  const core::IndexedBuffer& storage = b.storage[0];
  if (storage.size > 0 && storage.buffer != 0) {
    env_.gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, storage.buffer, storage.offset, storage.size);
  } else {
    env_.gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, storage.buffer);
  }
  env_.gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, b.storage_buffer);
  programs_.use_application();
  env_.gl.BindVertexArray(b.vertex_array);
  env_.gl.DeleteVertexArrays(1, &array);
}

}  // namespace glark::polygons
