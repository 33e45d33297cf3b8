// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lists compiled from arrays. GL reads the arrays when it compiles the draw; what becomes of an array later does not
// concern the list (GL 4.6 compatibility profile, 21.4).
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLuint arrays_list = 71;
constexpr GLuint arrays_caller = 72;
constexpr GLuint at_generic = 6;

struct CompiledVertex {
  Vec3 place;
  Vec3 colour;
  Vec2 coordinate;
  float generic;
  float tag;
};
using CompiledMesh = std::array<CompiledVertex, 6>;

// Two triangles with tags of 2 and 1, or other ones in other places.
CompiledMesh compiled_mesh(bool is_other) {
  CompiledMesh mesh{};
  constexpr float places[6][2] = {{-0.9F, -0.6F}, {0, -0.7F},    {-0.4F, 0.7F},
                                  {0.1F, -0.5F},  {0.9F, -0.7F}, {0.6F, 0.8F}};
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const float turn = is_other ? 0.75F : 0.25F;
    const auto part = static_cast<float>(i) / 6;
    mesh[i].place = {(is_other ? -0.6F : 1.0F) * places[i][0], (is_other ? -0.5F : 1.0F) * places[i][1], 0};
    mesh[i].colour = {turn, part, 1 - part};
    mesh[i].coordinate = {is_other ? part : 1 - part, 0.5F};
    mesh[i].generic = turn / 2;
    mesh[i].tag = is_other ? 3.0F : i < 3 ? 2.0F : 1.0F;
  }
  return mesh;
}
constexpr GLuint compiled_triangles = 16 + 4;
constexpr GLuint untagged_triangles = 64 + 64;  // by the current tag

struct CompiledScene {
  CompiledMesh first = compiled_mesh(false);
  CompiledMesh other = compiled_mesh(true);
  CompiledMesh written{};
  bool is_in_memory = false;
  GLuint buffer = 0;
  GLuint other_buffer = 0;

  const char* address(const CompiledMesh& mesh) const {
    return is_in_memory ? reinterpret_cast<const char*>(mesh.data()) : nullptr;
  }
};

// One of the arrays.
struct CompiledArray {
  const char* name;
  void (*point)(const char* vertices);
  void (*enable)();
  void (*disable)();
};

constexpr GLsizei compiled_stride = sizeof(CompiledVertex);

constexpr CompiledArray compiled_arrays[] = {
    {"tags",
     [](const char* at) { gl.DepthTagPointerARK(GL_FLOAT, compiled_stride, at + offsetof(CompiledVertex, tag)); },
     [] { gl.Enable(GL_DEPTH_TAG_ARRAY_ARK); }, [] { gl.Disable(GL_DEPTH_TAG_ARRAY_ARK); }},
    {"colours",
     [](const char* at) { gl.ColorPointer(3, GL_FLOAT, compiled_stride, at + offsetof(CompiledVertex, colour)); },
     [] { gl.EnableClientState(GL_COLOR_ARRAY); }, [] { gl.DisableClientState(GL_COLOR_ARRAY); }},
    {"coordinates",
     [](const char* at) {
       gl.ClientActiveTexture(GL_TEXTURE1);
       gl.TexCoordPointer(2, GL_FLOAT, compiled_stride, at + offsetof(CompiledVertex, coordinate));
     },
     [] { gl.EnableClientState(GL_TEXTURE_COORD_ARRAY); }, [] { gl.DisableClientState(GL_TEXTURE_COORD_ARRAY); }},
    {"generic",
     [](const char* at) {
       gl.VertexAttribPointer(at_generic, 1, GL_FLOAT, GL_FALSE, compiled_stride,
                              at + offsetof(CompiledVertex, generic));
     },
     [] { gl.EnableVertexAttribArray(at_generic); }, [] { gl.DisableVertexAttribArray(at_generic); }},
    {"places",
     [](const char* at) { gl.VertexPointer(3, GL_FLOAT, compiled_stride, at + offsetof(CompiledVertex, place)); },
     [] { gl.EnableClientState(GL_VERTEX_ARRAY); }, [] { gl.DisableClientState(GL_VERTEX_ARRAY); }},
};

