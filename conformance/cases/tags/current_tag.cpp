// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The current depth tag: DepthTag1i, the attribute that carries it, and the value of CURRENT_DEPTH_TAG_ARK (10.R.1).
#include <algorithm>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using Limits = std::numeric_limits<float>;

GLuint tag_attribute() { return static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK)); }

void check_sets_attribute(Test& t) {
  gl.ARKinit(5);
  for (const GLint attribute : {integer_of(GL_MAX_VERTEX_ATTRIBS) - 1, 3}) {
    gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, attribute);
    const auto index = static_cast<GLuint>(attribute);
    for (const GLuint tag : {5U, 0U, 3U}) {
      gl.VertexAttrib4f(index, 9, 8, 7, 6);
      gl.DepthTag1i(tag);
      t.expect_no_error("DepthTag1i");
      t.expect(current_value(index) == std::vector<float>{static_cast<float>(tag), 0, 0, 1},
               "attribute " + as_text(attribute) + " is (" + as_text(tag) + ", 0, 0, 1)");
      t.expect_equal(GLuint(integer_of(GL_CURRENT_DEPTH_TAG_ARK)), tag, "CURRENT_DEPTH_TAG_ARK");
    }
  }
}

void check_nothing_else(Test& t) {
  set_everything(t);
  Snapshot expected = take_snapshot(t);
  expected["current_depth_tag"] = "2";
  expected["attribute 7 value"] = "2 0 0 1 ";
  gl.DepthTag1i(2);
  expect_unchanged(t, take_snapshot(t), expected, "DepthTag1i");
}

void check_limit(Test& t) {
  for (const GLuint tag : {1U, 11U, 0x80000000U, 0xFFFFFFFFU})
    expect_refused(t, GL_INVALID_VALUE, "tag " + as_text(tag) + " before ARKinit", [&] { gl.DepthTag1i(tag); });
  gl.DepthTag1i(0);
  t.expect_no_error("DepthTag1i(0) before ARKinit");
  for (const GLuint level : {0U, 4U, 11U}) {
    gl.ARKinit(level);
    gl.DepthTag1i(level);
    t.expect_no_error("DepthTag1i of the level");
    for (const GLuint tag : {level + 1, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU})
      expect_refused(t, GL_INVALID_VALUE, "tag " + as_text(tag) + " of a pool of level " + as_text(level),
                     [&] { gl.DepthTag1i(tag); });
  }
}

struct Rounding {
  const char* leaf;
  float value;
  GLint tag;
};

void check_rounding(Test& t, const Rounding& rounding) {
  gl.VertexAttrib4f(tag_attribute(), rounding.value, 3, 4, 5);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 0, "without a pool");
  gl.ARKinit(5);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), rounding.tag, "with a pool of level 5");
  t.expect_no_error("the queries");
}

// Draws with tags and, for comparison, at a uniform depth, which ignores tags.
void check_drawn(Test& t, const Rounding& rounding) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  refine_by_tags(5);
  gl.VertexAttrib4f(tag_attribute(), rounding.value, 3, 4, 5);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const GLuint triangles = GLuint{1} << (2 * rounding.tag);
  t.expect_equal(count_generated(draw), triangles, "triangles");
  t.expect_equal(capture(t, draw).size() / 3, std::size_t{triangles}, "triangles of transform feedback");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  for (const GLint level : {0, 1, 3}) {
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    t.expect_equal(count_generated(draw), GLuint{1} << (2 * level), "triangles of a uniform depth");
    t.expect_equal(capture(t, draw).size() / 3, std::size_t{1} << (2 * level), "captured ones of a uniform depth");
  }
  t.expect_no_error("the draws");
}

Case drawn_case(const Rounding& rounding) {
  return {
      .name = std::string("ark.tag.drawn.") + rounding.leaf,
      .clauses = {"10.R.1-3", "10.R.1-4", "10.R.1-5", "11.R.4-1"},
      .plan = "Draw with " + as_text(rounding.value) +
              " as the current value of the attribute, by tags and at three "
              "uniform depths, and count triangles, on the screen and in transform feedback.",
      .wrong = "Rounded down, or to even; not clamped; not a number is the greatest tag; tags count at uniform depths.",
      .check = [rounding](Test& t) { check_drawn(t, rounding); }};
}

