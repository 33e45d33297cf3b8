// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sources of the depth tag of a vertex, and how tags are rounded (10.R.1): arrays of every type, stride and offset,
// buffers and client memory, values per instance, current values.
#include <fmt/core.h>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

using reference::Depths;

constexpr int pool = 6;

// Triangles whose corners all have tags that these arrays give; `tags_at` gives the tag of a vertex.
Mesh numbered_mesh(std::size_t triangles) {
  Mesh mesh(3 * triangles);
  const Mesh one = one_triangle();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i] = one[i % 3];
  number_triangles(mesh);
  return mesh;
}

void expect_depths(Test& t, const std::vector<float>& values, const std::function<void()>& draw,
                   const std::string& what) {
  const auto found = depths_of(t, values.size() / 3, draw);
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::array<int, 3> tags{};
    for (std::size_t k = 0; k < 3; ++k) tags[k] = reference::depth_tag(values[3 * i + k], pool);
    const Depths expected = reference::edge_depths(tags);
    t.expect(found[i] == expected, fmt::format("{}: triangle {} with the values {}, {}, {} has the depths {}, not {}",
                                               what, i, as_text(values[3 * i]), as_text(values[3 * i + 1]),
                                               as_text(values[3 * i + 2]), text_of(found[i]), text_of(expected)));
  }
}

std::function<void()> arrays(std::size_t vertices) {
  return [vertices] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices)); };
}

void set_up(Test& t, std::size_t triangles) {
  gl.UseProgram(capture_program(t));
  upload(numbered_mesh(triangles), false);
  refine_by_tags(pool);
}

GLuint bind_bytes(const std::vector<unsigned char>& bytes) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

template <typename Value>
void put(std::vector<unsigned char>& bytes, std::size_t offset, Value value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

struct Type {
  const char* name;
  GLenum type;
  std::size_t size;
};
constexpr Type types[] = {{"unsigned_byte", GL_UNSIGNED_BYTE, 1},
                          {"unsigned_short", GL_UNSIGNED_SHORT, 2},
                          {"unsigned_int", GL_UNSIGNED_INT, 4},
                          {"float", GL_FLOAT, 4}};

// Writes `values` from `offset` on with this stride (0: tightly packed). The bytes in between and before would give
// other tags.
std::vector<unsigned char> packed(const Type& type, const std::vector<float>& values, std::size_t stride,
                                  std::size_t offset) {
  const std::size_t step = stride == 0 ? type.size : stride;
  std::vector<unsigned char> bytes(offset + step * values.size() + type.size, type.type == GL_FLOAT ? 0x40 : 5);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = offset + i * step;
    if (type.type == GL_UNSIGNED_BYTE) put(bytes, at, static_cast<GLubyte>(values[i]));
    if (type.type == GL_UNSIGNED_SHORT) put(bytes, at, static_cast<GLushort>(values[i]));
    if (type.type == GL_UNSIGNED_INT) put(bytes, at, static_cast<GLuint>(values[i]));
    if (type.type == GL_FLOAT) put(bytes, at, values[i]);
  }
  return bytes;
}

const std::vector<float>& whole_tags() {
  static const std::vector<float> tags = {0, 1, 4, 5, 2, 0, 3, 3, 6, 1, 0, 0, 4, 6, 2};
  return tags;
}

GLuint tag_attribute() {
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  return static_cast<GLuint>(attribute);
}

void check_array(Test& t, const Type& type, std::size_t stride, std::size_t offset) {
  const auto& values = whole_tags();
  set_up(t, values.size() / 3);
  bind_bytes(packed(type, values, stride, offset));
  gl.DepthTagPointerARK(type.type, static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);  // the array keeps its buffer
  expect_depths(t, std::vector<float>(values.size(), 0.0F), arrays(values.size()), "array not enabled");
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, values, arrays(values.size()), "array enabled");
}