void set_up_compiled_arrays(CompiledScene& s) {
  gl.BindVertexArray(0);
  s.written = s.first;
  for (const auto& [buffer, mesh] : {std::pair{&s.buffer, &s.first}, {&s.other_buffer, &s.other}}) {
    gl.DeleteBuffers(1, buffer);
    gl.GenBuffers(1, buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, *buffer);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(*mesh), mesh->data(), GL_STATIC_DRAW);
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, s.is_in_memory ? 0 : s.buffer);
  for (const CompiledArray& array : compiled_arrays) {
    array.point(s.address(s.written));
    array.enable();
  }
  gl.Color3f(0.5F, 0.5F, 0.5F);
  gl.MultiTexCoord2f(GL_TEXTURE1, 0.25F, 0);
  gl.VertexAttrib1f(at_generic, 0.125F);
}

// What becomes of an array.
struct ArrayFate {
  const char* leaf;
  void (*meet)(CompiledScene& s, const CompiledArray& array);
};

constexpr ArrayFate array_fates[] = {
    {"disabled", [](CompiledScene&, const CompiledArray& array) { array.disable(); }},
    {"pointed",
     [](CompiledScene& s, const CompiledArray& array) {
       gl.BindBuffer(GL_ARRAY_BUFFER, s.is_in_memory ? 0 : s.other_buffer);
       array.point(s.address(s.other));
     }},
    {"written",
     [](CompiledScene& s, const CompiledArray&) {
       s.written = s.other;
       gl.BindBuffer(GL_ARRAY_BUFFER, s.buffer);
       gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof(s.other), s.other.data());
     }},
    {"deleted",
     [](CompiledScene& s, const CompiledArray& array) {
       array.disable();
       gl.DeleteBuffers(1, &s.buffer);
       s.buffer = 0;
     }},
    {"unbound",
     [](CompiledScene& s, const CompiledArray& array) {
       GLuint object = 0;
       gl.GenVertexArrays(1, &object);
       gl.BindVertexArray(object);
       gl.BindBuffer(GL_ARRAY_BUFFER, s.other_buffer);
       array.point(nullptr);
       array.enable();
     }},
};

struct CompiledDraw {
  const char* leaf;
  void (*draw)();
};

constexpr GLubyte compiled_elements[] = {0, 1, 2, 3, 4, 5};
constexpr CompiledDraw compiled_draws[] = {
    {"arrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); }},
    {"elements", [] { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, compiled_elements); }},
    {"range_elements", [] { gl.DrawRangeElements(GL_TRIANGLES, 0, 5, 6, GL_UNSIGNED_BYTE, compiled_elements); }},
    {"multi_arrays",
     [] {
       const GLint first[] = {0, 3};
       const GLsizei count[] = {3, 3};
       gl.MultiDrawArrays(GL_TRIANGLES, first, count, 2);
     }},
    {"multi_elements",
     [] {
       const void* const elements[] = {compiled_elements, compiled_elements + 3};
       const GLsizei count[] = {3, 3};
       gl.MultiDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_BYTE, elements, 2);
     }},
    {"base_vertex", [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, compiled_elements, 0); }},
    {"array_elements",
     [] {
       gl.Begin(GL_TRIANGLES);
       for (GLint i = 0; i < 6; ++i) gl.ArrayElement(i);
       gl.End();
     }},
};

GLuint compiled_arrays_program(Test& t) {
  return build_program(t, {.vertex = "layout(location = 6) in float generic; out vec4 colour;\n"
                                     "void main() { colour = vec4(gl_Color.rg, gl_MultiTexCoord1.x, 1.0);\n"
                                     "  colour.r += generic; gl_Position = gl_Vertex; }\n"});
}

struct CompiledExpected {
  Picture picture;
  GLuint triangles;
};

void expect_compiled(Test& t, const CompiledExpected& expected, GLuint list, const std::string& what) {
  for (int again = 0; again < 2; ++again) {
    const auto call = [list] { gl.CallList(list); };
    t.expect_equal(count_generated(call), expected.triangles, what + ": triangles");
    t.expect_same_picture(picture_of(call), expected.picture, what, 4, 80);
    gl.DepthTag1i(3);  // a list leaves its last tag
  }
}

