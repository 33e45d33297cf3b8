// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The depth tag array: DepthTagPointerARK and what enables it (10.R.1).
#include <algorithm>
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct TagType {
  const char* leaf;
  GLenum type;
  std::size_t size;
};

constexpr TagType tag_types[] = {
    {"unsigned_byte", GL_UNSIGNED_BYTE, 1},
    {"unsigned_short", GL_UNSIGNED_SHORT, 2},
    {"unsigned_int", GL_UNSIGNED_INT, 4},
    {"float", GL_FLOAT, 4},
};

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

std::size_t triangles_drawn(Test& t) {
  return capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size() / 3;
}

void draws_one_triangle(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  t.expect_equal(triangles_drawn(t), 1U, "triangles of the coarse draw");
}

// The tags 4, 1 and 2 at `begin` + i * `stride`. Any other bytes would give another number of triangles.
std::vector<unsigned char> tags_at(const TagType& type, std::size_t begin, std::size_t stride) {
  std::vector<unsigned char> bytes(begin + 3 * stride + 8, 3);
  const GLuint tags[] = {4, 1, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = static_cast<float>(tags[i]);
    unsigned char* const place = &bytes[begin + i * stride];
    if (type.type == GL_FLOAT)
      std::memcpy(place, &number, type.size);
    else
      std::memcpy(place, &tags[i], type.size);  // little-endian, as every machine that the suite runs on
  }
  return bytes;
}

constexpr std::size_t triangles_of_tags = 12;  // edge depths 2, 1 and 3: 11.R.5 with m = 1

void check_draw(Test& t, const TagType& type) {
  draws_one_triangle(t);
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  for (const auto& [begin, stride] : {std::pair{0U, 0U}, {8U, 0U}, {4U, 12U}, {8U, 4U}, {0U, 32U}}) {
    const std::size_t step = stride == 0 ? type.size : stride;
    const auto bytes = tags_at(type, begin, step);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    gl.DepthTagPointerARK(type.type, static_cast<GLsizei>(stride), offset(begin));
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
    t.expect_equal(triangles_drawn(t), triangles_of_tags,
                   "triangles with offset " + as_text(begin) + " and stride " + as_text(stride));
  }
}

void check_client_memory(Test& t, const TagType& type) {
  gl.UseProgram(capture_program(t));
  const auto bytes = tags_at(type, 4, 12);
  const Mesh mesh = one_triangle();
  gl.BindVertexArray(0);
  gl.EnableVertexAttribArray(at_position);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), mesh.front().position.data());
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  gl.DepthTagPointerARK(type.type, 12, &bytes[4]);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_no_error("client memory and no vertex array object");
  t.expect_equal(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK), static_cast<const void*>(&bytes[4]), "the pointer");
  t.expect_equal(triangles_drawn(t), triangles_of_tags, "triangles");
}

// Before the call, all state that VertexAttribPointer sets has other values.
void spoil(GLuint attribute) {
  gl.VertexAttribIPointer(attribute, 3, GL_SHORT, 40, offset(16));
  gl.VertexAttribBinding(attribute, 2);
  gl.VertexAttribDivisor(attribute, 5);
  gl.VertexAttribBinding(attribute, 3);
}

void check_equivalent(Test& t, const TagType& type) {
  const EverythingSet objects = set_everything(t);
  for (const auto& [stride, pointer] : {std::pair{0, 0U}, {16, 4U}, {4, 1024U}, {2048, 8U}}) {
    spoil(7);
    spoil(8);
    gl.BindBuffer(GL_ARRAY_BUFFER, objects.buffer);
    gl.DepthTagPointerARK(type.type, stride, offset(pointer));
    gl.VertexAttribPointer(8, 1, type.type, GL_FALSE, stride, offset(pointer));
    t.expect_no_error("both commands");
    for (const GLenum name :
         {GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_STRIDE,
          GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_INTEGER, GL_VERTEX_ATTRIB_ARRAY_DIVISOR,
          GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_RELATIVE_OFFSET})
      t.expect_equal(array_state(7, static_cast<GLenum>(name)), array_state(8, static_cast<GLenum>(name)),
                     "state " + as_text(name) + " of the array");
    t.expect_equal(array_state(7, GL_VERTEX_ATTRIB_BINDING), 7, "the array's binding");
    t.expect_equal(array_state(7, GL_VERTEX_ATTRIB_ARRAY_SIZE), 1, "one component");
    t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_TYPE_ARK), static_cast<GLint>(type.type), "the type");
    t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), stride, "the stride");
    t.expect_equal(GLuint(integer_of(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK)), objects.buffer, "the buffer");
    t.expect_equal(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK), offset(pointer), "the pointer");
    t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_TRUE}, "the array stays enabled");
  }
}

