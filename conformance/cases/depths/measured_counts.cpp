// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measured depths of draws with several different triangles: each is refined as if it were drawn alone.
#include <fmt/core.h>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct Measure {
  const char* leaf;
  std::vector<std::string> clauses;
  GLint pixels;
  GLint degrees;
  GLfloat error;
  GLenum refinement;
  const char* position = "position";
};

const std::array<Measure, 6> measures = {
    {{"pixels", {"11.R.4-4", "11.R.4-18"}, 4, 0, 0, GL_LINEAR_INPUTS_ARK},
     {"degrees", {"11.R.4-8", "11.R.4-18"}, 0, 10, 0, GL_LINEAR_INPUTS_ARK},
     {"error_curved", {"11.R.4-19", "11.R.4-22"}, 0, 0, 0.1F, GL_CURVED_PN_ARK},
     {"error_tagged", {"11.R.4-19", "11.R.4-22"}, 0, 0, 0.1F, GL_SCALAR_TAGGED_PN_ARK},
     {"error_stage",
      {"11.R.4-19", "11.R.4-20"},
      0,
      0,
      0.1F,
      GL_LINEAR_INPUTS_ARK,
      "position + vec4(0.0, normal.x * normal.x, 0.0, 0.0)"},
     {"all", {"11.R.4-18", "11.R.4-19"}, 4, 10, 0.2F, GL_CURVED_PN_ARK}}};

constexpr int kinds = 7;  // of triangles, which differ in size and in their normals; those of the first are equal

Mesh triangles_of_all_kinds(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto kind = static_cast<float>(i % kinds);
    const float turns[] = {0.11F, -0.07F, 0.04F};
    Mesh one = one_triangle();
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis) one[k].position[axis] *= 0.2F + 0.11F * kind;
      const float turn = turns[k] * kind;
      one[k].normal = {std::sin(turn), turn / 2, std::cos(turn)};
    }
    mesh.insert(mesh.end(), one.begin(), one.end());
  }
  return mesh;
}

GLuint count_of(int first, int count) {
  return count_generated([&] { gl.DrawArrays(GL_TRIANGLES, 3 * first, 3 * count); });
}

void check_counts(Test& t, const Measure& measure, bool is_welded) {
  gl.UseProgram(
      build_program(t, {.vertex = std::string("layout(location = 0) in vec4 position;\n"
                                              "layout(location = 1) in vec3 normal; out vec4 colour;\n"
                                              "void main() { colour = vec4(abs(normal), 1.0); gl_Position = ") +
                                  measure.position + "; }\n"}));
  upload(triangles_of_all_kinds(130 + kinds));
  refine_by_tags(6, measure.refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, measure.pixels);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, measure.degrees);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, measure.error);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  gl.Viewport(0, 0, surface_size, surface_size);
  std::array<GLuint, kinds> alone{};
  for (int i = 0; i < kinds; ++i) alone[static_cast<std::size_t>(i)] = count_of(i, 1);
  t.expect(std::set<GLuint>(alone.begin(), alone.end()).size() > 3, "the triangles have different depths");
  for (const int count : {2, 3, 4, 5, 6, 7, 8, 9, 32, 65, 128, 130})
    for (int first = 0; first < (count < 10 ? kinds : 1); ++first) {
      GLuint expected = 0;
      for (int i = first; i < first + count; ++i) expected += alone[static_cast<std::size_t>(i % kinds)];
      if (!t.expect_equal(count_of(first, count), expected,
                          fmt::format("refined triangles of {} triangles from number {}", count, first)))
        return;
    }
  t.expect_no_error("the draws");
}

// The tagged triangles are not the same in any two frames, so nothing that is kept can hide them.
void check_budget_beside_tags(Test& t) {
  constexpr GLint budget = 2000;
  constexpr int measured_triangles = 16;
  constexpr int tagged_triangles = 20;
  gl.UseProgram(colour_program(t));
  refine_by_tags(6);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 2);
  gl.Viewport(0, 0, surface_size, surface_size);
  const auto triangles_in_a_frame = [&](int frame) {
    Mesh mesh;
    for (int i = 0; i < measured_triangles + tagged_triangles; ++i) {
      Mesh one = one_triangle({4, 5, 4});
      one[0].position[2] = i < measured_triangles ? 0.0F : 0.001F * static_cast<float>(frame);
      mesh.insert(mesh.end(), one.begin(), one.end());
    }
    upload(mesh);
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
    gl.DrawArrays(GL_TRIANGLES, 3 * measured_triangles, 3 * tagged_triangles);
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
    const GLuint measured = count_of(0, measured_triangles);
    t.context().end_frame();
    return measured;
  };
  t.require(triangles_in_a_frame(0) > budget, "without a budget there are many triangles");
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  GLuint last = 0;
  for (int frame = 0; frame < 40; ++frame) last = triangles_in_a_frame(frame);
  t.expect(last <= budget, fmt::format("{} triangles with a budget of {}", last, budget));
  t.expect(last >= budget / 4, fmt::format("{} triangles are at least a quarter of the budget", last));
}

}  // namespace

Cases measured_counts_cases() {
  Cases cases{{.name = "ark.depth.budget.beside_tags",
               .clauses = {"11.R.4-28"},
               .plan = "Draw measured triangles with a budget, and in every frame before them others with tags.",
               .wrong = "The triangles with tags use up the budget, and those with measured depths stay coarse.",
               .check = check_budget_beside_tags}};
  for (const Measure& measure : measures)
    for (const bool is_welded : {false, true})
      cases.push_back({.name = fmt::format("ark.depth.counts.{}{}", measure.leaf, is_welded ? ".welded" : ""),
                       .clauses = measure.clauses,
                       .plan = "Draw 1 to 130 different triangles at once, from several first ones, and count.",
                       .wrong = "The last triangle, or one at the border of a group, has the depths of another one.",
                       .check = [&measure, is_welded](Test& t) { check_counts(t, measure, is_welded); }});
  return cases;
}

}  // namespace glark::conformance
