// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Indexed draws that repeat very often, with a change of their indices in between. An implementation may keep their
// refined vertices, but not after such a change.
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

constexpr GLsizei count = 6;  // of indices in a draw: two triangles
using Indices = std::array<GLubyte, count>;
constexpr Indices lower = {0, 1, 2, 3, 4, 5};
constexpr Indices upper = {9, 10, 11, 6, 7, 8};
using Bytes = std::vector<GLubyte>;

template <typename Index>
Bytes bytes_as(const Indices& indices) {
  const std::array<Index, count> values = {indices[0], indices[1], indices[2], indices[3], indices[4], indices[5]};
  Bytes bytes(sizeof(values));
  std::memcpy(bytes.data(), values.data(), sizeof(values));
  return bytes;
}

struct Type {
  const char* leaf;
  GLenum type;
  Bytes (*bytes)(const Indices& indices);
};
constexpr Type types[] = {{"bytes", GL_UNSIGNED_BYTE, bytes_as<GLubyte>},
                          {"shorts", GL_UNSIGNED_SHORT, bytes_as<GLushort>},
                          {"ints", GL_UNSIGNED_INT, bytes_as<GLuint>}};

// Four triangles, one in each quarter of the surface.
Mesh four_quarters() {
  Mesh mesh;
  for (const Vec2 place : {Vec2{-0.5F, -0.5F}, {0.5F, -0.5F}, {-0.5F, 0.5F}, {0.5F, 0.5F}})
    for (MeshVertex vertex : one_triangle()) {
      vertex.position = {0.5F * vertex.position[0] + place[0], 0.5F * vertex.position[1] + place[1], 0, 1};
      mesh.push_back(vertex);
    }
  return mesh;
}

GLuint buffer_of(GLenum target, const Bytes& bytes) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
  return buffer;
}

using Drawing = void (*)(GLenum type);
constexpr Drawing drawings[] = {[](GLenum type) { gl.DrawElements(GL_TRIANGLES, count, type, nullptr); },
                                [](GLenum type) { gl.DrawRangeElements(GL_TRIANGLES, 0, 11, count, type, nullptr); },
                                [](GLenum type) { gl.DrawElementsBaseVertex(GL_TRIANGLES, count, type, nullptr, 0); },
                                [](GLenum type) { gl.DrawElementsInstanced(GL_TRIANGLES, count, type, nullptr, 1); },
                                [](GLenum type) { gl.DrawARPElementsARK(GL_TRIANGLES, count, type, nullptr); }};

// The buffer with the indices is bound. Each change gives it the other ones.
void check_elements(Test& t, const Type& type, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  upload(four_quarters(), false);
  is_uniform ? refine_uniformly(2) : refine_by_tags(2);
  gl.DepthTag1i(1);
  const Bytes of_lower = type.bytes(lower);
  const Bytes of_upper = type.bytes(upper);
  const auto size = static_cast<GLsizeiptr>(of_lower.size());
  for (const Drawing& drawing : drawings) {
    const GLuint buffer = buffer_of(GL_ELEMENT_ARRAY_BUFFER, of_lower);
    const Draw draw = [&] { drawing(type.type); };
    expect_change(
        t, draw, [&] { gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, size, of_upper.data()); }, "BufferSubData");
    expect_change(
        t, draw, [&] { gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, size, of_lower.data(), GL_DYNAMIC_DRAW); }, "BufferData");
    expect_change(
        t, draw,
        [&] {
          void* const mapped = gl.MapBufferRange(GL_ELEMENT_ARRAY_BUFFER, 0, size, GL_MAP_WRITE_BIT);
          t.require(mapped != nullptr, "the buffer can be mapped");
          std::memcpy(mapped, of_upper.data(), of_upper.size());
          gl.UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
        },
        "MapBufferRange");
    expect_change(
        t, draw,
        [&] {
          buffer_of(GL_COPY_READ_BUFFER, of_lower);
          gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
          gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, size);
        },
        "CopyBufferSubData");
    expect_change(
        t, draw, [&] { buffer_of(GL_ELEMENT_ARRAY_BUFFER, of_upper); }, "another buffer");
  }
}

constexpr Area often_case{"ark.draw.often.elements."};

}  // namespace

Cases changed_elements_cases() {
  Cases cases;
  for (const Type& type : types)
    for (const bool is_uniform : {true, false})
      cases.push_back(often_case(std::string(type.leaf) + (is_uniform ? ".uniform" : ".tags"),
                                 {"10.R.2-2", "11.R.13-1"},
                                 "Repeat each indexed draw very often, and write its indices by each command.",
                                 "The vertices of the earlier indices.",
                                 [&type, is_uniform](Test& t) { check_elements(t, type, is_uniform); }));
  return cases;
}

}  // namespace glark::conformance
