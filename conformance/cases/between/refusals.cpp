// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/cases/between/refusals.h"

#include "conformance/cases/draws/four_triangles.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr GLenum no_mode = 0x1234;
constexpr GLuint no_name = 987654;

const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

GLuint bound_buffer(GLenum target, const void* data, std::size_t bytes) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return name;
}

void map(GLuint buffer) {
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  gl.MapBufferRange(GL_COPY_READ_BUFFER, 0, 16, GL_MAP_READ_BIT);
}

void unmap(GLuint buffer) {
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  gl.UnmapBuffer(GL_COPY_READ_BUFFER);
}

void use_scene_program(const RefusedScene& scene) { gl.UseProgram(scene.program); }

// A geometry shader that takes lines.
void use_line_program(Test& t, const RefusedScene&) {
  gl.UseProgram(
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; void main() { gl_Position = position; }\n",
                        .fragment = "out vec4 pixel; void main() { pixel = vec4(1.0); }",
                        .geometry = "layout(lines) in; layout(line_strip, max_vertices = 2) out;\n"
                                    "void main() { gl_Position = gl_in[0].gl_Position; EmitVertex();\n"
                                    "  gl_Position = gl_in[1].gl_Position; EmitVertex(); EndPrimitive(); }\n"}));
}

void bind_no_framebuffer(Test&, const RefusedScene&) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
}

void bind_surface(const RefusedScene& scene) { gl.BindFramebuffer(GL_FRAMEBUFFER, scene.framebuffer); }

// The program of the scene has varyings.
void begin_feedback_of_lines(Test&, const RefusedScene&) {
  const GLuint buffer = bound_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, 65536);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BeginTransformFeedback(GL_LINES);
}

void end_feedback(const RefusedScene&) {
  gl.EndTransformFeedback();
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

std::vector<Refusal> refused_arguments() {
  return {
      {"mode", GL_INVALID_ENUM, [](const RefusedScene&) { gl.DrawArrays(no_mode, 0, 12); }},
      {"mode_of_elements", GL_INVALID_ENUM,
       [](const RefusedScene&) { gl.DrawElements(no_mode, 12, GL_UNSIGNED_SHORT, nullptr); }},
      {"mode_of_indirect", GL_INVALID_ENUM, [](const RefusedScene&) { gl.DrawArraysIndirect(no_mode, nullptr); }},
      {"count", GL_INVALID_VALUE, [](const RefusedScene&) { gl.DrawArrays(GL_TRIANGLES, 0, -3); }},
      {"count_of_strip", GL_INVALID_VALUE, [](const RefusedScene&) { gl.DrawArrays(GL_TRIANGLE_STRIP, 0, -1); }},
      {"count_of_elements", GL_INVALID_VALUE,
       [](const RefusedScene&) { gl.DrawElements(GL_TRIANGLES, -3, GL_UNSIGNED_SHORT, nullptr); }},
      {"count_of_instances", GL_INVALID_VALUE,
       [](const RefusedScene&) { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 12, -1); }},
      {"count_of_element_instances", GL_INVALID_VALUE,
       [](const RefusedScene&) { gl.DrawElementsInstanced(GL_TRIANGLES, 12, GL_UNSIGNED_SHORT, nullptr, -1); }},
      {"type_of_indices", GL_INVALID_ENUM,
       [](const RefusedScene&) { gl.DrawElements(GL_TRIANGLES, 12, GL_FLOAT, nullptr); }},
      {"range", GL_INVALID_VALUE,
       [](const RefusedScene&) { gl.DrawRangeElements(GL_TRIANGLES, 5, 2, 12, GL_UNSIGNED_SHORT, nullptr); }},
      {"base_vertex_type", GL_INVALID_ENUM,
       [](const RefusedScene&) { gl.DrawElementsBaseVertex(GL_TRIANGLES, 12, GL_SHORT, nullptr, 0); }},
      {.leaf = "multi_count",
       .error = GL_INVALID_VALUE,
       .draw =
           [](const RefusedScene&) {
             const GLint first[] = {0};
             const GLsizei count[] = {12};
             gl.MultiDrawArrays(GL_TRIANGLES, first, count, -1);
           },
       .apis = desktop_apis},
      {.leaf = "multi_elements_count",
       .error = GL_INVALID_VALUE,
       .draw =
           [](const RefusedScene&) {
             const void* const first[] = {nullptr};
             const GLsizei count[] = {12};
             gl.MultiDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, first, -1);
           },
       .apis = desktop_apis},
      {.leaf = "feedback_of_no_name",
       .error = GL_INVALID_VALUE,
       .draw = [](const RefusedScene&) { gl.DrawTransformFeedback(GL_TRIANGLES, no_name); },
       .apis = desktop_apis},
      {.leaf = "feedback_stream",
       .error = GL_INVALID_VALUE,
       .draw = [](const RefusedScene&) { gl.DrawTransformFeedbackStream(GL_TRIANGLES, 0, 999); },
       .apis = desktop_apis},
      {.leaf = "arp_mode",
       .error = GL_INVALID_ENUM,
       .draw = [](const RefusedScene&) { gl.DrawARP(GL_LINES, 0, 12); },
       .is_plain = false},
      {.leaf = "arp_count",
       .error = GL_INVALID_VALUE,
       .draw = [](const RefusedScene&) { gl.DrawARP(GL_TRIANGLES, 0, -3); },
       .is_plain = false},
      {.leaf = "arp_elements_type",
       .error = GL_INVALID_ENUM,
       .draw = [](const RefusedScene&) { gl.DrawARPElementsARK(GL_TRIANGLES, 12, GL_FLOAT, nullptr); },
       .is_plain = false},
  };
}

