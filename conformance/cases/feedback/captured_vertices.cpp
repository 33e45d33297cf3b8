// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws of vertices that transform feedback has captured.
#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei vertices = 6;

Mesh two_triangles() {
  Mesh mesh = one_triangle();
  for (MeshVertex vertex : one_triangle()) {
    vertex.position = {0.3F * vertex.position[0] + 0.65F, 0.3F * vertex.position[1] + 0.65F, 0, 1};  // beside it
    mesh.push_back(vertex);
  }
  return mesh;
}

// Since OpenGL 4.4, the vertex stage itself may say in which buffer an output lies.
void check_several_buffers(Test& t) {
  if (t.version() < 44) t.not_supported("outputs name no buffers");
  std::string log;
  const GLuint capturing =
      try_program({.vertex = "#version 440\n"
                             "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                             "layout(xfb_buffer = 0, xfb_offset = 0, xfb_stride = 16) out vec4 place;\n"
                             "layout(xfb_buffer = 1, xfb_offset = 0, xfb_stride = 16) out vec4 colour;\n"
                             "void main() { place = position; colour = vertex_colour; gl_Position = position; }\n",
                   .fragment = "#version 440\nin vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n"},
                  log);
  t.require(capturing != 0, "the program builds: " + log);
  gl.UseProgram(capturing);
  upload(two_triangles());
  GLuint object = 0, array = 0, buffers[2] = {};
  gl.GenTransformFeedbacks(1, &object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.GenBuffers(2, buffers);
  for (GLuint i = 0; i < 2; ++i) {
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, vertices * sizeof(Vec4), nullptr, GL_STATIC_DRAW);
  }
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(GL_TRIANGLES, 0, vertices);
  gl.EndTransformFeedback();
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.UseProgram(colour_program(t));
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  for (const auto& [buffer, location] : {std::pair<GLuint, GLuint>{buffers[0], at_position}, {buffers[1], at_colour}}) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), nullptr);
    gl.EnableVertexAttribArray(location);
  }
  const auto draw = [object] { gl.DrawTransformFeedback(GL_TRIANGLES, object); };
  const Picture expected = picture_of(draw);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 8) > 300, "something is drawn");
  refine_by_tags(4);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 8);
  for (int again = 0; again < 4; ++again)
    t.expect_same_picture(picture_of(draw), expected, "refined captured vertices", 4, 80);
  t.expect_no_error("the draws");
}

constexpr Area captured_case{"ark.after_vertex.captured."};

}  // namespace

Cases captured_vertices_cases() {
  Cases cases = {captured_case("several_buffers", {"10.R.2-2"},
                               "Capture outputs into two buffers that the vertex stage names, and draw the vertices.",
                               "Only half of the triangles.", check_several_buffers, desktop_apis)};
  cases.back().is_optional = true;  // outputs that name buffers
  return cases;
}

}  // namespace glark::conformance
