// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags that do not come from a plain array: the current tag, tags per instance, from a base vertex, between Begin
// and End, from an attribute that moved (10.R.1).
#include <fmt/core.h>
#include <algorithm>
#include <limits>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

using reference::Depths;

constexpr int pool = 6;

// The coarse triangles of one_triangle(), numbered.
Mesh repeated(std::size_t triangles) {
  Mesh mesh(3 * triangles);
  const Mesh one = one_triangle();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i] = one[i % 3];
  number_triangles(mesh);
  return mesh;
}

GLuint bind_tags(const std::vector<float>& tags) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(tags.size() * sizeof(float)), tags.data(), GL_STATIC_DRAW);
  return buffer;
}

void expect_depths(Test& t, const std::vector<Depths>& expected, const std::function<void()>& draw,
                   const std::string& what) {
  const auto found = depths_of(t, expected.size(), draw);
  for (std::size_t i = 0; i < found.size(); ++i)
    t.expect(found[i] == expected[i], fmt::format("{}: triangle {} has the depths {}, not {}", what, i,
                                                  text_of(found[i]), text_of(expected[i])));
}

void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void set_up_one(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  refine_by_tags(pool);
}

Depths uniform(int depth) { return {depth, depth, depth}; }

void check_current(Test& t) {
  set_up_one(t);
  expect_depths(t, {uniform(0)}, draw_one, "initially");
  for (const GLuint tag : {3U, 0U, 5U, 1U}) {
    gl.DepthTag1i(tag);
    expect_depths(t, {uniform(static_cast<int>(tag))}, draw_one, "DepthTag1i");
  }
}

// The current value of the attribute counts, as VertexAttrib* sets it.
void check_current_attribute(Test& t) {
  set_up_one(t);
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float value : {2.5F, 2.4F, 0.49999997F, -3.0F, 99.0F, nan, 3.0F}) {
    gl.VertexAttrib4f(static_cast<GLuint>(attribute), value, 4, 5, 6);
    const int tag = reference::depth_tag(value, pool);
    expect_depths(t, {uniform(tag)}, draw_one, "current value " + as_text(value));
    GLint queried = -1;
    gl.GetIntegerv(GL_CURRENT_DEPTH_TAG_ARK, &queried);
    t.expect_equal(queried, tag, "CURRENT_DEPTH_TAG_ARK for " + as_text(value));
  }
}

void check_sets_attribute(Test& t) {
  gl.ARKinit(pool);
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  gl.VertexAttrib4f(static_cast<GLuint>(attribute), 7, 7, 7, 7);
  gl.DepthTag1i(5);
  GLfloat value[4] = {};
  gl.GetVertexAttribfv(static_cast<GLuint>(attribute), GL_CURRENT_VERTEX_ATTRIB, value);
  const GLfloat expected[4] = {5, 0, 0, 1};
  for (int i = 0; i < 4; ++i) t.expect_equal(value[i], expected[i], fmt::format("component {}", i));
}

// A program that reads the attribute gets the given value, refined, and not the rounded tag.
void check_read(Test& t) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(one_triangle({2.25F, 9.5F, -1.5F}));
  refine_by_tags(3);
  expect_refined(t, {}, draw_one, "tags that the program reads");
  float least = 0;
  float greatest = 0;
  for (const DrawVertex& vertex : capture_as<DrawVertex>(t, 1000, draw_one)) {
    least = std::min(least, vertex.tag);
    greatest = std::max(greatest, vertex.tag);
  }
  t.expect_equal(least, -1.5F, "the least value of the input");
  t.expect_equal(greatest, 9.5F, "the greatest value of the input");
}

// Instance k takes element base + k / divisor. All three corners have the same tag.
void check_divisor(Test& t, GLuint divisor, GLuint base) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(one_triangle(), false);
  refine_by_tags(3);
  bind_tags({1, 3, 0, 2, 1, 3, 0});
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  gl.VertexAttribDivisor(at_tag, divisor);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_refined(
      t, {},
      [base] {
        if (base == 0)
          gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 5);
        else
          gl.DrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, 3, 5, base);
      },
      "five instances");
}