std::vector<Refusal> refused_commands() {
  return {
      {"indirect_alignment", GL_INVALID_VALUE,
       [](const RefusedScene&) { gl.DrawArraysIndirect(GL_TRIANGLES, at_offset(2)); }},
      {"indirect_end", GL_INVALID_OPERATION,
       [](const RefusedScene&) { gl.DrawArraysIndirect(GL_TRIANGLES, at_offset(4096)); }},
      {"indirect_elements_end", GL_INVALID_OPERATION,
       [](const RefusedScene&) { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at_offset(4096)); }},
      {.leaf = "indirect_mapped",
       .error = GL_INVALID_OPERATION,
       .draw = [](const RefusedScene&) { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); },
       .enter = [](Test&, const RefusedScene& s) { map(s.commands); },
       .leave = [](const RefusedScene& s) { unmap(s.commands); }},
      {.leaf = "indirect_without_buffer",
       .error = GL_INVALID_OPERATION,
       .draw = [](const RefusedScene&) { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); },
       .enter = [](Test&, const RefusedScene&) { gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0); },
       .leave = [](const RefusedScene& s) { gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands); },
       .apis = {Api::gl_core, Api::gles}},
      {.leaf = "indirect_without_elements",
       .error = GL_INVALID_OPERATION,
       .draw = [](const RefusedScene&) { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at_offset(16)); },
       .enter = [](Test&, const RefusedScene&) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0); },
       .leave = [](const RefusedScene& s) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.elements); }},
      {.leaf = "multi_indirect_stride",
       .error = GL_INVALID_VALUE,
       .draw = [](const RefusedScene&) { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 1, 18); },
       .apis = desktop_apis},
      {.leaf = "multi_indirect_count",
       .error = GL_INVALID_VALUE,
       .draw = [](const RefusedScene&) { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, -1, 0); },
       .apis = desktop_apis},
      {.leaf = "multi_indirect_end",
       .error = GL_INVALID_OPERATION,
       .draw =
           [](const RefusedScene&) {
             gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at_offset(16), 99, 0);
           },
       .apis = desktop_apis},
  };
}

