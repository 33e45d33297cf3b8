// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar-tagged PN triangles (11.R.7a).
#include <algorithm>
#include <cmath>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
const Vec4 untagged = {0, 0, 0, 1};

// Vertices of bent_mesh: 0 1 2, and 2 3 0. A vertex has the same tags in both triangles.
ShapeTags of_vertices(const std::array<Vec4, 4>& discontinuities, const std::array<Vec3, 4>& scalars) {
  ShapeTags tags;
  for (const std::size_t i : {0U, 1U, 2U, 2U, 3U, 0U}) {
    tags.discontinuities.push_back(discontinuities[i]);
    tags.scalars.push_back(scalars[i]);
  }
  return tags;
}

struct TagCase {
  const char* leaf;
  std::vector<std::string> clauses;
  const char* plan;
  const char* wrong;
  std::array<Vec4, 4> discontinuities;
  std::array<Vec3, 4> scalars;
};

const Vec4 jump_0 = {0.5F, -0.6F, 0.1F, 3};
const Vec4 jump_1 = {-0.2F, 0.7F, 0.4F, 3};
const Vec4 jump_2 = {0.8F, 0.3F, -0.2F, 3};

Vec4 numbered(Vec4 jump, float number) {
  jump[3] = number;
  return jump;
}

std::vector<TagCase> tag_cases() {
  const Vec3 none = {0, 0, 0};
  const Vec3 sharp = {1, 0, 0};
  return {
      {"one_tagged",
       {"11.R.7a-1", "11.R.7a-4", "11.R.7a-14", "11.R.7a-15", "11.R.7a-17", "11.R.7a-18", "11.R.7a-19", "11.R.7a-20"},
       "One corner is tagged, with a sharpness of 1: no edge is sharp, and each lies on one side.",
       "N+ and N- are exchanged; M counts although j is tagged, or does not count although j is untagged.",
       {jump_0, untagged, untagged, untagged},
       {sharp, none, none, none}},
      {"sharpness_half",
       {"11.R.7a-17", "11.R.7a-18"},
       "Sharpness 0.4: the normal lies between N and N'.",
       "The direction of N + s s D; the mix is not scaled to unit length.",
       {jump_0, untagged, jump_2, untagged},
       {Vec3{0.4F, 0, 0}, none, Vec3{0.7F, 0, 0}, none}},
      {"sharpness_above_1",
       {"11.R.7a-8", "11.R.7a-17", "11.R.7a-18", "11.R.7a-22"},
       "Sharpness 2.5: min(s, 1) mixes, and s itself turns the normal of the side.",
       "s is clamped to 1 everywhere.",
       {jump_0, untagged, untagged, untagged},
       {Vec3{2.5F, 0, 0}, none, none, none}},
      {"sharpness_negative",
       {"11.R.7a-8"},
       "A sharpness of -3 is 0.",
       "The sides are exchanged.",
       {jump_0, untagged, untagged, untagged},
       {Vec3{-3, 0, 0}, none, none, none}},
      {"sharpness_great",
       {"11.R.7a-26", "11.R.7a-8"},
       "A sharpness of 10^7 is 65536, which shows where D is short.",
       "The sharpness has no limit, or a lower one.",
       {Vec4{3e-5F, -2e-5F, 1e-5F, 3}, untagged, untagged, untagged},
       {Vec3{1e7F, 0, 0}, none, none, none}},
      {"sharp_edge",
       {"11.R.7a-12", "11.R.7a-18"},
       "Corners 0 and 2, on the shared edge, have the same crease number.",
       "A sharp edge is pulled to one side.",
       {jump_0, untagged, jump_2, untagged},
       {sharp, none, sharp, none}},
      {"sharp_edge_bias",
       {"11.R.7a-18"},
       "The same with biases of 0.75 and -0.5: L is the direction of N + g D.",
       "Bias is ignored, or also applied to M.",
       {jump_0, untagged, jump_2, untagged},
       {Vec3{1, 0, 0.75F}, none, Vec3{0.8F, 0, -0.5F}, none}},
      {"bias_without_sharp_edge",
       {"11.R.7a-18"},
       "A bias on a corner without sharp edges has no effect.",
       "Bias bends every edge that leaves the corner.",
       {jump_0, untagged, untagged, untagged},
       {Vec3{1, 0, 0.75F}, none, Vec3{0, 0, 0.9F}, none}},
      {"other_crease",
       {"11.R.7a-5", "11.R.7a-12", "11.R.7a-14"},
       "Both ends are tagged with different numbers: the edge is not sharp.",
       "The number is ignored.",
       {jump_0, untagged, numbered(jump_2, 4), untagged},
       {sharp, none, sharp, none}},
      {"number_zero",
       {"11.R.7a-13"},
       "The number 0 counts as equal to 3.",
       "0 is an ordinary number.",
       {jump_0, untagged, numbered(jump_2, 0), untagged},
       {sharp, none, Vec3{1, 0, 0.5F}, none}},
      {"all_tagged",
       {"11.R.7a-12", "11.R.7a-21"},
       "All corners are tagged with one number: the sides follow from the plane.",
       "F does not point to the side of the normals; the corner has no side.",
       {jump_0, jump_1, jump_2, untagged},
       {sharp, Vec3{0.5F, 0, 0.2F}, sharp, none}},
      {"sides_cancel",
       {"11.R.7a-16", "11.R.7a-21"},
       "D is perpendicular to the edges that are not sharp, so there is no side.",
       "0 counts as positive.",
       {Vec4{0, 0, 0.5F, 3}, untagged, untagged, untagged},
       {sharp, none, none, none}},
      {"tension",
       {"11.R.7a-18"},
       "Tensions of 0.5, -0.75, 0.25 and -1 without tagged corners.",
       "Tension moves the control point at the wrong end; 1 - t appears only once.",
       {untagged, untagged, untagged, untagged},
       {Vec3{0, 0.5F, 0}, Vec3{0, -0.75F, 0}, Vec3{0, 0.25F, 0}, Vec3{0, -1, 0}}},
      {"tension_clamped",
       {"11.R.7a-26", "11.R.7a-8"},
       "Tensions of 7 and -7 count as 1 and -1, and biases of 5 and -5 too.",
       "Values are not clamped.",
       {jump_0, untagged, jump_2, untagged},
       {Vec3{1, 7, 5}, Vec3{0, -7, 0}, Vec3{1, -7, -5}, Vec3{0, 7, 0}}},
      {"not_numbers",
       {"11.R.7a-8"},
       "Scalar tags that are NaN count as 0.",
       "The triangle vanishes.",
       {jump_0, untagged, jump_2, untagged},
       {Vec3{nan_value, nan_value, nan_value}, Vec3{0, nan_value, 0}, Vec3{1, 0, nan_value}, none}},
      {"infinite_discontinuity",
       {"11.R.7a-25"},
       "Corners whose D is infinite or NaN are not tagged.",
       "The triangle vanishes.",
       {Vec4{infinite, 0, 0, 1}, Vec4{0, nan_value, 0, 1}, jump_2, Vec4{0, 0, -infinite, 1}},
       {sharp, sharp, sharp, sharp}},
      {"long_discontinuity",
       {"11.R.7a-25"},
       "D of a length of 900 000 tags its corner; those of more than a million do not.",
       "The limit is missing, lower, or that of the numbers.",
       {Vec4{900000, 0, 0, 1}, Vec4{0, 1.1e6F, 0, 1}, Vec4{1e12F, 0, 3, 1}, Vec4{1e20F, 0, 0, 1}},
       {Vec3{0.5F, 0, 0}, sharp, sharp, sharp}},
      {"everything",
       {"11.R.7a-2", "11.R.7a-3", "11.R.7a-15", "11.R.7a-18", "11.R.7a-22"},
       "Everything at once, with two creases that cross the shared edge.",
       "Any of the above.",
       {jump_0, numbered(jump_1, 0), numbered(jump_2, 5), Vec4{0.1F, 0.2F, 0.6F, 3}},
       {Vec3{0.6F, 0.25F, 0.5F}, Vec3{1.5F, -0.5F, 0.25F}, Vec3{0.3F, 0, -1}, Vec3{1, 0.75F, 1}}},
  };
}