// The same draw with a program that does not read the attribute: an implementation may treat it differently.
void check_divisor_unread(Test& t, GLuint divisor, GLuint base) {
  const std::vector<float> tags = {1, 3, 0, 2, 4, 3, 0};
  set_up_one(t);
  bind_tags(tags);
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  gl.VertexAttribDivisor(static_cast<GLuint>(attribute), divisor);
  std::int64_t expected = 0;
  for (GLuint instance = 0; instance < 5; ++instance) {
    const int tag = static_cast<int>(tags[base + instance / divisor]);
    expected += std::int64_t{1} << (2 * tag);
  }
  const auto vertices = capture(t, [base] {
    if (base == 0)
      gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 5);
    else
      gl.DrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, 3, 5, base);
  });
  t.expect_equal(static_cast<std::int64_t>(vertices.size() / 3), expected, "triangles of five instances");
}

void check_base_vertex(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(repeated(3), false);
  refine_by_tags(pool);
  bind_tags({9, 9, 9, 0, 1, 4, 5, 2, 1});
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  GLuint indices = 0;
  const GLushort order[] = {0, 1, 2, 3, 4, 5};
  gl.GenBuffers(1, &indices);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(order), order, GL_STATIC_DRAW);
  const auto patterns =
      patterns_of(t, capture(t, [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr, 3); }), 3);
  t.expect(patterns[0].empty(), "the first triangle is not drawn");
  t.expect(reference::depths_found(patterns[1]) == reference::edge_depths({0, 1, 4}), "tags from the base vertex on");
  t.expect(reference::depths_found(patterns[2]) == reference::edge_depths({5, 2, 1}), "tags of the last triangle");
}

// One array object has tags, another has none: they are state of the array object.
void check_array_object(Test& t) {
  gl.UseProgram(capture_program(t));
  refine_by_tags(pool);
  const MeshBuffers with = upload(one_triangle({4, 2, 0}));
  const MeshBuffers without = upload(one_triangle({4, 2, 0}), false);
  gl.DepthTag1i(1);
  expect_depths(t, {uniform(1)}, draw_one, "an array object without tags");
  gl.BindVertexArray(with.array);
  expect_depths(t, {Depths{3, 1, 2}}, draw_one, "an array object with tags");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, {uniform(1)}, draw_one, "its tags disabled");
  gl.BindVertexArray(without.array);
  gl.BindVertexArray(with.array);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, {Depths{3, 1, 2}}, draw_one, "its tags enabled again");
}

// The old attribute keeps array and value; the new one has its own.
void check_moved(Test& t) {
  set_up_one(t);
  GLint old = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &old);
  const GLuint moved = static_cast<GLuint>(old) - 4;
  bind_tags({4, 2, 0, 1, 5, 3});
  gl.DepthTag1i(2);
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, {Depths{3, 1, 2}}, draw_one, "before");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, static_cast<GLint>(moved));
  expect_depths(t, {uniform(0)}, draw_one, "moved to an attribute that was never set");
  gl.DepthTag1i(1);
  expect_depths(t, {uniform(1)}, draw_one, "current value of the other attribute");
  gl.DepthTagPointerARK(GL_FLOAT, 0, reinterpret_cast<const void*>(3 * sizeof(float)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, {Depths{3, 4, 2}}, draw_one, "array of the other attribute");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, old);
  expect_depths(t, {Depths{3, 1, 2}}, draw_one, "moved back");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, {uniform(2)}, draw_one, "moved back, array disabled");
}

// Immediate mode: a tag applies to the vertices after it.
void check_immediate(Test& t) {
  gl.UseProgram(capture_program(t));
  refine_by_tags(pool);
  const auto vertex = [](std::size_t i) {
    const MeshVertex at = one_triangle()[i % 3];
    gl.VertexAttrib3f(at_weights, at.weights[0], at.weights[1], at.weights[2]);
    const auto triangle = i / 3;
    gl.VertexAttrib1f(at_extra, static_cast<float>(triangle));
    gl.Vertex4f(at.position[0], at.position[1], at.position[2], at.position[3]);
  };
  gl.DepthTag1i(5);
  const std::vector<Depths> expected = {reference::edge_depths({5, 5, 2}), reference::edge_depths({2, 0, 6})};
  expect_depths(
      t, expected,
      [&] {
        gl.Begin(GL_TRIANGLES);
        vertex(0);
        vertex(1);
        gl.DepthTag1i(2);
        vertex(2);
        vertex(3);
        gl.DepthTag1i(4);
        gl.DepthTag1i(0);
        vertex(4);
        gl.DepthTag1i(6);
        vertex(5);
        gl.End();
      },
      "tags between Begin and End");
  GLint current = -1;
  gl.GetIntegerv(GL_CURRENT_DEPTH_TAG_ARK, &current);
  t.expect_equal(current, 6, "the last tag stays the current one");
}

