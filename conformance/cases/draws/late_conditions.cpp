// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that repeat often within conditional rendering. The result of the query changes late, when an implementation may
// keep what the draws have computed: each draw obeys the result of its own time.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

struct LateWay {
  const char* leaf;
  void (*draw)();
  Apis apis = desktop_apis;
};

void late_begin() {
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : four_triangles()) {
    gl.VertexAttrib4fv(at_colour, vertex.colour.data());
    gl.VertexAttrib4fv(at_position, vertex.position.data());
  }
  gl.End();
}

// Each draws the four triangles once. Elements, commands and the list are those of set_up_late().
constexpr LateWay late_ways[] = {
    {"draw_arrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }},
    {"draw_elements", [] { gl.DrawElements(GL_TRIANGLES, all_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"draw_elements_base_vertex",
     [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, all_vertices, GL_UNSIGNED_SHORT, nullptr, 0); }},
    {"draw_arrays_instanced", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, all_vertices, 1); }},
    {"multi_draw_arrays",
     [] {
       constexpr std::array<GLint, 2> firsts = {0, 6};
       constexpr std::array<GLsizei, 2> counts = {6, 6};
       gl.MultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), 2);
     }},
    {"draw_arrays_indirect", [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }},
    {"draw_elements_indirect", [] { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr); }},
    {"draw_arp", [] { gl.DrawARP(GL_TRIANGLES, 0, all_vertices); }},
    {"draw_arp_elements", [] { gl.DrawARPElementsARK(GL_TRIANGLES, all_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"begin", late_begin, compat_only},
    {"list", [] { gl.CallList(1); }, compat_only},
    {"fixed_function",
     [] {
       gl.UseProgram(0);
       gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, position)));
       gl.ColorPointer(4, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, colour)));
       gl.EnableClientState(GL_VERTEX_ARRAY);
       gl.EnableClientState(GL_COLOR_ARRAY);
       gl.DrawArrays(GL_TRIANGLES, 0, all_vertices);
     },
     compat_only},
};

void set_up_late(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = four_triangles();
  for (MeshVertex& vertex : mesh) vertex.colour[2] = std::min(vertex.colour[2], 1.0F);  // the fixed function clamps it
  upload(mesh, false);
  std::array<GLushort, all_vertices> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLushort>(i);
  constexpr GLuint command[] = {all_vertices, 1, 0, 0, 0};
  std::array<GLuint, 2> buffers{};
  gl.GenBuffers(2, buffers.data());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(command), command, GL_STATIC_DRAW);
  gl.ARKinit(2);
  if (t.is_compat()) {
    gl.NewList(1, GL_COMPILE);
    late_begin();
    gl.EndList();
  }
  gl.Enable(GL_ARK);
}

// What an implementation may keep of a draw.
struct LateKind {
  const char* leaf;
  void (*choose)(Test&);
};

void choose(GLenum refinement, GLenum source) {
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  gl.DepthTag1i(2);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
}

constexpr LateKind late_kinds[] = {
    {"inputs", [](Test&) { choose(GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK); }},
    {"outputs", [](Test&) { choose(GL_LINEAR_OUTPUTS_ARK, GL_UNIFORM_DEPTH_ARK); }},
    {"tags", [](Test&) { choose(GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK); }},
    {"measured", [](Test&) { choose(GL_LINEAR_INPUTS_ARK, GL_MEASURED_DEPTH_ARK); }},
    {"welded",
     [](Test&) {
       choose(GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK);
       gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
     }},
    {"shader",
     [](Test& t) {
       choose(GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK);
       GLint program = 0;
       gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
       if (program != 0) give(static_cast<GLuint>(program), "void refine() { position.x += 0.0; }");
       if (t.is_compat()) give(0, "void refine() { gl_Vertex.x += 0.0; }");
     }},
};

constexpr GLuint late_triangles = 4 << (2 * 2);

// The query of a condition. Counting again gives it another result.
class LateQuery {
 public:
  LateQuery() { gl.GenQueries(1, &name_); }
  // Counts samples, or none. The draw is not refined, and not among those that the case repeats.
  void count(bool some) const {
    gl.Disable(GL_ARK);
    gl.BeginQuery(GL_ANY_SAMPLES_PASSED, name_);
    if (some) gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.EndQuery(GL_ANY_SAMPLES_PASSED);
    gl.Enable(GL_ARK);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct LateMode {
  GLenum mode;
  bool is_inverted;
};
constexpr LateMode late_modes[] = {{GL_QUERY_WAIT, false},
                                   {GL_QUERY_BY_REGION_WAIT, false},
                                   {GL_QUERY_WAIT_INVERTED, true},
                                   {GL_QUERY_BY_REGION_WAIT_INVERTED, true}};

struct LateDraw {
  const LateWay& way;
  const LateMode& mode;
  const LateQuery& query;

  void operator()() const {
    gl.BeginConditionalRender(query.name(), mode.mode);
    way.draw();
    gl.EndConditionalRender();
  }
};

void expect_late(Test& t, const LateDraw& draw, const Picture& plain, bool is_shown, const std::string& what) {
  GLuint counted = 0;
  const Picture picture = picture_of([&] { counted = count_generated([&] { draw(); }); });
  const std::string state = what + (is_shown ? ", shown" : ", hidden");
  t.expect_equal(counted, is_shown ? late_triangles : 0, state + ": triangles");
  t.expect_same_picture(picture, is_shown ? plain : Picture(surface_size, surface_size), state, 2, 40);
}

void check_late(Test& t, const LateWay& way) {
  set_up_late(t);
  const LateQuery query;
  unsigned turn = 0;
  for (const LateKind& kind : late_kinds) {
    const LateMode& mode = late_modes[turn++ % (t.version() < 45 ? 2 : 4)];
    gl.ARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    kind.choose(t);
    gl.Disable(GL_ARK);
    const Picture plain = picture_of(way.draw);
    gl.Enable(GL_ARK);
    const LateDraw draw{way, mode, query};
    for (const bool is_shown : {false, true, false, true}) {
      query.count(is_shown != mode.is_inverted);
      expect_late(t, draw, plain, is_shown, kind.leaf);
      repeat_often([&] { draw(); });
      expect_late(t, draw, plain, is_shown, std::string(kind.leaf) + ", often");
    }
    repeat_often(way.draw);
    query.count(mode.is_inverted);
    expect_late(t, draw, plain, false, std::string(kind.leaf) + ", after draws without a condition");
    t.expect_equal(count_generated(way.draw), late_triangles, std::string(kind.leaf) + ": triangles afterwards");
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases late_conditions_cases() {
  Cases cases;
  for (const LateWay& way : late_ways)
    cases.push_back({.name = std::string("ark.draw.conditional.late.") + way.leaf,
                     .clauses = {"10.R.2-2", "11.R.13-1", "chapter-14-9"},
                     .plan = "Draw often under a condition, with all that may be kept of a draw, while the result of "
                             "the query changes.",
                     .wrong = "A kept draw ignores its condition, or obeys that of an earlier draw.",
                     .apis = way.apis,
                     .check = [&way](Test& t) { check_late(t, way); }});
  return cases;
}

}  // namespace glark::conformance
