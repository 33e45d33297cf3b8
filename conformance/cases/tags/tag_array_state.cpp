// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The depth tag array as state of vertex array objects, and other state of an attribute's array (10.R.1).
#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using Draw = std::function<void()>;

std::size_t triangles_of(Test& t, const Draw& draw) {
  const std::size_t triangles = capture(t, draw).size() / 3;
  t.expect_equal(std::size_t{count_generated(draw)}, triangles, "triangles without transform feedback");
  return triangles;
}

void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// The triangle three times, with vertex tags 1, 2 and 3.
Mesh three_triangles() {
  Mesh mesh;
  for (int tag = 1; tag <= 3; ++tag)
    for (const MeshVertex& vertex : one_triangle({float(tag), float(tag), float(tag)})) mesh.push_back(vertex);
  number_triangles(mesh);
  return mesh;
}

void refine() {
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
}

// The tags 1, 2, 3 and 4, one for each instance, in a separate buffer.
void tags_of_instances() {
  const GLubyte tags[] = {1, 2, 3, 4};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.VertexAttribDivisor(static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK)), 1);
}

void draw_indices(Test& t) {
  const GLushort indices[] = {0, 1, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  t.expect_no_error("setting up");
}

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(three_triangles(), false);
  draw_indices(t);
  t.expect_equal(triangles_of(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 9); }), 3U, "triangles");
  t.expect_equal(triangles_of(t, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 3); }), 3U, "triangles of instances");
  t.expect_equal(triangles_of(t, [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr, 3); }), 1U,
                 "triangles with a base vertex");
}

void check_objects(Test& t) {
  gl.UseProgram(capture_program(t));
  const GLuint first = upload(one_triangle({1, 1, 1})).array;
  const GLuint second = upload(one_triangle({3, 3, 3})).array;
  const GLuint third = upload(one_triangle({2, 2, 2}), false).array;
  refine();
  gl.DepthTag1i(4);
  for (int round = 0; round < 2; ++round)
    for (const auto& [array, triangles] : {std::pair{third, 256U}, {first, 4U}, {second, 64U}}) {
      gl.BindVertexArray(array);
      t.expect_equal(triangles_of(t, draw_one), std::size_t{triangles}, "triangles");
    }
  gl.BindVertexArray(second);
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.BindVertexArray(first);
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_TRUE}, "the first object's array is still enabled");
  gl.DeleteVertexArrays(1, &first);
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "no object is bound any more");
}

void check_states(Test& t) {
  const EverythingSet objects = set_everything(t);
  const Snapshot before = take_snapshot(t);
  GLuint other = 0;
  gl.GenVertexArrays(1, &other);
  gl.BindVertexArray(other);
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "enabled in a new object");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_TYPE_ARK), GLint{GL_FLOAT}, "type in a new object");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), 0, "stride in a new object");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK), 0, "buffer in a new object");
  t.expect(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK) == nullptr, "pointer in a new object");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the current tag is not part of the object");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK), 7, "nor is the attribute");
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, 3, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.BindVertexArray(objects.array);
  expect_unchanged(t, take_snapshot(t), before, "in the first object again");
}

void check_buffer_deleted(Test& t) {
  const EverythingSet objects = set_everything(t);
  gl.DeleteBuffers(1, &objects.buffer);
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK), 0, "the binding after the buffer was deleted");
  t.expect_equal(array_state(7, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING), 0, "that of the attribute");
}

void check_divisor(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  tags_of_instances();
  refine();
  t.expect_equal(triangles_of(t, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 3); }), 4U + 16U + 64U,
                 "triangles of three instances");
  gl.VertexAttribDivisor(static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK)), 2);
  t.expect_equal(triangles_of(t, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 3); }), 4U + 4U + 16U,
                 "triangles of three instances, a tag for two of them");
  t.expect_equal(triangles_of(t, draw_one), 4U, "triangles of a draw without instances");
}

void check_base_instance(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  draw_indices(t);
  tags_of_instances();
  refine();
  t.expect_equal(triangles_of(t, [] { gl.DrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, 3, 2, 1); }), 16U + 64U,
                 "triangles of instances 1 and 2");
  t.expect_equal(
      triangles_of(t, [] { gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr, 2, 2); }),
      64U + 256U, "triangles of instances 2 and 3, indexed");
}