Case array_case(const Type& type, const char* leaf, std::size_t stride, std::size_t offset) {
  return {.name = std::string("ark.tags.array.") + type.name + "." + leaf,
          .clauses = {"10.R.1-18", "10.R.1-19", "10.R.1-20", "10.R.1-22", "10.R.1-26"},
          .plan = "Give fifteen tags by an array of this type, stride and offset and find the depths of all edges.",
          .wrong =
              "Normalized values give depth 0; a stride of 0 repeats the first value; the offset or the stride is "
              "ignored, which gives the tags of other vertices.",
          .check = [&type, stride, offset](Test& t) { check_array(t, type, stride, offset); }};
}

Cases array_cases() {
  Cases cases;
  for (const Type& type : types) {
    cases.push_back(array_case(type, "stride_zero", 0, 0));
    cases.push_back(array_case(type, "stride_of_type", type.size, type.size));
    cases.push_back(array_case(type, "stride_wide", 12, 0));
    cases.push_back(array_case(type, "stride_and_offset", 5 * type.size, 3 * type.size));
  }
  return cases;
}

// Large values of unsigned types are clamped. They do not wrap, and are not taken for negative ones.
void check_large(Test& t, const Type& type, const std::vector<double>& numbers) {
  set_up(t, numbers.size() / 3);
  std::vector<unsigned char> bytes(numbers.size() * type.size);
  std::vector<float> values;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    values.push_back(static_cast<float>(numbers[i]));
    if (type.type == GL_UNSIGNED_BYTE) put(bytes, i, static_cast<GLubyte>(numbers[i]));
    if (type.type == GL_UNSIGNED_SHORT) put(bytes, 2 * i, static_cast<GLushort>(numbers[i]));
    if (type.type == GL_UNSIGNED_INT) put(bytes, 4 * i, static_cast<GLuint>(numbers[i]));
  }
  bind_bytes(bytes);
  gl.DepthTagPointerARK(type.type, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, values, arrays(values.size()), "large values");
}

void check_floats(Test& t, const std::vector<float>& values) {
  set_up(t, values.size() / 3);
  bind_bytes(packed(types[3], values, 0, 0));
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, values, arrays(values.size()), "floating-point tags");
}

// Pairs each value with itself and with a tag of 1: floor((a + 1) / 2) tells odd from even.
std::vector<float> beside_one(const std::vector<float>& values) {
  std::vector<float> all;
  for (const float value : values) all.insert(all.end(), {value, value, 1.0F});
  return all;
}

Case float_case(const char* leaf, std::vector<std::string> clauses, const std::string& plan, const std::string& wrong,
                const std::vector<float>& values) {
  return {.name = std::string("ark.tags.rounding.") + leaf,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong = wrong,
          .check = [values = beside_one(values)](Test& t) { check_floats(t, values); }};
}

