// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tags that are no numbers, infinite, negative or tiny, at each vertex of every kind of primitive. Each counts as a
// plain tag does (10.R.1).
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/triangle_modes.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLuint tag_pool = 4;
constexpr std::size_t tagged_vertices = 8;

struct UnusualTag {
  std::uint32_t bits;
  float same_as;
};

constexpr UnusualTag unusual_tags[] = {
    {0x7fc00000, 0}, {0xffc00000, 0}, {0x7f800001, 0}, {0xff800001, 0}, {0x7fffffff, 0}, {0xffffffff, 0},  // NaN
    {0x7f800000, 4}, {0xff800000, 0},                                                                      // infinite
    {0x7f7fffff, 4}, {0xff7fffff, 0}, {0x4f800000, 4}, {0xcf800000, 0}, {0x40b00000, 4},                   // large
    {0x80000000, 0}, {0x00000001, 0}, {0x80000001, 0}, {0x3effffff, 0}, {0x3f000000, 1}, {0xbf000000, 0},
};

float tag_of_bits(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

Mesh tagged_polygon() {
  Mesh mesh(tagged_vertices);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const double angle = 2 * std::acos(-1.0) * static_cast<double>(i) / tagged_vertices;
    mesh[i].position = {static_cast<float>(0.75 * std::cos(angle)), static_cast<float>(0.75 * std::sin(angle)), 0, 1};
    mesh[i].tag = static_cast<float>((3 * i + 1) % 5);
  }
  return mesh;
}

GLuint count_of_mode(const Mesh& mesh, GLenum mode) {
  upload(mesh);
  return count_generated([mode] { gl.DrawArrays(mode, 0, tagged_vertices); });
}

GLuint count_by_begin(const Mesh& mesh, GLenum mode) {
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  return count_generated([&] {
    gl.Begin(mode);
    for (const MeshVertex& vertex : mesh) {
      gl.VertexAttrib1f(attribute, vertex.tag);
      gl.VertexAttrib4fv(0, vertex.position.data());
    }
    gl.End();
  });
}

void check_unusual(Test& t, GLenum mode, GLenum split, bool is_immediate) {
  gl.UseProgram(colour_program(t));
  refine_by_tags(tag_pool);
  if (t.is_compat()) gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, static_cast<GLint>(split));
  const auto count = [&](const Mesh& mesh) {
    return is_immediate ? count_by_begin(mesh, mode) : count_of_mode(mesh, mode);
  };
  for (std::size_t vertex = 0; vertex < tagged_vertices; ++vertex)
    for (const UnusualTag& tag : unusual_tags) {
      Mesh mesh = tagged_polygon();
      mesh[vertex].tag = tag.same_as;
      const GLuint expected = count(mesh);
      mesh[vertex].tag = tag_of_bits(tag.bits);
      if (!t.expect_equal(
              count(mesh), expected,
              fmt::format("triangles with the tag {:#x} at vertex {}, as with {}", tag.bits, vertex, tag.same_as)))
        break;
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases unusual_tags_cases() {
  Cases cases;
  for (const TriangleMode& mode : triangle_modes)
    for (const bool is_centroid : {false, true})
      for (const bool is_immediate : {false, true}) {
        if (is_centroid && !mode.is_legacy) continue;
        cases.push_back(
            {.name = fmt::format("ark.tag.unusual.{}{}{}", mode.name, is_centroid ? ".centroid" : "",
                                 is_immediate ? ".begin" : ""),
             .clauses = {"10.R.1-3", "10.R.1-5", "11.R.4-2"},
             .plan =
                 "Give each vertex in turn a tag that is not a number, infinite, negative, large or tiny, and count "
                 "the triangles: as many as with the plain tag that it stands for.",
             .wrong = "Some of them are the greatest tag, or one that is not clamped.",
             .apis = mode.is_legacy || is_immediate ? compat_only : every_api,
             .check = [mode, is_centroid, is_immediate](Test& t) {
               check_unusual(t, mode.mode, is_centroid ? GL_POLYGON_CENTROID_ARK : GL_POLYGON_TRIANGLES_ARK,
                             is_immediate);
             }});
      }
  return cases;
}

}  // namespace glark::conformance
