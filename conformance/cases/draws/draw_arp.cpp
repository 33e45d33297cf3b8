// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// DrawARP and DrawARPElementsARK, Begin and End, and transform feedback draws (10.R.2).
#include <fmt/core.h>
#include <algorithm>
#include <functional>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/ring.h"
#include "conformance/cases/triangle_modes.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLenum index_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};

Apis apis_of(const TriangleMode& mode) { return mode.is_legacy ? compat_only : every_api; }

void set_up(Test& t) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(ring());
  refine_by_tags(3);
}

using Draw = std::function<void()>;

// Adds up colours, so that the order of triangles does not matter.
Picture sum_of(const Draw& draw) {
  clear_surface();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  draw();
  gl.Disable(GL_BLEND);
  return read_picture(surface_size, surface_size);
}

// A vertex stage that bends, so that refinement shows.
GLuint bending_program(Test& t) {
  return build_program(t,
                       {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                                  "out vec4 colour; void main() { colour = 0.25 * vertex_colour;\n"
                                  "  gl_Position = vec4(position.xy + 0.2 * cos(4.0 * position.yx), 0.0, 1.0); }\n"});
}

// `arp` with ARK disabled draws what `draw` draws with ARK enabled, and leaves ARK disabled.
void expect_arp_alone(Test& t, const Draw& draw, const Draw& arp, const std::string& what) {
  gl.Enable(GL_ARK);
  const Picture refined = sum_of(draw);
  const GLuint count = count_generated(draw);
  gl.Disable(GL_ARK);
  const Picture coarse = sum_of(draw);
  t.expect(count_different(refined, coarse, 8) > 10, what + ": refinement shows");
  t.expect_same_picture(sum_of(arp), refined, what);
  t.expect_equal(count_generated(arp), count, what + ": triangles");
  t.expect(gl.IsEnabled(GL_ARK) == GL_FALSE, what + ": ARK stays disabled");
  t.expect_same_picture(sum_of(draw), coarse, what + ": an ordinary draw afterwards");
}

void expect_arp(Test& t, const Draw& draw, const Draw& arp, const std::string& what) {
  const GLuint capturing = draw_program(t);
  gl.UseProgram(capturing);
  expect_refinement(t, {}, draw, arp, what + ", ARK enabled");
  t.expect(gl.IsEnabled(GL_ARK) != GL_FALSE, what + ": ARK stays enabled");
  gl.UseProgram(bending_program(t));
  expect_arp_alone(t, draw, arp, what + ", ARK disabled");
  gl.Enable(GL_ARK);
}

void check_arrays(Test& t, GLenum mode) {
  set_up(t);
  expect_arp(
      t, [mode] { gl.DrawArrays(mode, 2, 8); }, [mode] { gl.DrawARP(mode, 2, 8); }, "eight vertices");
}

void check_elements(Test& t, GLenum mode) {
  set_up(t);
  for (const GLenum type : index_types) {
    const std::size_t size = bind_indices(type);
    const void* const at = reinterpret_cast<const void*>(2 * size);
    expect_arp(
        t, [=] { gl.DrawElements(mode, 8, type, at); }, [=] { gl.DrawARPElementsARK(mode, 8, type, at); },
        fmt::format("{} bits", 8 * size));
  }
}

// Each draw decides whether it is refined, also between BeginTransformFeedback and EndTransformFeedback.
void check_within_feedback(Test& t) {
  set_up(t);
  gl.Disable(GL_ARK);
  const auto coarse = [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); };
  expect_refinement(
      t, {}, coarse, [] { gl.DrawARP(GL_TRIANGLES, 0, 6); }, "DrawARP with ARK disabled");
  expect_refinement(
      t, {}, coarse,
      [&] {
        gl.Enable(GL_ARK);
        coarse();
        gl.Disable(GL_ARK);
      },
      "ARK enabled after BeginTransformFeedback");
}

void check_client_elements(Test& t) {
  set_up(t);
  const GLushort indices[] = {11, 3, 5, 0, 7, 2};
  expect_arp(
      t, [&] { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices); },
      [&] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices); }, "indices in client memory");
}

void begin_end(GLenum mode) {
  const Mesh mesh = ring();
  gl.Begin(mode);
  for (std::size_t i = 1; i < 9; ++i) {
    gl.VertexAttrib4fv(at_colour, mesh[i].colour.data());
    gl.DepthTag1i(static_cast<GLuint>(mesh[i].tag));
    gl.Vertex4f(mesh[i].position[0], mesh[i].position[1], mesh[i].position[2], 1);
  }
  gl.End();
}