// Rounding must not decide on which side the triangle lies.
Mesh tagged_mesh(const std::string& leaf) {
  Mesh mesh = bent_mesh();
  if (leaf != "sides_cancel") return mesh;
  mesh.resize(3);
  for (MeshVertex& vertex : mesh) vertex.position[2] = 0;
  return mesh;
}

void check_tags(Test& t, const TagCase& tag_case) {
  const GLuint program = surface_program(t);
  gl.UseProgram(program);
  const Mesh mesh = tagged_mesh(tag_case.leaf);
  upload(mesh);
  ShapeTags tags = of_vertices(tag_case.discontinuities, tag_case.scalars);
  upload_shape_tags(tags);
  refine_uniformly(4, GL_SCALAR_TAGGED_PN_ARK);
  require_refinable(t, program);
  expect_surface(t, capture_surface(t, mesh), mesh, tags, reference::scalar_tagged_pn, 4e-6);
}

// Each place in turn has another fourth component than its neighbours. A displacement by 0 changes nothing.
void check_fourth_components(Test& t, const TagCase& tag_case, bool is_displaced) {
  gl.UseProgram(surface_program(t));
  const ShapeTags tags = of_vertices(tag_case.discontinuities, tag_case.scalars);
  refine_uniformly(3, GL_SCALAR_TAGGED_PN_ARK);
  if (is_displaced) {
    bind_nearest_texture(3, 1, {255, 255, 255, 255});
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 3);
    gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0);
  }
  const Mesh same = bent_mesh();
  for (std::size_t place = 0; place < 4; ++place) {
    Mesh mesh = same;
    for (MeshVertex& vertex : mesh)
      if (same_position(vertex.position, same[std::array{0U, 1U, 2U, 4U}[place]].position)) vertex.position[3] = 1.5F;
    upload(mesh);
    upload_shape_tags(tags);
    expect_surface(t, capture_surface(t, mesh), mesh, tags, reference::scalar_tagged_pn, 4e-6);
  }
}