// Tags of 4, 1 and 2 between Begin and End give 12 triangles for every earlier current tag.
void check_drawn_between(Test& t) {
  gl.UseProgram(capture_program(t));
  refine_by_tags(4);
  const auto draw = [] {
    const Mesh mesh = one_triangle();
    const GLuint tags[] = {4, 1, 2};
    gl.Begin(GL_TRIANGLES);
    for (std::size_t i = 0; i < 3; ++i) {
      gl.DepthTag1i(tags[i]);
      gl.VertexAttrib4fv(at_weights,
                         std::array<float, 4>{mesh[i].weights[0], mesh[i].weights[1], mesh[i].weights[2]}.data());
      gl.VertexAttrib4fv(0, mesh[i].position.data());
    }
    gl.End();
  };
  for (const GLuint tag : {0U, 4U}) {
    gl.DepthTag1i(tag);
    t.expect_equal(count_generated(draw), 12U, "triangles");
    gl.DepthTag1i(tag);
    t.expect_equal(capture(t, draw).size(), 36U, "vertices of transform feedback");
  }
}

Case rounding_case(const Rounding& rounding) {
  return {.name = std::string("ark.tag.current.") + rounding.leaf,
          .clauses = {"10.R.1-16", "10.R.1-2"},
          .plan = "Set the attribute to " + as_text(rounding.value) +
                  " by VertexAttrib4f and ask for CURRENT_DEPTH_TAG_ARK, without a pool and with one of level 5.",
          .wrong = "The last value of DepthTag1i; rounded to even, or down; not clamped.",
          .check = [rounding](Test& t) { check_rounding(t, rounding); }};
}

void check_array_makes_no_difference(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle({4, 1, 2}));
  gl.ARKinit(4);
  gl.DepthTag1i(3);
  gl.Enable(GL_ARK);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "while the array is enabled");
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U * 12U, "vertices with the array");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "after a draw");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U * 64U, "vertices without it");
  gl.DepthTag1i(1);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U * 4U, "vertices with another tag");
}

void draws_one_triangle(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U, "vertices of the coarse draw");
}

void check_attribute_changed(Test& t) {
  set_everything(t);
  gl.VertexAttrib4f(9, 1, 2, 3, 4);
  Snapshot before = take_snapshot(t);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 9);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag of attribute 9");
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "the array of attribute 9");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_TYPE_ARK), GLint{GL_FLOAT}, "its type");
  t.expect(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK) == nullptr, "its pointer");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 7);
  expect_unchanged(t, take_snapshot(t), before, "attribute 9 and back");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 9);
  gl.DepthTag1i(4);
  gl.DepthTagPointerARK(GL_FLOAT, 8, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect(current_value(7) == std::vector<float>{3, 0, 0, 1}, "the value of attribute 7 stays");
  t.expect_equal(array_state(7, GL_VERTEX_ATTRIB_ARRAY_STRIDE), 6, "the stride of attribute 7 stays");
  t.expect_equal(array_state(9, GL_VERTEX_ATTRIB_ARRAY_STRIDE), 8, "the stride of attribute 9");
  t.expect_equal(array_state(9, GL_VERTEX_ATTRIB_ARRAY_ENABLED), 1, "attribute 9 is enabled");
  t.expect_no_error("the commands");
}

void check_draw_after_change(Test& t) {
  draws_one_triangle(t);
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  const auto vertices = [&] { return capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size() / 3; };
  gl.DepthTag1i(2);
  t.expect_equal(vertices(), 16U, "triangles with the tag 2");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 9);
  t.expect_equal(vertices(), 1U, "triangles with the tag of attribute 9, 0");
  gl.DepthTag1i(3);
  t.expect_equal(vertices(), 64U, "triangles with the tag 3 in attribute 9");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, integer_of(GL_MAX_VERTEX_ATTRIBS) - 1);
  t.expect_equal(vertices(), 16U, "triangles with the first attribute again");
  gl.VertexAttrib1f(tag_attribute(), 0.75F);
  t.expect_equal(vertices(), 4U, "triangles with the tag that VertexAttrib1f set");
}

// The value that a vertex shader reads from the attribute.
void check_input(Test& t) {
  const std::string location = std::to_string(tag_attribute());
  const GLuint program =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = " + location +
                                  ") in float tag; out float tag_out; out vec4 colour;\n"
                                  "void main() { tag_out = tag; colour = vec4(1.0); gl_Position = position; }\n",
                        .captured = {"tag_out"}});
  gl.UseProgram(program);
  upload(one_triangle({1.3F, -2.6F, 9.75F}));
  refine_uniformly(0);
  const auto values = [&] { return capture_as<float>(t, 100, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }); };
  const auto coarse = values();
  for (const float expected : {1.3F, -2.6F, 9.75F})
    t.expect(std::count(coarse.begin(), coarse.end(), expected) == 1, "a corner reads " + as_text(expected));
  refine_uniformly(1);
  const auto fine = values();
  t.require(fine.size() == 12, "four triangles");
  for (const float expected : {0.5F * 1.3F + 0.5F * -2.6F, 0.5F * -2.6F + 0.5F * 9.75F, 0.5F * 1.3F + 0.5F * 9.75F})
    t.expect(std::count(fine.begin(), fine.end(), expected) == 3, "three vertices read " + as_text(expected));
}