void check_begin_end(Test& t, GLenum mode) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  refine_by_tags(3);
  expect_refined(
      t, {}, [mode] { begin_end(mode); }, "Begin and End, by tags");
  refine_uniformly(2);
  expect_refined(
      t, {.uniform_level = 2}, [mode] { begin_end(mode); }, "Begin and End, uniformly");
}

void check_array_element(Test& t) {
  set_up(t);
  expect_refined(
      t, {},
      [] {
        gl.Begin(GL_TRIANGLE_STRIP);
        for (const GLint i : {4, 1, 7, 2, 9}) gl.ArrayElement(i);
        gl.End();
      },
      "ArrayElement");
}

// Captures vertices once, then draws that number of vertices, refined.
void check_transform_feedback(Test& t, GLenum mode, GLsizei instances) {
  set_up(t);
  gl.Disable(GL_ARK);
  GLuint object = 0;
  GLuint buffer = 0;
  gl.GenTransformFeedbacks(1, &object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 9 * sizeof(DrawVertex), nullptr, GL_STATIC_DRAW);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 1, 9);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.Enable(GL_ARK);
  const auto draw = [&] {
    if (instances == 0)
      gl.DrawTransformFeedback(mode, object);
    else
      gl.DrawTransformFeedbackInstanced(mode, object, instances);
  };
  expect_refined(t, {}, draw, "as many vertices as were captured");
}

}  // namespace

Cases draw_arp_cases() {
  Cases cases;
  for (const TriangleMode& mode : triangle_modes) {
    const std::string wrong =
        "Unrefined while ARK is disabled; refined twice; ARK changes; the first vertex is ignored.";
    cases.push_back({.name = std::string("ark.draw.arp.arrays.") + mode.name,
                     .clauses = {"10.R.2-6", "10.R.2-9"},
                     .plan = "DrawARP with ARK disabled and enabled gives the refinement of what DrawArrays gives.",
                     .wrong = wrong,
                     .apis = apis_of(mode),
                     .check = [mode](Test& t) { check_arrays(t, mode.mode); }});
    cases.push_back({.name = std::string("ark.draw.arp.elements.") + mode.name,
                     .clauses = {"10.R.2-8", "10.R.2-9"},
                     .plan = "DrawARPElementsARK with each index type gives the refinement of what DrawElements gives.",
                     .wrong = wrong,
                     .apis = apis_of(mode),
                     .check = [mode](Test& t) { check_elements(t, mode.mode); }});
    cases.push_back({.name = std::string("ark.draw.begin_end.") + mode.name,
                     .clauses = {"10.R.2-2", "10.R.1-13"},
                     .plan = "Capture vertices between Begin and End, each with its own tag.",
                     .wrong = "Unrefined; one tag or one colour for the whole primitive.",
                     .apis = compat_only,
                     .check = [mode](Test& t) { check_begin_end(t, mode.mode); }});
    for (const GLsizei instances : {0, 2})
      cases.push_back(
          {.name = std::string("ark.draw.transform_feedback") + (instances == 0 ? "." : "_instanced.") + mode.name,
           .clauses = {"10.R.2-2"},
           .plan = "Draw as many vertices as a transform feedback object captured.",
           .wrong = "Unrefined; nothing; the number of an earlier capture.",
           .apis = mode.is_legacy ? compat_only : desktop_apis,
           .check = [mode, instances](Test& t) { check_transform_feedback(t, mode.mode, instances); }});
  }
  cases.push_back({.name = "ark.draw.begin_end.array_element",
                   .clauses = {"10.R.2-2"},
                   .plan = "Call ArrayElement between Begin and End.",
                   .wrong = "Unrefined; tags of other vertices.",
                   .apis = compat_only,
                   .check = check_array_element});
  cases.push_back(
      {.name = "ark.draw.arp.within_feedback",
       .clauses = {"10.R.2-1", "10.R.2-6"},
       .plan = "Within a capture that began with ARK disabled, capture DrawARP, and a draw after Enable(ARK).",
       .wrong = "Unrefined, because ARK was disabled when the capture began.",
       .check = check_within_feedback});
  cases.push_back({.name = "ark.draw.arp.elements.client_memory",
                   .clauses = {"10.R.2-8"},
                   .plan = "DrawARPElementsARK with indices in client memory.",
                   .wrong = "The pointer counts as an offset.",
                   .apis = compat_only,
                   .check = check_client_elements});
  return cases;
}

}  // namespace glark::conformance