Cases rounding_cases() {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto below = [](float value) { return std::nextafter(value, -10.0F); };
  const auto above = [](float value) { return std::nextafter(value, 10.0F); };
  return {
      float_case("nearest", {"10.R.1-1", "10.R.1-3"}, "Tags with fractions other than a half, from 0.1 to 5.9.",
                 "Truncated, or rounded up.", {0.1F, 0.4F, 0.6F, 1.3F, 1.9F, 2.75F, 3.25F, 3.51F, 4.49F, 5.9F}),
      float_case("halves", {"10.R.1-4"}, "Tags of 0.5, 1.5, to 5.5.",
                 "Rounded down; or to even, so that 2.5 becomes 2.", {0.5F, 1.5F, 2.5F, 3.5F, 4.5F, 5.5F}),
      float_case("beside_halves", {"10.R.1-3", "10.R.1-4"}, "The floating-point numbers next to each half.",
                 "floor(x + 0.5) in single precision rounds the number below 0.5 up to 1.",
                 {below(0.5F), above(0.5F), below(1.5F), above(1.5F), below(2.5F), above(2.5F), below(4.5F)}),
      float_case("negative", {"10.R.1-3"}, "Negative tags, close to 0 and far from it.",
                 "The absolute value; wrapped to a large unsigned number.",
                 {-0.0F, -0.25F, -0.5F, -0.75F, -1, -2, -100, -3e9F, -1e38F}),
      float_case("above_pool", {"10.R.1-3"}, "Tags around and above the level of the pool.", "Not clamped; wrapped.",
                 {5.49F, 6, 6.4F, 6.6F, 7, 12, 255, 65536, 4294967296.0F, 3e38F}),
      float_case("nan", {"10.R.1-5"}, "Tags that are NaN, of both signs.", "The greatest depth; the triangle is lost.",
                 {nan, -nan, nan}),
      float_case("infinite", {"10.R.1-3"}, "Infinite tags are clamped.", "Infinity counts as NaN.", {inf, -inf, inf}),
      float_case("tiny", {"10.R.1-3"}, "Denormalized numbers.", "Rounded up.",
                 {std::numeric_limits<float>::denorm_min(), 1e-40F, -1e-40F})};
}

// Only the first component counts.
void check_components(Test& t) {
  const std::vector<float> values = {0, 3, 5, 2, 1, 6};
  for (GLint components = 1; components <= 4; ++components) {
    set_up(t, 2);
    std::vector<float> wide;
    for (const float value : values) {
      wide.push_back(value);
      for (GLint more = 1; more < components; ++more) wide.push_back(4.0F - value / 2);
    }
    bind_bytes(packed(types[3], wide, 0, 0));
    gl.VertexAttribPointer(tag_attribute(), components, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(tag_attribute());
    expect_depths(t, values, arrays(6), fmt::format("{} components", components));
  }
}

// VertexAttribPointer takes types that DepthTagPointerARK does not, and normalized ones.
void check_other_types(Test& t) {
  const std::vector<GLshort> shorts = {-3, 2, 5, 1, 300, 4};
  set_up(t, 2);
  std::vector<unsigned char> bytes(shorts.size() * 2);
  std::memcpy(bytes.data(), shorts.data(), bytes.size());
  bind_bytes(bytes);
  gl.VertexAttribPointer(tag_attribute(), 1, GL_SHORT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(tag_attribute());
  expect_depths(t, {-3, 2, 5, 1, 300, 4}, arrays(6), "signed shorts");
  bind_bytes({255, 100, 255, 150, 255, 255});
  gl.VertexAttribPointer(tag_attribute(), 1, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  expect_depths(t, {1, 100 / 255.0F, 1, 150 / 255.0F, 1, 1}, arrays(6), "normalized bytes");
}

// VertexAttribFormat and buffer bindings, with an offset in each.
void check_format(Test& t) {
  const std::vector<float> values = {1, 3, 6, 0, 5, 2};
  set_up(t, 2);
  const GLuint buffer = bind_bytes(packed(types[1], values, 6, 10));
  gl.VertexAttribFormat(tag_attribute(), 1, GL_UNSIGNED_SHORT, GL_FALSE, 2);
  gl.VertexAttribBinding(tag_attribute(), 13);
  gl.BindVertexBuffer(13, buffer, 8, 6);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_depths(t, values, arrays(6), "separate format");
}

void check_client_memory(Test& t) {
  const auto& values = whole_tags();
  for (const Type& type : types) {
    set_up(t, values.size() / 3);
    gl.BindVertexArray(0);  // if other attributes come from client memory too
    const Mesh mesh = numbered_mesh(values.size() / 3);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), mesh[0].position.data());
    gl.VertexAttribPointer(at_weights, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), mesh[0].weights.data());
    gl.VertexAttribPointer(at_extra, 1, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), &mesh[0].triangle);
    for (const GLuint location : {GLuint{at_position}, GLuint{at_weights}, GLuint{at_extra}})
      gl.EnableVertexAttribArray(location);
    const auto bytes = packed(type, values, 3 * type.size, 0);
    gl.DepthTagPointerARK(type.type, static_cast<GLsizei>(3 * type.size), bytes.data());
    gl.EnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
    expect_depths(t, values, arrays(values.size()), std::string("client memory, ") + type.name);
    gl.DisableClientState(GL_DEPTH_TAG_ARRAY_ARK);
    expect_depths(t, std::vector<float>(values.size(), 0.0F), arrays(values.size()), "client state disabled");
  }
}