// DepthTag1i always makes the current value a floating-point one.
void check_after_integers(Test& t) {
  draws_one_triangle(t);
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  gl.VertexAttribI4i(tag_attribute(), 1, 2, 3, 4);
  gl.DepthTag1i(2);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 48U, "vertices with the tag 2");
  t.expect(current_value(tag_attribute()) == std::vector<float>{2, 0, 0, 1}, "the attribute's value");
}

}  // namespace

Cases current_tag_cases() {
  Cases cases{
      {.name = "ark.tag.command.sets_attribute",
       .clauses = {"10.R.1-10", "10.R.1-11", "10.R.1-12", "functions-4", "tokens-6", "10.R.1-2"},
       .plan = "Give the attribute other values, call DepthTag1i and ask for all four components, for two attributes.",
       .wrong = "(d, 0, 0, 0); components that stay; the bits of an integer.",
       .check = check_sets_attribute},
      {.name = "ark.tag.command.nothing_else",
       .clauses = {"10.R.1-12"},
       .plan = "Compare all state before and after DepthTag1i.",
       .wrong = "It disables the array, or sets the uniform level.",
       .check = check_nothing_else},
      {.name = "ark.tag.command.limit",
       .clauses = {"10.R.1-15", "errors-11"},
       .plan = "Set tags at the pool's level and above it, before ARKinit and with pools of level 0, 4 and 11.",
       .wrong = "Clamped without an error; MAX_DEPTH_ARK is the limit; 0 is refused before ARKinit.",
       .check = check_limit},
      {.name = "ark.tag.command.after_integers",
       .clauses = {"10.R.1-6", "10.R.1-12"},
       .plan = "Make the attribute's value an integer, call DepthTag1i, draw and count.",
       .wrong = "2 as the bits of an integer: a tag of 0.",
       .control = draws_one_triangle,
       .check = check_after_integers},
      {.name = "ark.tag.current.array",
       .clauses = {"10.R.1-16", "10.R.1-11"},
       .plan = "Draw with the array, disable it and draw with the current tag, which the array does not change.",
       .wrong = "The last tag of the array becomes the current one.",
       .control = draws_one_triangle,
       .check = check_array_makes_no_difference},
      {.name = "ark.tag.attribute.kept",
       .clauses = {"10.R.1-29", "11.R.2-7"},
       .plan = "Change DEPTH_TAG_ATTRIBUTE_ARK, check the tag and the array that it now names, and change it back.",
       .wrong = "The value or the array is copied to the other attribute, or reset.",
       .check = check_attribute_changed},
      {.name = "ark.tag.attribute.draw",
       .clauses = {"10.R.1-29", "10.R.1-2", "11.R.2-7"},
       .plan = "Draw with the tags of two attributes in turn and count.",
       .wrong = "Draws use the attribute from before the change.",
       .control = draws_one_triangle,
       .check = check_draw_after_change},
      {.name = "ark.tag.attribute.input",
       .clauses = {"10.R.1-8"},
       .plan = "A vertex shader writes the attribute to transform feedback: 1.3, -2.6 and 9.75, and their means.",
       .wrong = "The shader reads rounded or clamped values, or the same value at all refined vertices.",
       .control = draws_one_triangle,
       .check = check_input},
  };
  for (const Rounding& rounding : std::initializer_list<Rounding>{
           {"zero", 0, 0},
           {"below_half", 0.49999997F, 0},
           {"half", 0.5F, 1},
           {"one_and_a_half", 1.5F, 2},
           {"two_and_a_half", 2.5F, 3},
           {"fraction", 3.4F, 3},
           {"minus_half", -0.5F, 0},
           {"negative", -7, 0},
           {"at_the_level", 5.25F, 5},
           {"above_the_level", 99, 5},
           {"great", 3e9F, 5},
           {"infinite", Limits::infinity(), 5},
           {"minus_infinite", -Limits::infinity(), 0},
           {"not_a_number", Limits::quiet_NaN(), 0},
       }) {
    cases.push_back(rounding_case(rounding));
    cases.push_back(drawn_case(rounding));
  }
  cases.push_back(
      {.name = "ark.tag.drawn.between",
       .clauses = {"10.R.1-13", "10.R.2-2"},
       .plan = "Set another tag at each vertex between Begin and End; count on the screen and in transform feedback.",
       .wrong = "The tag at Begin, or the last one, for all vertices.",
       .apis = compat_only,
       .control =
           [](Test& t) {
             gl.UseProgram(capture_program(t));
             t.expect_equal(count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }), 1U, "triangles unrefined");
           },
       .check = check_drawn_between});
  return cases;
}

}  // namespace glark::conformance