Case fourth_components_case(const TagCase& tag_case, bool is_displaced) {
  return {.name = std::string("ark.tagged_pn.fourth_components.") + tag_case.leaf + (is_displaced ? ".displaced" : ""),
          .clauses = {"11.R.7-15", "11.R.7a-1", "11.R.7a-18"},
          .plan =
              "Each place of two triangles in turn has another fourth component: its edges stay straight. Positions "
              "and normals at depth 3 are compared with the reference.",
          .wrong = "Heights of points with different w are computed as if w were the same.",
          .check = [tag_case, is_displaced](Test& t) { check_fourth_components(t, tag_case, is_displaced); }};
}

void expect_bits_of_curved(Test& t, const std::function<void()>& prepare) {
  gl.UseProgram(surface_program(t));
  const Mesh mesh = bent_mesh();
  upload(mesh);
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const auto curved = capture_surface(t, mesh);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  prepare();
  const auto tagged = capture_surface(t, mesh);
  t.require(curved.size() == tagged.size() && curved.size() > 6, "both are refined");
  for (std::size_t i = 0; i < curved.size(); ++i)
    if (!t.expect(curved[i].position == tagged[i].position && curved[i].normal == tagged[i].normal,
                  "positions and normals have the bits of CURVED_PN_ARK"))
      return;
}

void check_initial_values(Test& t) {
  expect_bits_of_curved(t, [] {});
}

void check_no_effect(Test& t) {
  expect_bits_of_curved(t, [] {
    upload_shape_tags(of_vertices({Vec4{0, 0, 0, 7}, Vec4{0, 0, 0, 0}, untagged, Vec4{0, 0, 0, 2}},
                                  {Vec3{3, 0, 1}, Vec3{0.5F, 0, -1}, Vec3{1, 0, 0.5F}, Vec3{0, 0, 1}}));
  });
}

void check_tension_1(Test& t) {
  gl.UseProgram(surface_program(t));
  const Mesh mesh = bent_mesh();
  ShapeTags tags =
      of_vertices({untagged, jump_1, untagged, untagged}, {Vec3{0, 1, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}, Vec3{0, 1, 0}});
  Mesh turned = mesh;
  for (MeshVertex& vertex : turned) vertex.normal = {vertex.normal[2], vertex.normal[0], vertex.normal[1]};
  refine_uniformly(3, GL_SCALAR_TAGGED_PN_ARK);
  upload(mesh);
  upload_shape_tags(tags);
  const auto first = capture_surface(t, mesh);
  upload(turned);
  upload_shape_tags(tags);
  const auto second = capture_surface(t, turned);
  t.require(first.size() == second.size() && first.size() > 6, "both are refined");
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!t.expect(first[i].position == second[i].position, "positions do not depend on the normals")) return;
}

void check_current_values(Test& t) {
  GLint discontinuity = 0;
  GLint scalar = 0;
  gl.GetIntegerv(GL_DISCONTINUITY_ATTRIBUTE_ARK, &discontinuity);
  gl.GetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &scalar);
  gl.UseProgram(surface_program(t));
  const Mesh mesh = bent_mesh();
  upload(mesh);
  gl.VertexAttrib4f(static_cast<GLuint>(discontinuity), jump_0[0], jump_0[1], jump_0[2], jump_0[3]);
  gl.VertexAttrib3f(static_cast<GLuint>(scalar), 0.5F, 0.25F, 0.5F);
  refine_uniformly(3, GL_SCALAR_TAGGED_PN_ARK);
  const Vec3 tags = {0.5F, 0.25F, 0.5F};
  expect_surface(t, capture_surface(t, mesh), mesh,
                 of_vertices({jump_0, jump_0, jump_0, jump_0}, {tags, tags, tags, tags}), reference::scalar_tagged_pn,
                 4e-6);
}