// The program reads the tags as a vec4. Its other components would give other depths.
void check_wide_tags(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 5) in vec4 tag; out vec4 colour;\n"
                    "void main() { colour = tag; gl_Position = position; }\n"});
  gl.UseProgram(program);
  upload(one_triangle(), false);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, at_tag);
  const GLfloat tags[] = {1, 3, 0, 4, 2, 0, 4, 1, 3, 4, 1, 0};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_tag, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(at_tag);
  refine_by_tags(4);
  const std::int64_t expected = reference::minimum_triangles(reference::edge_depths({1, 2, 3}));
  t.expect_equal(std::int64_t{count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })}, expected,
                 "triangles of tags in vectors");
}

}  // namespace

Cases tag_array_formats_cases() {
  Cases cases = array_cases();
  for (Case& each : rounding_cases()) cases.push_back(std::move(each));
  const std::vector<std::pair<const Type*, std::vector<double>>> large = {
      {&types[0], {0, 7, 255, 128, 200, 1}},
      {&types[1], {256, 65535, 32768, 7, 1, 0}},
      {&types[2], {65536, 2147483648.0, 4294967295.0, 1, 16777217, 0}}};
  for (const auto& each : large)
    cases.push_back({.name = std::string("ark.tags.array.") + each.first->name + ".large",
                     .clauses = {"10.R.1-3", "10.R.1-22"},
                     .plan = "Large values of an unsigned type are clamped to the level of the pool.",
                     .wrong = "Large values count as negative numbers; only the lowest byte counts.",
                     .check = [each](Test& t) { check_large(t, *each.first, each.second); }});
  cases.push_back({.name = "ark.tags.array.components",
                   .clauses = {"10.R.1-2", "10.R.1-3"},
                   .plan = "VertexAttribPointer gives the attribute one to four components. The first is the tag.",
                   .wrong = "Another component; a stride of one component.",
                   .check = check_components});
  cases.push_back(
      {.name = "ark.tags.readable.vector",
       .clauses = {"10.R.1-3", "10.R.1-8"},
       .plan = "The program reads the tags' attribute as a vec4 with something else in the other components.",
       .wrong = "Another component gives the tag.",
       .check = check_wide_tags});
  cases.push_back({.name = "ark.tags.array.other_types",
                   .clauses = {"10.R.1-2", "10.R.1-3"},
                   .plan = "VertexAttribPointer gives signed shorts and normalized bytes.",
                   .wrong = "Normalized bytes are not normalized; signed values count as unsigned ones.",
                   .check = check_other_types});
  cases.push_back({.name = "ark.tags.array.format",
                   .clauses = {"10.R.1-2", "10.R.1-26"},
                   .plan = "Describe the array by VertexAttribFormat, VertexAttribBinding and BindVertexBuffer.",
                   .wrong = "One of the two offsets, or the binding, is ignored.",
                   .check = check_format});
  cases.push_back({.name = "ark.tags.array.client_memory",
                   .clauses = {"10.R.1-20", "10.R.1-27"},
                   .plan = "Take tags of each type from client memory, enabled by EnableClientState.",
                   .wrong = "The pointer counts as an offset; EnableClientState generates an error.",
                   .apis = compat_only,
                   .check = check_client_memory});
  return cases;
}

}  // namespace glark::conformance