void check_base_vertex(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(three_triangles());
  draw_indices(t);
  refine();
  for (int i = 0; i < 3; ++i)
    t.expect_equal(
        triangles_of(t, [&] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr, 3 * i); }),
        std::size_t{4} << (2 * i), "triangles with base vertex " + as_text(3 * i));
  t.expect_equal(triangles_of(t, [] { gl.DrawArrays(GL_TRIANGLES, 3, 3); }), 16U, "triangles from vertex 3 on");
}

void check_attribute_formats(Test& t) {
  gl.UseProgram(capture_program(t));
  const MeshBuffers mesh = upload(three_triangles(), false);
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  refine();
  gl.VertexAttribFormat(attribute, 1, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, tag));
  gl.VertexAttribBinding(attribute, 9);
  gl.BindVertexBuffer(9, mesh.buffer, 3 * sizeof(MeshVertex), sizeof(MeshVertex));
  gl.EnableVertexAttribArray(attribute);
  t.expect_equal(triangles_of(t, draw_one), 16U, "triangles with tags of a separate binding, from vertex 3 on");
  t.expect_equal(GLuint(integer_of(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK)), mesh.buffer, "the buffer");
  gl.VertexAttribPointer(attribute, 2, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offsetof(MeshVertex, tag) + 6 * sizeof(MeshVertex)));
  t.expect_equal(triangles_of(t, draw_one), 64U, "triangles with tags of VertexAttribPointer, from vertex 6 on");
  t.expect_no_error("the draws");
}

}  // namespace

Cases tag_array_state_cases() {
  return {
      {.name = "ark.tag_array.object.draw",
       .clauses = {"10.R.1-28"},
       .plan = "Three vertex array objects: with tags 1, with tags 3, and without an array. Draw with each twice, and "
               "count.",
       .wrong = "The array of the last DepthTagPointerARK, whichever object is bound.",
       .control = control,
       .check = check_objects},
      {.name = "ark.tag_array.object.state",
       .clauses = {"10.R.1-28", "state-23", "state-24", "state-25", "state-26", "state-27", "state-22"},
       .plan =
           "A new vertex array object has the initial values, and setting its array does not change the first object.",
       .wrong = "The array is state of the context.",
       .check = check_states},
      {.name = "ark.tag_array.object.buffer_deleted",
       .clauses = {"10.R.1-28", "chapter-22-5"},
       .plan = "Delete the buffer of the array while the object is bound: the binding is 0.",
       .wrong = "A separate copy of the name is kept.",
       .check = check_buffer_deleted},
      {.name = "ark.tag_array.divisor",
       .clauses = {"10.R.1-28"},
       .plan = "Tags 1, 2 and 3 for three instances, then with the divisor 2; count.",
       .wrong = "The tag of instance 0 for all instances; the vertices take tags 1, 2 and 3.",
       .control = control,
       .check = check_divisor},
      {.name = "ark.tag_array.base_instance",
       .clauses = {"10.R.1-28"},
       .plan = "Tags for each instance, and draws that begin at instance 1 and 2.",
       .wrong = "The base instance is ignored.",
       .apis = desktop_apis,
       .control = control,
       .check = check_base_instance},
      {.name = "ark.tag_array.base_vertex",
       .clauses = {"10.R.1-28"},
       .plan = "Vertices with tags 1, 2 and 3; the same indices with base vertices 0, 3 and 6.",
       .wrong = "The base vertex is ignored for tags, or added twice.",
       .control = control,
       .check = check_base_vertex},
      {.name = "ark.tag_array.formats",
       .clauses = {"10.R.1-2", "10.R.1-28"},
       .plan =
           "Specify the attribute's array by VertexAttribFormat and BindVertexBuffer, then by VertexAttribPointer with "
           "two components.",
       .wrong = "Only DepthTagPointerARK is known; the binding's offset is ignored.",
       .control = control,
       .check = check_attribute_formats},
  };
}

}  // namespace glark::conformance