void check_other_types(Test& t) {
  set_everything(t);
  for (const int type : {GL_BYTE, GL_SHORT, GL_INT, GL_DOUBLE, GL_HALF_FLOAT, GL_FIXED, GL_INT_2_10_10_10_REV,
                         GL_UNSIGNED_INT_2_10_10_10_REV, 0, GL_DEPTH_TAG_ARK, 1})
    expect_refused(t, GL_INVALID_ENUM, "type " + as_text(type),
                   [&] { gl.DepthTagPointerARK(static_cast<GLenum>(type), 0, nullptr); });
}

void check_strides(Test& t) {
  set_everything(t);
  for (const GLsizei stride : {-1, -4, -2147483647 - 1})
    expect_refused(t, GL_INVALID_VALUE, "stride " + as_text(stride),
                   [&] { gl.DepthTagPointerARK(GL_FLOAT, stride, nullptr); });
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_VERTEX_ATTRIB_STRIDE, &limit);
  if (gl.GetError() != GL_NO_ERROR || limit <= 0) return;  // a context without the limit
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, limit, nullptr);
  t.expect_no_error("the greatest stride");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), limit, "the stride");
  expect_refused(t, GL_INVALID_VALUE, "a stride above MAX_VERTEX_ATTRIB_STRIDE",
                 [&] { gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, limit + 1, nullptr); });
}

// Both commands generate the same error.
void expect_alike(Test& t, const std::string& what, const std::function<void()>& general,
                  const std::function<void()>& ours) {
  general();
  const GLenum error = gl.GetError();
  t.log(what + ": " + error_name(error) + " from the general command");
  if (error == GL_NO_ERROR) {
    ours();
    t.expect_no_error(what);
  } else {
    expect_refused(t, error, what, ours);
  }
}

void check_client_memory_errors(Test& t) {
  static const float memory[4] = {};
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  for (const GLuint bound : {array, 0U}) {
    gl.BindVertexArray(bound);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    for (const void* pointer : {static_cast<const void*>(memory), static_cast<const void*>(nullptr)})
      expect_alike(
          t, std::string(bound != 0 ? "a" : "no") + " vertex array object, pointer " + as_text(pointer),
          [&] { gl.VertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, 0, pointer); },
          [&] { gl.DepthTagPointerARK(GL_FLOAT, 0, pointer); });
  }
  gl.BindVertexArray(array);
  expect_refused(t, GL_INVALID_OPERATION, "client memory in a vertex array object",
                 [&] { gl.DepthTagPointerARK(GL_FLOAT, 0, memory); });
}

void expect_enabled(Test& t, bool is_enabled, const std::string& what) {
  t.expect_equal(gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK) == GL_TRUE, is_enabled, what + ": IsEnabled");
  t.expect_equal(array_state(7, GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0, is_enabled, what + ": of attribute 7");
}

void check_enables(Test& t) {
  set_everything(t);
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  Snapshot disabled = take_snapshot(t);
  expect_enabled(t, false, "Disable");
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_enabled(t, true, "Enable");
  gl.DisableVertexAttribArray(7);
  expect_enabled(t, false, "DisableVertexAttribArray");
  expect_unchanged(t, take_snapshot(t), disabled, "disabled in two ways");
  gl.EnableVertexAttribArray(7);
  expect_enabled(t, true, "EnableVertexAttribArray");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_unchanged(t, take_snapshot(t), disabled, "enabled and disabled");
  gl.EnableVertexAttribArray(8);
  expect_enabled(t, false, "EnableVertexAttribArray of another attribute");
  gl.BindVertexArray(0);
  expect_alike(
      t, "Enable without a vertex array object", [] { gl.EnableVertexAttribArray(3); },
      [] { gl.Enable(GL_DEPTH_TAG_ARRAY_ARK); });
}

void check_client_state(Test& t) {
  set_everything(t);
  gl.DisableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  const Snapshot disabled = take_snapshot(t);
  expect_enabled(t, false, "DisableClientState");
  gl.EnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  expect_enabled(t, true, "EnableClientState");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_unchanged(t, take_snapshot(t), disabled, "Disable after EnableClientState");
  t.expect_no_error("client state");
  for (const int name : {GL_ARK, GL_DEPTH_TAG_ARRAY_TYPE_ARK, GL_DEPTH_TAG_ATTRIBUTE_ARK}) {
    expect_refused(t, GL_INVALID_ENUM, "EnableClientState of another token",
                   [&] { gl.EnableClientState(static_cast<GLenum>(name)); });
    expect_refused(t, GL_INVALID_ENUM, "DisableClientState of another token",
                   [&] { gl.DisableClientState(static_cast<GLenum>(name)); });
  }
}

