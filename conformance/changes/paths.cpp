// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/paths.h"

#include <array>

namespace glark::conformance {
namespace {

constexpr GLuint list = 1;

const void* at(std::uintptr_t offset) { return reinterpret_cast<const void*>(offset); }

void draw_arrays(const Scene& scene) { gl.DrawArrays(GL_TRIANGLES, 0, scene.vertices()); }

void draw_multi_arrays(const Scene& scene) {
  const GLsizei half = scene.vertices() / 6 * 3;
  const std::array<GLint, 2> first = {0, half};
  const std::array<GLsizei, 2> count = {half, scene.vertices() - half};
  gl.MultiDrawArrays(GL_TRIANGLES, first.data(), count.data(), 2);
}

void draw_multi_elements(const Scene& scene) {
  const GLsizei half = scene.vertices() / 6 * 3;
  const std::array<const void*, 2> first = {nullptr, at(2 * static_cast<std::uintptr_t>(half))};
  const std::array<GLsizei, 2> count = {half, scene.vertices() - half};
  gl.MultiDrawElements(GL_TRIANGLES, count.data(), GL_UNSIGNED_SHORT, first.data(), 2);
}

// Captures as many points as the scene has vertices. Their values do not matter, but their size does: llvmpipe counts
// them in strides of the first vertex buffer, whose vertices have 32 bytes, too.
void capture_vertices(Test& t, Scene& scene) {
  const GLuint program =
      build_program(t, {.vertex = "out vec4 one; out vec4 two; void main() { one = two = gl_Position = vec4(2.0); }",
                        .fragment = "in vec4 one; in vec4 two; out vec4 pixel; void main() { pixel = one + two; }",
                        .captured = {"one", "two"}});
  gl.UseProgram(program);
  gl.GenTransformFeedbacks(1, &scene.feedback);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, scene.feedback);
  scene.made.push_back(
      make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, 32 * static_cast<std::size_t>(scene.vertices())));
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, scene.made.back());
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, scene.vertices());
  gl.EndTransformFeedback();
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.UseProgram(scene.program);
  gl.DeleteProgram(program);
}

void draw_array_elements(const Scene& scene) {
  gl.Begin(GL_TRIANGLES);
  for (GLint i = 0; i < scene.vertices(); ++i) gl.ArrayElement(i);
  gl.End();
}

void compile_list(Test&, Scene& scene) {
  gl.NewList(list, GL_COMPILE);
  draw_arrays(scene);
  gl.EndList();
}

}  // namespace

const std::vector<Path>& paths() {
  static const std::vector<Path> all = {
      {"DrawArrays", every_api, draw_arrays},
      {.name = "DrawElements",
       .apis = every_api,
       .draw = [](const Scene& s) { gl.DrawElements(GL_TRIANGLES, s.vertices(), GL_UNSIGNED_SHORT, nullptr); },
       .has_indices = true},
      {.name = "DrawRangeElementsBaseVertex",
       .apis = every_api,
       .draw =
           [](const Scene& s) {
             gl.DrawRangeElementsBaseVertex(GL_TRIANGLES, 0, static_cast<GLuint>(s.vertices()) - 1, s.vertices(),
                                            GL_UNSIGNED_SHORT, nullptr, 0);
           },
       .has_indices = true},
      {.name = "DrawArraysInstanced",
       .apis = every_api,
       .draw = [](const Scene& s) { gl.DrawArraysInstanced(GL_TRIANGLES, 0, s.vertices(), 2); },
       .draws_instances = true},
      {.name = "DrawElementsInstanced",
       .apis = every_api,
       .draw =
           [](const Scene& s) { gl.DrawElementsInstanced(GL_TRIANGLES, s.vertices(), GL_UNSIGNED_SHORT, nullptr, 2); },
       .has_indices = true,
       .draws_instances = true},
      {"MultiDrawArrays", desktop_apis, draw_multi_arrays},
      {.name = "MultiDrawElements", .apis = desktop_apis, .draw = draw_multi_elements, .has_indices = true},
      {.name = "DrawArraysIndirect",
       .apis = every_api,
       .draw = [](const Scene&) { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); },
       .has_commands = true},
      {.name = "DrawElementsIndirect",
       .apis = every_api,
       .draw = [](const Scene&) { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at(16)); },
       .has_indices = true,
       .has_commands = true},
      {.name = "MultiDrawElementsIndirect",
       .apis = desktop_apis,
       .draw = [](const Scene&) { gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at(16), 1, 0); },
       .has_indices = true,
       .has_commands = true},
      {.name = "DrawTransformFeedback",
       .apis = desktop_apis,
       .draw = [](const Scene& s) { gl.DrawTransformFeedback(GL_TRIANGLES, s.feedback); },
       .prepare = capture_vertices},
      {.name = "ArrayElement", .apis = compat_only, .draw = draw_array_elements, .has_instances = false},
      {.name = "a display list",
       .apis = compat_only,
       .draw = [](const Scene&) { gl.CallList(list); },
       .has_instances = false,
       .copies_arrays = true,
       .prepare = compile_list},
  };
  return all;
}

}  // namespace glark::conformance
