// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// DrawARP and DrawARPElementsARK, their errors, Begin and End, transform feedback draws, and what is not refined (10.R.2).
#include <algorithm>
#include <functional>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLenum index_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};

struct Mode {
  const char* name;
  GLenum mode;
  bool is_legacy;
};
constexpr Mode modes[] = {{"triangles", GL_TRIANGLES, false},       {"triangle_strip", GL_TRIANGLE_STRIP, false},
                          {"triangle_fan", GL_TRIANGLE_FAN, false}, {"quads", GL_QUADS, true},
                          {"quad_strip", GL_QUAD_STRIP, true},      {"polygon", GL_POLYGON, true}};

Apis apis_of(const Mode& mode) { return mode.is_legacy ? compat_only : every_api; }

// Twelve vertices about a ring, so that every mode gives triangles with an area; eighths, so that sums are exact.
Mesh ring() {
  const Vec2 places[] = {{-0.75F, -0.5F}, {-0.25F, -0.875F}, {0.25F, -0.75F},  {0.75F, -0.25F},
                         {0.875F, 0.25F}, {0.5F, 0.625F},    {0.125F, 0.875F}, {-0.375F, 0.75F},
                         {-0.75F, 0.5F},  {-0.875F, 0.125F}, {-0.5F, -0.125F}, {-0.625F, -0.375F}};
  Mesh mesh(12);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto n = static_cast<float>(i);
    mesh[i].position = {places[i][0], places[i][1], n / 16, 1};
    mesh[i].colour = {n / 16, 1 - n / 16, static_cast<float>(i % 3) / 2, 1};
    mesh[i].tag = static_cast<float>((i * 5 + i / 3) % 4);
  }
  return mesh;
}

void set_up(Test& t) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(ring());
  refine_by_tags(3);
}

template <typename Index>
void bind_indices_as() {
  const Index indices[] = {11, 3, 5, 0, 7, 2, 9, 4, 1, 6, 8, 10};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
}

std::size_t bind_indices(GLenum type) {
  if (type == GL_UNSIGNED_BYTE) bind_indices_as<GLubyte>();
  if (type == GL_UNSIGNED_SHORT) bind_indices_as<GLushort>();
  if (type == GL_UNSIGNED_INT) bind_indices_as<GLuint>();
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

using Draw = std::function<void()>;

// Sums of colours, which do not depend on the order of triangles.
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

// `arp` with ARK disabled is `draw` with ARK enabled, and leaves ARK disabled.
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
        std::to_string(8 * size) + " bits");
  }
}

// What is refined is a matter of each draw, also between BeginTransformFeedback and EndTransformFeedback.
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

// Vertices captured once are drawn again by their number, refined.
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

void expect_nothing_drawn(Test& t, GLenum error, const std::string& what, const std::function<void()>& draw) {
  const GLboolean was_enabled = gl.IsEnabled(GL_ARK);
  gl.ClearColor(0, 0, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const Picture before = read_picture(surface_size, surface_size);
  draw();
  t.expect_error(error, what);
  t.expect_same_picture(read_picture(surface_size, surface_size), before, what + " draws nothing");
  t.expect_equal(gl.IsEnabled(GL_ARK), was_enabled, what + " leaves ARK as it was");
}

void set_up_errors(Test& t, bool has_pool) {
  gl.UseProgram(colour_program(t));
  upload(ring());
  bind_indices(GL_UNSIGNED_BYTE);
  if (has_pool) refine_by_tags(3);
}

void check_bad_modes(Test& t) {
  set_up_errors(t, true);
  std::vector<GLenum> bad = {GL_POINTS,
                             GL_LINES,
                             GL_LINE_LOOP,
                             GL_LINE_STRIP,
                             GL_LINES_ADJACENCY,
                             GL_LINE_STRIP_ADJACENCY,
                             GL_PATCHES,
                             GL_TRIANGLES_ADJACENCY,
                             0x1234,
                             GL_TRIANGLE_STRIP_ADJACENCY};
  if (!t.is_compat()) bad.insert(bad.end(), {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
  for (const GLenum mode : bad) {
    const std::string name = "mode " + std::to_string(mode);
    expect_nothing_drawn(t, GL_INVALID_ENUM, "DrawARP, " + name, [mode] { gl.DrawARP(mode, 0, 6); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "DrawARPElementsARK, " + name,
                         [mode] { gl.DrawARPElementsARK(mode, 6, GL_UNSIGNED_BYTE, nullptr); });
  }
}

void check_before_init(Test& t) {
  set_up_errors(t, false);
  gl.DepthTag1i(0);
  t.expect_no_error("set-up");
  expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 6); });
  expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARPElementsARK",
                       [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr); });
}

void check_in_list(Test& t) {
  set_up_errors(t, true);
  const GLuint list = gl.GenLists(1);
  for (const GLenum how : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    gl.NewList(list, how);
    expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 6); });
    expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARPElementsARK",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr); });
    gl.EndList();
    expect_nothing_drawn(t, GL_NO_ERROR, "the list", [list] { gl.CallList(list); });
  }
}

