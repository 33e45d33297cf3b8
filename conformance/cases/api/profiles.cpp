// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Requirements of the extension, and what is different in the core profile and in OpenGL ES.
#include <algorithm>
#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void check_attribute_zero(Test& t) {
  const GLuint program = build_program(t, {.vertex = "layout(location = 8) in vec4 position; out vec4 colour;\n"
                                                     "void main() { colour = vec4(1.0); gl_Position = position; }\n",
                                           .captured = {"gl_Position"}});
  gl.UseProgram(program);
  const MeshBuffers mesh = upload(one_triangle({4, 1, 2}), false);
  gl.DisableVertexAttribArray(at_position);
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.buffer);
  gl.VertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(8);
  gl.ARKinit(4);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 0);
  gl.DepthTag1i(2);
  gl.Enable(GL_ARK);
  const auto vertices = [&] { return capture_as<Vec4>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(); };
  t.expect_equal(vertices(), 48U, "vertices with the current tag in attribute 0");
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, tag)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_equal(vertices(), 36U, "vertices with the array of attribute 0");
}

void check_split_without_effect(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle({3, 1, 2}));
  refine_by_tags(4);
  const auto captured = [&] {
    std::vector<Vec4> positions;
    for (const CapturedVertex& vertex : capture(t, [] { gl.DrawArrays(GL_TRIANGLE_FAN, 0, 3); }))
      positions.push_back(vertex.position);
    std::sort(positions.begin(), positions.end());
    return positions;
  };
  const auto before = captured();
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  t.expect_no_error("POLYGON_SPLIT_ARK");
  t.expect(before.size() > 3 && captured() == before, "the same vertices");
}

void check_requirements(Test& t) {
  t.expect(t.has_extension("GL_ARK_adaptive_refinement"), "the name is among the extensions");
  if (t.is_compat() || t.is_gles()) {
    const auto* const text = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
    const std::string names = " " + std::string(text == nullptr ? "" : text) + " ";
    t.expect(names.find(" GL_ARK_adaptive_refinement ") != std::string::npos, "the name is in GetString(EXTENSIONS)");
  }
  t.expect(t.version() >= (t.is_gles() ? 32 : 43), "the version is at least OpenGL 4.3 or OpenGL ES 3.2");
  t.expect(integer_of(GL_MAX_DEPTH_ARK) >= 11, "MAX_DEPTH_ARK is at least 11");
  t.expect_no_error("the queries");
}

}  // namespace

Cases profiles_cases() {
  return {
      {.name = "ark.core.attribute_zero",
       .clauses = {"core-5", "es-1", "11.R.2-7"},
       .plan = "Tags in attribute 0, current and in an array, and positions elsewhere.",
       .wrong = "INVALID_VALUE; the tag of attribute 0 is never read.",
       .apis = {Api::gl_core, Api::gles},
       .check = check_attribute_zero},
      {.name = "ark.core.split",
       .clauses = {"core-3", "es-1"},
       .plan = "Capture a triangle fan with both values of POLYGON_SPLIT_ARK.",
       .wrong = "INVALID_ENUM; fans are split at a centroid.",
       .apis = {Api::gl_core, Api::gles},
       .check = check_split_without_effect},
      {.name = "ark.requirements",
       .clauses = {"name-1", "dependencies-1", "es-3", "limits-1"},
       .plan = "The extension's name, the version of the context, and the limit.",
       .wrong = "The name is missing from GetString or GetStringi.",
       .check = check_requirements},
  };
}

}  // namespace glark::conformance