void check_other_client_state(Test& t) {
  set_everything(t);
  for (const bool enabled : {true, false}) {
    enabled ? gl.EnableClientState(GL_DEPTH_TAG_ARRAY_ARK) : gl.DisableClientState(GL_DEPTH_TAG_ARRAY_ARK);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    t.expect(gl.IsEnabled(GL_NORMAL_ARRAY) == GL_TRUE, "the array of normals is enabled");
    expect_enabled(t, enabled, "EnableClientState of another array");
    gl.DisableClientState(GL_NORMAL_ARRAY);
    t.expect(gl.IsEnabled(GL_NORMAL_ARRAY) == GL_FALSE, "the array of normals is disabled");
    expect_enabled(t, enabled, "DisableClientState of another array");
  }
  t.expect_no_error("client state of another array");
}

}  // namespace

Cases tag_array_cases() {
  Cases cases{
      {.name = "ark.tag_array.types",
       .clauses = {"10.R.1-19", "10.R.1-23", "errors-12"},
       .plan = "Pass types that VertexAttribPointer takes, and others: INVALID_ENUM.",
       .wrong = "BYTE or HALF_FLOAT are passed on.",
       .check = check_other_types},
      {.name = "ark.tag_array.strides",
       .clauses = {"10.R.1-24", "errors-13"},
       .plan = "Pass negative strides, the greatest stride and the next one; the array stays as it was.",
       .wrong = "The limit itself is refused; a failed call changes the type.",
       .check = check_strides},
      {.name = "ark.tag_array.client_memory_errors",
       .clauses = {"10.R.1-25", "errors-14"},
       .plan = "Call VertexAttribPointer and DepthTagPointerARK with and without vertex array object, buffer and "
               "pointer: the error is the same.",
       .wrong = "Client memory is accepted in a vertex array object.",
       .check = check_client_memory_errors},
      {.name = "ark.tag_array.enable",
       .clauses = {"10.R.1-26"},
       .plan = "Enable and disable the array in both ways, ask in both ways, and compare all state.",
       .wrong = "A separate flag beside the attribute's.",
       .check = check_enables},
      {.name = "ark.tag_array.client_state",
       .clauses = {"10.R.1-27", "tokens-10"},
       .plan = "EnableClientState and DisableClientState, and ask in both ways.",
       .wrong = "INVALID_ENUM; a third flag.",
       .apis = compat_only,
       .check = check_client_state},
      {.name = "ark.tag_array.other_client_state",
       .clauses = {"10.R.1-27"},
       .plan = "EnableClientState and DisableClientState of the array of normals: they change it, and not the tags.",
       .wrong = "Every array is taken for the one of tags.",
       .apis = compat_only,
       .check = check_other_client_state},
  };
  for (const TagType& type : tag_types) {
    cases.push_back({.name = std::string("ark.tag_array.draw.") + type.leaf,
                     .clauses = {"10.R.1-18", "10.R.1-19", "10.R.1-20", "10.R.1-22"},
                     .plan = "Draw with tags at several offsets and strides in a buffer whose other bytes are other "
                             "tags, and count.",
                     .wrong = "The stride is off by one, or 0 counts as 0 bytes; normalized, all tags are 0.",
                     .control = draws_one_triangle,
                     .check = [type](Test& t) { check_draw(t, type); }});
    cases.push_back({.name = std::string("ark.tag_array.client_memory.") + type.leaf,
                     .clauses = {"10.R.1-20", "10.R.1-18"},
                     .plan = "The same with tags, and positions, in client memory.",
                     .wrong = "The pointer is an offset into the last buffer.",
                     .apis = {Api::gl_compat, Api::gles},
                     .check = [type](Test& t) { check_client_memory(t, type); }});
    cases.push_back(
        {.name = std::string("ark.tag_array.equivalent.") + type.leaf,
         .clauses = {"10.R.1-17", "10.R.1-21", "10.R.1-22", "functions-5", "tokens-7", "tokens-8", "tokens-9"},
         .plan = "Give all array state of two attributes other values, call DepthTagPointerARK for one and "
                 "VertexAttribPointer for the other, and compare.",
         .wrong =
             "Normalized; INTEGER, divisor, binding or relative offset stays as it was; the call enables the array.",
         .check = [type](Test& t) { check_equivalent(t, type); }});
  }
  return cases;
}

}  // namespace glark::conformance
