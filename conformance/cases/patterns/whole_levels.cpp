// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every level of the pool covers a coarse triangle once, whatever the depth comes from (11.R.5).
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr int greatest_level = 11;  // MAX_DEPTH_ARK is at least this

// Two triangles over the whole surface, each drawn once with an eighth of all channels.
void upload_whole_surface(float tag) {
  constexpr float places[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {1, 1}, {-1, 1}, {-1, -1}};
  Mesh mesh(6);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].position = {places[i][0], places[i][1], 0, 1};
    mesh[i].colour = {0.125F, 0.125F, 0.125F, 0.125F};
    mesh[i].tag = tag;
  }
  upload(mesh);
}

// Triangle by triangle: the deepest have four million refined triangles.
Picture sum_of_triangles(int triangles) {
  clear_surface();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  for (GLint i = 0; i < triangles; ++i) gl.DrawArrays(GL_TRIANGLES, 3 * i, 3);
  gl.Disable(GL_BLEND);
  return read_picture(surface_size, surface_size);
}

void check_level(Test& t, int level, GLenum source) {
  gl.UseProgram(colour_program(t));
  upload_whole_surface(static_cast<float>(level));
  const int triangles = level > 9 ? 1 : 2;
  const Picture plain = sum_of_triangles(triangles);
  refine_uniformly(static_cast<GLuint>(level));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  t.expect_same_picture(sum_of_triangles(triangles), plain, fmt::format("each pixel is drawn once at level {}", level),
                        1, 2 * surface_size);
  if (level < 9)
    t.expect_equal(count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 6); }), GLuint{2} << (2 * level),
                   "refined triangles");
  t.expect_no_error("the draws");
}

}  // namespace

Cases whole_levels_cases() {
  Cases cases;
  for (int level = 0; level <= greatest_level; ++level)
    for (const auto& [leaf, source] :
         {std::pair<const char*, GLenum>{"uniform", GL_UNIFORM_DEPTH_ARK}, {"tags", GL_DEPTH_TAG_ARK}})
      cases.push_back(
          {.name = fmt::format("ark.pattern.whole.{}.level_{:02}", leaf, level),
           .clauses = {"11.R.5-7", "11.R.5-11", "11.R.1-2"},
           .plan = "Add up a triangle at this depth, in a pool of this level: each pixel is drawn exactly once.",
           .wrong = "A part of the triangle is missing or is drawn twice: a deep level is put together from parts.",
           .check = [level, source = source](Test& t) { check_level(t, level, source); }});
  return cases;
}

}  // namespace glark::conformance