Cases instance_cases() {
  Cases cases;
  for (const GLuint divisor : {1U, 2U})
    for (const GLuint base : {0U, 2U})
      for (const bool is_read : {true, false})
        cases.push_back({.name = fmt::format("ark.tags.instance.divisor_{}{}{}", divisor,
                                             (base == 0 ? ".base_0" : ".base_2"), (is_read ? ".read" : ".unread")),
                         .clauses = {"10.R.1-28"},
                         .plan = "Five instances take their tags from an array with a divisor.",
                         .wrong = "The divisor or the base instance is ignored: other depths, and another number of "
                                  "triangles.",
                         .apis = base == 0 ? every_api : desktop_apis,
                         .check = [divisor, base, is_read](Test& t) {
                           if (is_read)
                             check_divisor(t, divisor, base);
                           else
                             check_divisor_unread(t, divisor, base);
                         }});
  return cases;
}

}  // namespace

Cases tags_in_draws_cases() {
  Cases cases = instance_cases();
  cases.push_back({.name = "ark.tags.current.command",
                   .clauses = {"10.R.1-11", "10.R.1-14"},
                   .plan = "Draw without a tag array, after several DepthTag1i.",
                   .wrong = "The tag of the draw before; 0.",
                   .check = check_current});
  cases.push_back({.name = "ark.tags.current.attribute",
                   .clauses = {"10.R.1-2", "10.R.1-3", "10.R.1-16"},
                   .plan = "Set the attribute's current value by VertexAttrib4f to values that need rounding and "
                           "clamping; draw and query.",
                   .wrong = "Only DepthTag1i counts; another component; unrounded values.",
                   .check = check_current_attribute});
  cases.push_back({.name = "ark.tags.current.components",
                   .clauses = {"10.R.1-12"},
                   .plan = "Query the current value of the attribute after DepthTag1i.",
                   .wrong = "Components that are left alone; the value is kept elsewhere.",
                   .check = check_sets_attribute});
  cases.push_back({.name = "ark.tags.read",
                   .clauses = {"10.R.1-8"},
                   .plan = "A program reads the tag as an input and writes it to transform feedback.",
                   .wrong = "Rounded or clamped values; 0, because the attribute is missing.",
                   .check = check_read});
  cases.push_back({.name = "ark.tags.base_vertex",
                   .clauses = {"10.R.1-28"},
                   .plan = "Draw two of three triangles from base vertex 3.",
                   .wrong = "The tags of the first vertices.",
                   .check = check_base_vertex});
  cases.push_back({.name = "ark.tags.array_object",
                   .clauses = {"10.R.1-26", "10.R.1-28"},
                   .plan = "Switch between a vertex array object with tags and one without.",
                   .wrong = "The array is state of the context.",
                   .check = check_array_object});
  cases.push_back({.name = "ark.tags.moved",
                   .clauses = {"10.R.1-29"},
                   .plan = "Move DEPTH_TAG_ATTRIBUTE_ARK and back; both attributes keep their values and arrays.",
                   .wrong = "The array moves with the name; the value is copied or reset.",
                   .check = check_moved});
  cases.push_back({.name = "ark.tags.immediate",
                   .clauses = {"10.R.1-13", "10.R.2-2"},
                   .plan = "Set tags between Begin and End, some twice, some for several vertices.",
                   .wrong = "One tag for the primitive; the tag of the vertex before.",
                   .apis = compat_only,
                   .check = check_immediate});
  return cases;
}

}  // namespace glark::conformance