void check_moved_attributes(Test& t) {
  gl.ARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, 9);
  gl.ARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, 8);
  const auto all = tag_cases();
  check_tags(t, all.back());
}

// The vertex stage reads the attribute as a float, neither as a vec3 nor as a vec4.
void check_other_type(Test& t) {
  gl.ARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, 7);
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                    "layout(location = 7) in vec2 jump; layout(location = 4) in vec2 texcoord;\n"
                    "out vec3 normal_out; out vec3 weights_out; out float triangle_out; out vec2 texture_out;\n"
                    "out vec4 colour;\n"
                    "void main() { gl_Position = position; normal_out = normal; weights_out = weights;\n"
                    "  triangle_out = triangle; texture_out = texcoord; colour = vec4(jump, 0.0, 1.0); }\n",
          .captured = {"gl_Position", "normal_out", "weights_out", "triangle_out", "texture_out"}}));
  const Mesh mesh = bent_mesh();
  upload(mesh);
  ShapeTags tags =
      of_vertices({jump_0, jump_1, jump_2, jump_0}, {Vec3{1, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}});
  upload_shape_tags(tags);
  refine_uniformly(3, GL_SCALAR_TAGGED_PN_ARK);
  tags.discontinuities.assign(6, untagged);
  expect_surface(t, capture_surface(t, mesh), mesh, tags, reference::scalar_tagged_pn, 4e-6);
}

}  // namespace

Cases scalar_tagged_pn_cases() {
  Cases cases;
  for (const TagCase& each : tag_cases())
    cases.push_back(
        {.name = std::string("ark.tagged_pn.") + each.leaf,
         .clauses = each.clauses,
         .plan = std::string(each.plan) + " Positions and normals at depth 4 are compared with the reference.",
         .wrong = each.wrong,
         .check = [each](Test& t) { check_tags(t, each); }});
  for (const TagCase& each : tag_cases())
    for (const bool is_displaced : {false, true})
      if (const std::string leaf = each.leaf; leaf == "tension" || leaf == "sharp_edge_bias" || leaf == "everything")
        cases.push_back(fourth_components_case(each, is_displaced));
  cases.push_back(
      {.name = "ark.tagged_pn.initial_values",
       .clauses = {"11.R.7a-9", "11.R.7a-23"},
       .plan = "Without attributes, compare bits with CURVED_PN_ARK.",
       .wrong = "Sums in another order: last bits differ, and the surface cracks against an untagged neighbour.",
       .check = check_initial_values});
  cases.push_back(
      {.name = "ark.tagged_pn.no_effect",
       .clauses = {"11.R.7a-23"},
       .plan =
           "Zero discontinuities and zero tensions, but sharpness, bias and crease numbers: the bits of CURVED_PN_ARK.",
       .wrong = "A mix with a weight of 0 changes the last bits.",
       .check = check_no_effect});
  cases.push_back({.name = "ark.tagged_pn.tension_1",
                   .clauses = {"11.R.7a-24"},
                   .plan = "Tension 1 everywhere, two sets of normals: the same positions.",
                   .wrong = "The height is not multiplied by 1 - t.",
                   .check = check_tension_1});
  cases.push_back({.name = "ark.tagged_pn.current_values",
                   .clauses = {"11.R.7a-4", "11.R.7a-26", "11.R.7a-11"},
                   .plan = "The current values give both attributes, and no input of the program reads them.",
                   .wrong = "Only arrays count, or only active inputs.",
                   .check = check_current_values});
  cases.push_back({.name = "ark.tagged_pn.moved_attributes",
                   .clauses = {"11.R.7a-4", "11.R.7a-26"},
                   .plan = "The parameters name attributes 9 and 8.",
                   .wrong = "The default indices are built in.",
                   .check = check_moved_attributes});
  cases.push_back({.name = "ark.tagged_pn.other_type",
                   .clauses = {"11.R.7a-11"},
                   .plan = "The vertex stage reads the discontinuity's attribute as a vec2: no corner is tagged.",
                   .wrong = "The array is still read, or the draw is not refined.",
                   .check = check_other_type});
  return cases;
}

}  // namespace glark::conformance
