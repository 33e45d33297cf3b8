// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// ARKinit lowers the current depth tag while a list is compiled (11.R.1, chapter 21), and commands set the tag before
// or after it.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/lists/immediate_triangle.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLuint inner_list = 5;
constexpr GLuint tested_list = 6;

GLuint attribute_of_tags() { return static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK)); }

struct TagCommand {
  const char* leaf;
  void (*set)(GLuint tag);
};

template <typename Number>
std::array<Number, 4> tag_vector(GLuint tag) {
  return {static_cast<Number>(tag), 0, 0, 1};
}

// All commands that set the attribute of the tags.
constexpr TagCommand tag_commands[] = {
    {"depth_tag", [](GLuint tag) { gl.DepthTag1i(tag); }},
    {"attribute_1f", [](GLuint tag) { gl.VertexAttrib1f(attribute_of_tags(), static_cast<GLfloat>(tag)); }},
    {"attribute_1fv", [](GLuint tag) { gl.VertexAttrib1fv(attribute_of_tags(), tag_vector<GLfloat>(tag).data()); }},
    {"attribute_1s", [](GLuint tag) { gl.VertexAttrib1s(attribute_of_tags(), static_cast<GLshort>(tag)); }},
    {"attribute_1d", [](GLuint tag) { gl.VertexAttrib1d(attribute_of_tags(), tag); }},
    {"attribute_2f", [](GLuint tag) { gl.VertexAttrib2f(attribute_of_tags(), static_cast<GLfloat>(tag), 0); }},
    {"attribute_3f", [](GLuint tag) { gl.VertexAttrib3f(attribute_of_tags(), static_cast<GLfloat>(tag), 0, 0); }},
    {"attribute_4f", [](GLuint tag) { gl.VertexAttrib4f(attribute_of_tags(), static_cast<GLfloat>(tag), 0, 0, 1); }},
    {"attribute_4fv", [](GLuint tag) { gl.VertexAttrib4fv(attribute_of_tags(), tag_vector<GLfloat>(tag).data()); }},
    {"attribute_4sv", [](GLuint tag) { gl.VertexAttrib4sv(attribute_of_tags(), tag_vector<GLshort>(tag).data()); }},
    {"attribute_4ubv", [](GLuint tag) { gl.VertexAttrib4ubv(attribute_of_tags(), tag_vector<GLubyte>(tag).data()); }},
    {"attribute_4dv", [](GLuint tag) { gl.VertexAttrib4dv(attribute_of_tags(), tag_vector<GLdouble>(tag).data()); }},
    {"within_begin",
     [](GLuint tag) {
       gl.Begin(GL_TRIANGLES);
       gl.DepthTag1i(tag);
       gl.VertexAttrib4f(0, 0.5F, 0.5F, 0, 1);  // without a vertex, Mesa 22.3 leaves any value
       gl.End();
     }},
    {"called", [](GLuint tag) { gl.CallList(inner_list + 10 * tag); }},
    {"pop_attrib",
     [](GLuint tag) {
       gl.DepthTag1i(tag);
       gl.PushAttrib(GL_CURRENT_BIT);
       gl.DepthTag1i(0);
       gl.PopAttrib();
     }},
};

void compile_inner_lists() {
  for (GLuint tag = 0; tag < 4; ++tag) {
    gl.NewList(inner_list + 10 * tag, GL_COMPILE);
    gl.DepthTag1i(tag);
    gl.EndList();
  }
}

void expect_tag(Test& t, GLint tag, const std::string& what) {
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), tag, "the current tag " + what);
  t.expect_equal(current_value(attribute_of_tags())[0], static_cast<float>(tag), "the attribute " + what);
}