std::vector<Refusal> refused_states() {
  const auto draw_all = [](const RefusedScene&) { gl.DrawArrays(GL_TRIANGLES, 0, 12); };
  const auto draw_elements = [](const RefusedScene&) { gl.DrawElements(GL_TRIANGLES, 12, GL_UNSIGNED_SHORT, nullptr); };
  return {
      {.leaf = "mapped_vertices",
       .error = GL_INVALID_OPERATION,
       .draw = draw_all,
       .enter = [](Test&, const RefusedScene& s) { map(s.vertices); },
       .leave = [](const RefusedScene& s) { unmap(s.vertices); }},
      {.leaf = "mapped_vertices_of_elements",
       .error = GL_INVALID_OPERATION,
       .draw = draw_elements,
       .enter = [](Test&, const RefusedScene& s) { map(s.vertices); },
       .leave = [](const RefusedScene& s) { unmap(s.vertices); }},
      {.leaf = "mapped_elements",
       .error = GL_INVALID_OPERATION,
       .draw = draw_elements,
       .enter = [](Test&, const RefusedScene& s) { map(s.elements); },
       .leave = [](const RefusedScene& s) { unmap(s.elements); }},
      {.leaf = "incomplete_framebuffer",
       .error = GL_INVALID_FRAMEBUFFER_OPERATION,
       .draw = draw_all,
       .enter = bind_no_framebuffer,
       .leave = bind_surface},
      {.leaf = "incomplete_framebuffer_of_instances",
       .error = GL_INVALID_FRAMEBUFFER_OPERATION,
       .draw = [](const RefusedScene&) { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 12, 3); },
       .enter = bind_no_framebuffer,
       .leave = bind_surface},
      {.leaf = "geometry_of_lines",
       .error = GL_INVALID_OPERATION,
       .draw = draw_all,
       .enter = use_line_program,
       .leave = use_scene_program,
       .allows_feedback = false},
      {.leaf = "feedback_of_lines",
       .error = GL_INVALID_OPERATION,
       .draw = draw_all,
       .enter = begin_feedback_of_lines,
       .leave = end_feedback,
       .allows_feedback = false},
      {.leaf = "feedback_of_lines_with_elements",
       .error = GL_INVALID_OPERATION,
       .draw = draw_elements,
       .enter = begin_feedback_of_lines,
       .leave = end_feedback,
       .apis = desktop_apis,
       .allows_feedback = false},
      {"patches", GL_INVALID_OPERATION, [](const RefusedScene&) { gl.DrawArrays(GL_PATCHES, 0, 12); }},
      {.leaf = "no_array",
       .error = GL_INVALID_OPERATION,
       .draw = draw_all,
       .enter = [](Test&, const RefusedScene&) { gl.BindVertexArray(0); },
       .leave = [](const RefusedScene& s) { gl.BindVertexArray(s.array); },
       .apis = {Api::gl_core}},
      {.leaf = "within_begin",
       .error = GL_INVALID_OPERATION,
       .draw = draw_all,
       .enter = [](Test&, const RefusedScene&) { gl.Begin(GL_TRIANGLES); },
       .leave = [](const RefusedScene&) { gl.End(); },
       .apis = compat_only,
       .allows_feedback = false},
      {.leaf = "begin_of_no_mode",
       .error = GL_INVALID_ENUM,
       .draw = [](const RefusedScene&) { gl.Begin(no_mode); },
       .apis = compat_only},
      {.leaf = "end_without_begin",
       .error = GL_INVALID_OPERATION,
       .draw = [](const RefusedScene&) { gl.End(); },
       .apis = compat_only},
  };
}

}  // namespace

const std::vector<Refusal>& refusals() {
  static const std::vector<Refusal> all = [] {
    std::vector<Refusal> joined;
    for (const auto& part : {refused_arguments(), refused_commands(), refused_states()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

RefusedScene make_refused_scene(Test& t) {
  RefusedScene scene;
  scene.program = capture_program(t);
  gl.UseProgram(scene.program);
  Mesh mesh = four_triangles();
  for (MeshVertex& vertex : mesh) vertex.tag = 1;
  const MeshBuffers uploaded = upload(mesh);
  scene.array = uploaded.array;
  scene.vertices = uploaded.buffer;
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  scene.framebuffer = static_cast<GLuint>(bound);
  const GLushort indices[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  scene.elements = bound_buffer(GL_ELEMENT_ARRAY_BUFFER, indices, sizeof(indices));
  const GLuint commands[] = {12, 1, 0, 0, 12, 1, 0, 0, 0};
  scene.commands = bound_buffer(GL_DRAW_INDIRECT_BUFFER, commands, sizeof(commands));
  return scene;
}

}  // namespace glark::conformance