void check_other_errors(Test& t) {
  set_up_errors(t, true);
  for (const bool is_enabled : {true, false}) {
    if (!is_enabled) gl.Disable(GL_ARK);
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative count", [] { gl.DrawARP(GL_TRIANGLES, 0, -3); });
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative first vertex", [] { gl.DrawARP(GL_TRIANGLES, -1, 3); });
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative count of indices",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, -1, GL_UNSIGNED_BYTE, nullptr); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "indices that are floats",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_FLOAT, nullptr); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "signed indices",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_SHORT, nullptr); });
  }
}

void check_framebuffer_error(Test& t) {
  set_up_errors(t, true);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint texture = 0;  // of no size: incomplete
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  t.expect_no_error("set-up");
  gl.DrawARP(GL_TRIANGLES, 0, 6);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawARP to an incomplete framebuffer");
  gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawARPElementsARK to an incomplete framebuffer");
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawArrays to an incomplete framebuffer");
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

// Errors of ordinary commands while ARK is enabled, and commands that draw nothing give none.
void check_ordinary_errors(Test& t) {
  set_up_errors(t, true);
  const auto expect = [&](GLenum error, const std::string& what, const std::function<void()>& draw) {
    gl.Disable(GL_ARK);
    expect_nothing_drawn(t, error, what + " without refinement", draw);
    gl.Enable(GL_ARK);
    expect_nothing_drawn(t, error, what, draw);
  };
  expect(GL_INVALID_ENUM, "mode 0x1234", [] { gl.DrawArrays(0x1234, 0, 3); });
  expect(GL_INVALID_VALUE, "a negative count", [] { gl.DrawArrays(GL_TRIANGLES, 0, -1); });
  expect(GL_INVALID_VALUE, "a negative number of instances", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, -1); });
  expect(GL_INVALID_ENUM, "a type of indices", [] { gl.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); });
  expect(GL_INVALID_VALUE, "a range that ends before it begins",
         [] { gl.DrawRangeElements(GL_TRIANGLES, 5, 2, 3, GL_UNSIGNED_BYTE, nullptr); });
  expect(GL_NO_ERROR, "no vertices", [] { gl.DrawArrays(GL_TRIANGLES, 0, 0); });
  expect(GL_NO_ERROR, "too few vertices", [] { gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 2); });
  expect(GL_NO_ERROR, "no instances", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 0); });
  expect(GL_NO_ERROR, "no indices", [] { gl.DrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, nullptr); });
}

Case error_case(const char* leaf, std::vector<std::string> clauses, const char* plan, void (*check)(Test&),
                Apis apis = every_api) {
  return {.name = std::string("ark.draw.errors.") + leaf,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong = "No error; another one; the command draws all the same, or changes ARK.",
          .apis = apis,
          .check = check};
}

}  // namespace

Cases draw_arp_cases() {
  Cases cases = {
      error_case("modes", {"10.R.2-10"}, "DrawARP and DrawARPElementsARK with every mode without triangles.",
                 check_bad_modes),
      error_case("before_init", {"10.R.2-11"}, "Both commands in a context without a pool.", check_before_init),
      error_case("in_list", {"10.R.2-11"}, "Both commands while a display list is compiled.", check_in_list,
                 compat_only),
      error_case("arguments", {"10.R.2-12", "10.R.2-9"}, "Both commands with what DrawArrays and DrawElements reject.",
                 check_other_errors),
      error_case("framebuffer", {"10.R.2-12", "10.R.2-13"}, "Draws to a framebuffer that is not complete.",
                 check_framebuffer_error),
      error_case("ordinary", {"10.R.2-13"},
                 "Ordinary commands that are rejected, or draw nothing, with and without ARK.", check_ordinary_errors)};
  for (const Mode& mode : modes) {
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
                     .wrong = "Unrefined; one tag or one colour for the primitive.",
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
                   .plan = "ArrayElement between Begin and End.",
                   .wrong = "Unrefined; tags of other vertices.",
                   .apis = compat_only,
                   .check = check_array_element});
  cases.push_back({.name = "ark.draw.arp.within_feedback",
                   .clauses = {"10.R.2-1", "10.R.2-6"},
                   .plan = "Capture DrawARP, and Enable(ARK) with a draw, in a capture that began with ARK disabled.",
                   .wrong = "Unrefined, because the capture began so.",
                   .check = check_within_feedback});
  cases.push_back({.name = "ark.draw.arp.elements.client_memory",
                   .clauses = {"10.R.2-8"},
                   .plan = "DrawARPElementsARK with indices in client memory.",
                   .wrong = "The pointer is taken for an offset.",
                   .apis = compat_only,
                   .check = check_client_elements});
  return cases;
}

}  // namespace glark::conformance