// The tag is 4. The list has a command that sets it to 1, and ARKinit(2) comes before it or after it.
void check_lowered(Test& t, const TagCommand& command, GLenum mode, bool is_set_first) {
  refine_immediate_triangles(t, 4);
  compile_inner_lists();
  gl.DepthTag1i(4);
  gl.NewList(tested_list, mode);
  if (is_set_first) command.set(1);
  gl.ARKinit(2);
  if (!is_set_first) command.set(1);
  gl.EndList();
  const bool executes = mode == GL_COMPILE_AND_EXECUTE;
  const GLint left = executes ? 1 : 2;
  expect_tag(t, left, "after the list");
  t.expect_equal(triangles_of(t, draw_immediate_triangle), std::size_t{1} << (2 * left), "triangles after the list");
  gl.DepthTag1i(0);
  gl.CallList(tested_list);
  expect_tag(t, 1, "after the call");
  gl.ARKinit(4);
  expect_tag(t, 1, "after a higher level");
  gl.DepthTag1i(4);
  gl.CallList(tested_list);
  expect_tag(t, 1, "after a call at a higher level");
  t.expect_no_error("the lists");
}

// The level is lowered and raised again in the list: the tag stays low.
void check_raised(Test& t, GLenum mode) {
  refine_immediate_triangles(t, 4);
  gl.DepthTag1i(4);
  gl.NewList(tested_list, mode);
  gl.ARKinit(1);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag at the low level");
  gl.ARKinit(4);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag at the level that is raised again");
  gl.EndList();
  expect_tag(t, 1, "after the list");
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 4U, "triangles");
  gl.DepthTag1i(3);
  gl.CallList(tested_list);
  expect_tag(t, 3, "after the call of the list, which is empty");
  t.expect_no_error("the lists");
}

// What a list that is executed at once draws behind ARKinit has the lowered tag.
void check_drawn(Test& t) {
  gl.UseProgram(colour_program(t));
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  gl.DepthTag1i(4);
  const GLuint drawn = count_generated([] {
    gl.NewList(tested_list, GL_COMPILE_AND_EXECUTE);
    gl.ARKinit(2);
    draw_immediate_triangle();
    gl.EndList();
  });
  t.expect_equal(drawn, 16U, "triangles that are drawn while the list is compiled");
  gl.DepthTag1i(1);
  t.expect_equal(count_generated([] { gl.CallList(tested_list); }), 4U, "triangles of the call, at the current tag");
}

}  // namespace

Cases lowered_tags_cases() {
  Cases cases;
  for (const bool executes : {false, true}) {
    const GLenum mode = executes ? GL_COMPILE_AND_EXECUTE : GL_COMPILE;
    const std::string leaf = executes ? "executed" : "compiled";
    for (const TagCommand& command : tag_commands)
      for (const bool is_set_first : {false, true})
        cases.push_back(
            {.name = fmt::format("ark.list.lowered.{}.{}{}", command.leaf, leaf, is_set_first ? ".before" : ""),
             .clauses = {"11.R.1-6", "chapter-21-2", "chapter-21-7"},
             .plan = "While a list is compiled, ARKinit lowers the tag, and this command sets it, before or "
                     "after that.",
             .wrong = "The lowered tag replaces one that is set later, or is compiled into the list.",
             .apis = compat_only,
             .check = [&command, mode, is_set_first](Test& t) { check_lowered(t, command, mode, is_set_first); }});
    cases.push_back({.name = "ark.list.lowered.raised." + leaf,
                     .clauses = {"11.R.1-6", "chapter-21-7"},
                     .plan = "While a list is compiled, ARKinit lowers the level and raises it again.",
                     .wrong = "The tag is the one from before; it is compiled.",
                     .apis = compat_only,
                     .check = [mode](Test& t) { check_raised(t, mode); }});
  }
  cases.push_back({.name = "ark.list.lowered.drawn",
                   .clauses = {"11.R.1-6", "chapter-21-5"},
                   .plan = "A list with COMPILE_AND_EXECUTE lowers the tag and draws.",
                   .wrong = "The draw has the earlier tag.",
                   .apis = compat_only,
                   .check = check_drawn});
  return cases;
}

}  // namespace glark::conformance