// `is_late`: the list is called before the array meets its fate. Then another fate follows.
void check_fate(Test& t, CompiledScene& s, const CompiledDraw& draw, const CompiledArray& array, std::size_t fate,
                bool is_late) {
  const std::string what = fmt::format("{} {}, in {}, {}", array.name, array_fates[fate].leaf,
                                       s.is_in_memory ? "memory" : "a buffer", is_late ? "between calls" : "at first");
  set_up_compiled_arrays(s);
  gl.DepthTag1i(3);
  gl.Disable(GL_ARK);
  const CompiledExpected expected{picture_of(draw.draw), compiled_triangles};
  gl.Enable(GL_ARK);
  gl.NewList(arrays_list, GL_COMPILE);
  draw.draw();
  gl.EndList();
  if (is_late) {
    expect_compiled(t, expected, arrays_list, what + ": before");
    repeat_often([] { gl.CallList(arrays_list); });
  }
  array_fates[fate].meet(s, array);
  expect_compiled(t, expected, arrays_list, what);
  array_fates[(fate + 1) % std::size(array_fates)].meet(s, array);
  expect_compiled(t, expected, arrays_caller, what + ": by a list, after another change");
}

void check_compiled_arrays(Test& t, const CompiledDraw& draw, std::size_t fate) {
  gl.UseProgram(compiled_arrays_program(t));
  gl.ARKinit(3);
  gl.NewList(arrays_caller, GL_COMPILE);
  gl.CallList(arrays_list);
  gl.EndList();
  CompiledScene s;
  std::size_t turn = 0;
  for (const CompiledArray& array : compiled_arrays)
    for (const bool is_late : {false, true}) {
      s.is_in_memory = ++turn % 3 == 0;
      check_fate(t, s, draw, array, fate, is_late);
    }
  t.expect_no_error("the lists");
}

// The list has no tags: those of the array that is enabled afterwards do not concern it.
void check_enabled_later(Test& t, const CompiledDraw& draw) {
  gl.UseProgram(compiled_arrays_program(t));
  gl.ARKinit(3);
  CompiledScene s;
  set_up_compiled_arrays(s);
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  const CompiledExpected expected{picture_of(draw.draw), untagged_triangles};
  gl.Enable(GL_ARK);
  gl.NewList(arrays_list, GL_COMPILE);
  draw.draw();
  gl.EndList();
  for (const bool is_enabled : {true, false, true}) {
    gl.DepthTag1i(3);
    is_enabled ? gl.Enable(GL_DEPTH_TAG_ARRAY_ARK) : gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
    expect_compiled(t, expected, arrays_list, is_enabled ? "while tags are enabled" : "while tags are disabled");
    repeat_often([] { gl.CallList(arrays_list); });
  }
  t.expect_no_error("the lists");
}

}  // namespace

Cases compiled_arrays_cases() {
  Cases cases;
  const auto add = [&](const std::string& leaf, std::function<void(Test&)> check) {
    cases.push_back({.name = "ark.list.arrays." + leaf,
                     .clauses = {"chapter-21-5", "10.R.1-17", "10.R.2-2"},
                     .plan = "Compile this draw of arrays, and change one of the arrays before the list is called and "
                             "between calls: tags, colours, coordinates and places stay those of the compilation.",
                     .wrong = "The tags of an array that is disabled or written later are lost, or taken for new ones.",
                     .apis = compat_only,
                     .check = std::move(check)});
  };
  for (const CompiledDraw& draw : compiled_draws) {
    for (std::size_t fate = 0; fate < std::size(array_fates); ++fate)
      add(fmt::format("{}.{}", draw.leaf, array_fates[fate].leaf),
          [&draw, fate](Test& t) { check_compiled_arrays(t, draw, fate); });
    add(fmt::format("{}.enabled_later", draw.leaf), [&draw](Test& t) { check_enabled_later(t, draw); });
  }
  return cases;
}

}  // namespace glark::conformance
