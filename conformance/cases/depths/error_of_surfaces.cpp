// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// SCREEN_ERROR_ARK where other parameters shape the edges (11.R.4): PHONG_SHAPE_ARK with every value, and displacement by
// a height map with every refinement. The distances are measured on the curves of 11.R.7 to 11.R.7c.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using reference::Depths;
using reference::Vector;

constexpr int deepest = 6;

// What shapes the surface.
struct Shaping {
  GLenum refinement = GL_LINEAR_INPUTS_ARK;
  double phong = 0.75;
  double scale = 0;  // of the displacement; 0: no displacement
  double bias = 0;
  bool is_welded = false;
  bool has_attribute = false;  // DISPLACEMENT_COORDINATE_ARK
  int channel = 0;
};

// The heights are a parabola: 0 at both ends of the texture and 1 in the middle, in channel 0. Other channels are lower.
constexpr int map_width = 256;
constexpr double share_of_channel[] = {1, 0.5, 0.05, 0.01};
double parabola(double s) { return 4 * s * (1 - s); }

void bind_parabola(GLenum unit) {
  std::vector<float> texels;
  for (int x = 0; x < map_width; ++x)
    for (const double share : share_of_channel)
      texels.push_back(static_cast<float>(share * parabola((x + 0.5) / map_width)));
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, map_width, 1, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl.ActiveTexture(GL_TEXTURE0);
}

Vector on_screen(const Vector& position) { return {position.x * surface_size / 2, position.y * surface_size / 2, 0}; }

Vector linear(const std::array<Vector, 3>& of, const Vec3& weights) {
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + static_cast<double>(weights[i]) * of[i];
  return sum;
}

reference::Surface undisplaced_at(const Shaping& shaping, const reference::Corners& corners, const Vec3& weights) {
  if (shaping.refinement == GL_CURVED_PN_ARK) return reference::curved_pn(corners, weights);
  if (shaping.refinement == GL_SCALAR_TAGGED_PN_ARK) return reference::scalar_tagged_pn(corners, weights);
  if (shaping.refinement == GL_PHONG_ARK) return reference::phong(corners, weights, shaping.phong);
  std::array<Vector, 3> positions;
  std::array<Vector, 3> normals;
  for (std::size_t i = 0; i < 3; ++i) {
    positions[i] = reference::vector_of(corners[i].position);
    normals[i] = reference::vector_of(corners[i].normal);
  }
  return {linear(positions, weights), linear(normals, weights)};
}

// Where the point of edge `edge` is on the screen, by (11.R.7).
Vector edge_point(const Shaping& shaping, const Mesh& mesh, std::size_t edge, double along) {
  Vec3 weights{};
  weights[edge] = static_cast<float>(1 - along);
  weights[(edge + 1) % 3] = static_cast<float>(along);
  const reference::Surface surface = undisplaced_at(shaping, corners_of(mesh, 0), weights);
  double s = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const float of_corner = shaping.has_attribute ? mesh[i].colour[0] : mesh[i].texture[0];
    s += static_cast<double>(weights[i]) * static_cast<double>(of_corner);
  }
  const double height = shaping.scale * share_of_channel[shaping.channel] * parabola(s) + shaping.bias;
  const bool displaces = shaping.scale != 0 || shaping.bias != 0;
  return on_screen(displaces ? surface.position + height * reference::direction(surface.normal) : surface.position);
}

// The greatest distance between the curve and its 2^depth segments, at the same coordinates.
double distance_of(const Shaping& shaping, const Mesh& mesh, std::size_t edge, int depth) {
  constexpr int samples = 16;
  const int segments = 1 << depth;
  double greatest = 0;
  for (int segment = 0; segment < segments; ++segment) {
    const Vector begin = edge_point(shaping, mesh, edge, double(segment) / segments);
    const Vector end = edge_point(shaping, mesh, edge, double(segment + 1) / segments);
    for (int i = 1; i < samples; ++i) {
      const double share = double(i) / samples;
      const Vector point = edge_point(shaping, mesh, edge, (segment + share) / segments);
      greatest = std::max(greatest, reference::length(point - ((1 - share) * begin + share * end)));
    }
  }
  return greatest;
}

int needed_depth(const Shaping& shaping, const Mesh& mesh, std::size_t edge, double error) {
  int depth = 0;
  while (depth < deepest && distance_of(shaping, mesh, edge, depth) > error) ++depth;
  return depth;
}

// A triangle in the plane z = 0. Its normals lie in that plane, too: in three directions if `is_bent`, otherwise all
// along +y.
Mesh shaped_triangle(bool is_bent) {
  Mesh mesh = one_triangle({6, 6, 6});
  const double degrees[] = {115, 65, 150};
  const Vec2 places[] = {{-0.8F, -0.6F}, {0.75F, -0.55F}, {-0.7F, 0.7F}};
  const float along[] = {0, 1, 0.25F};  // texture coordinates
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = (is_bent ? degrees[i] : 90) * std::acos(-1.0) / 180;
    mesh[i].position = {places[i][0], places[i][1], 0, 1};
    mesh[i].normal = {static_cast<float>(1.5 * std::cos(angle)), static_cast<float>(1.5 * std::sin(angle)), 0};
    mesh[i].texture = {along[i], 0.5F};
    mesh[i].colour = {1 - 0.5F * along[i], 0.5F, 0, 1};
  }
  return mesh;
}

GLuint shaped_program(Test& t) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                                     "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                                     "layout(location = 4) in vec2 texcoord; layout(location = 3) in vec4 hue;\n"
                                     "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                                     "void main() { weights_out = weights; colour = hue + vec4(texcoord, 0.0, 0.0);\n"
                                     "  triangle_out = triangle + normal.z; gl_Position = position; }\n",
                           .captured = {"gl_Position", "weights_out", "triangle_out"}});
}

constexpr GLint map_unit = 2;

void set_shaping(const Shaping& shaping, GLfloat error) {
  constexpr GLint channels[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(shaping.refinement));
  gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, static_cast<GLfloat>(shaping.phong));
  gl.ARKParameteriARK(GL_WELD_ARK, shaping.is_welded ? GL_TRUE : GL_FALSE);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, shaping.scale != 0 || shaping.bias != 0 ? map_unit : -1);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, static_cast<GLfloat>(shaping.scale));
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, static_cast<GLfloat>(shaping.bias));
  gl.ARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, channels[shaping.channel]);
  gl.ARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, shaping.has_attribute ? GLint{at_colour} : -1);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, error);
}

void set_up_shaped(Test& t) {
  gl.UseProgram(shaped_program(t));
  bind_parabola(map_unit);
  refine_by_tags(deepest);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  gl.Viewport(0, 0, surface_size, surface_size);
}

void draw_shaped() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// The measure looks at a cubic through some points of the curve, so a tenth more or less is permitted.
void expect_shaped(Test& t, const Shaping& shaping, const Mesh& mesh, GLfloat error, const std::string& what) {
  set_shaping(shaping, error);
  const Depths depths = depths_of(t, 1, draw_shaped).front();
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const int least = needed_depth(shaping, mesh, edge, 1.1 * double{error} + 0.01);
    const int most = std::min(needed_depth(shaping, mesh, edge, double{error} / 1.1 - 0.01) + 2, deepest);
    t.expect(depths[edge] >= least && depths[edge] <= most,
             fmt::format("{}, an error of {}: edge {} has depth {}, and needs {} to {}", what, error, edge,
                         depths[edge], least, most));
  }
}

constexpr std::array<GLfloat, 4> errors = {6, 1.7F, 0.5F, 0.15F};

// The shapes go up and down again: a shape of before must not be used.
void check_phong(Test& t, bool is_welded) {
  set_up_shaped(t);
  const Mesh mesh = shaped_triangle(true);
  upload(mesh);
  for (const double shape : {0.75, 0.0, 0.25, 1.0, 0.5, 0.125, 0.875, 0.0})
    for (const GLfloat error : errors)
      expect_shaped(t, {.refinement = GL_PHONG_ARK, .phong = shape, .is_welded = is_welded}, mesh, error,
                    fmt::format("a shape of {}", shape));
  t.expect_no_error("the draws");
}

// PHONG_SHAPE_ARK shapes nothing but PHONG_ARK.
void check_other_shapes(Test& t) {
  set_up_shaped(t);
  const Mesh mesh = shaped_triangle(true);
  upload(mesh);
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK})
    for (const double shape : {0.0, 1.0})
      expect_shaped(t, {.refinement = refinement, .phong = shape}, mesh, 0.5F, fmt::format("a shape of {}", shape));
  set_shaping({.refinement = GL_LINEAR_OUTPUTS_ARK, .phong = 1, .scale = 0.5}, 0.1F);
  t.expect(depths_of(t, 1, draw_shaped).front() == Depths{0, 0, 0}, "linear outputs are straight, and not displaced");
}

struct DisplacedError {
  const char* leaf;
  Shaping shaping;
  bool is_bent = false;
};

const std::vector<DisplacedError>& displaced_errors() {
  static const std::vector<DisplacedError> all = [] {
    std::vector<DisplacedError> rows;
    for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"inputs", GL_LINEAR_INPUTS_ARK},
                                           {"curved", GL_CURVED_PN_ARK},
                                           {"tagged", GL_SCALAR_TAGGED_PN_ARK},
                                           {"phong", GL_PHONG_ARK}}) {
      rows.push_back({leaf, {.refinement = refinement, .scale = 0.3}});
      rows.push_back({leaf, {.refinement = refinement, .scale = 0.3}, true});
      rows.push_back({leaf, {.refinement = refinement, .scale = 0.3, .is_welded = true}, true});
    }
    rows.push_back({"negative", {.scale = -0.25, .bias = 0.1}, true});
    rows.push_back({"bias_alone", {.scale = 0, .bias = 0.4}, true});
    rows.push_back({"bias_upright", {.scale = 0, .bias = 0.4}});
    rows.push_back({"channel", {.scale = 0.5, .channel = 2}});
    rows.push_back({"channel_alpha", {.scale = 0.5, .channel = 3}});
    rows.push_back({"attribute", {.scale = 0.3, .has_attribute = true}});
    rows.push_back({"phong_0", {.refinement = GL_PHONG_ARK, .phong = 0, .scale = 0.2, .bias = -0.1}, true});
    rows.push_back({"phong_1", {.refinement = GL_PHONG_ARK, .phong = 1, .scale = 0.2, .bias = -0.1}, true});
    return rows;
  }();
  return all;
}

// One context for all: what one row sets must not stay for the next.
void check_displaced(Test& t, bool is_bent) {
  set_up_shaped(t);
  const Mesh mesh = shaped_triangle(is_bent);
  upload(mesh);
  for (const DisplacedError& row : displaced_errors()) {
    if (row.is_bent != is_bent) continue;
    for (const GLfloat error : errors)
      expect_shaped(t, row.shaping, mesh, error, row.leaf + std::string(row.shaping.is_welded ? ", welded" : ""));
  }
  t.expect_no_error("the draws");
}

// After many draws to the screen, one parameter changes. The triangles are those of a new context.
void check_changes(Test& t) {
  const Mesh mesh = shaped_triangle(true);
  const auto counted = [&](const Shaping& shaping) {
    const std::unique_ptr<Context> context = t.create_context();
    set_up_shaped(t);
    upload(mesh);
    set_shaping(shaping, 0.4F);
    return count_generated(draw_shaped);
  };
  const std::vector<Shaping> steps = {{.refinement = GL_PHONG_ARK, .phong = 1},
                                      {.refinement = GL_PHONG_ARK, .phong = 0},
                                      {.refinement = GL_PHONG_ARK, .phong = 0.5},
                                      {.refinement = GL_PHONG_ARK, .phong = 0.5, .scale = 0.4},
                                      {.refinement = GL_PHONG_ARK, .phong = 0.5, .scale = 0.04},
                                      {.refinement = GL_PHONG_ARK, .phong = 0, .scale = 0.04},
                                      {.refinement = GL_CURVED_PN_ARK, .scale = 0.3, .channel = 3},
                                      {.refinement = GL_CURVED_PN_ARK, .scale = 0.3},
                                      {.scale = 0.3},
                                      {.scale = 0.3, .has_attribute = true},
                                      {.scale = 0, .bias = 0.5},
                                      {.scale = 0, .bias = 0}};
  std::vector<GLuint> expected;
  for (const Shaping& step : steps) expected.push_back(counted(step));
  const std::unique_ptr<Context> context = t.create_context();
  set_up_shaped(t);
  upload(mesh);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    set_shaping(steps[i], 0.4F);
    t.expect_equal(count_generated(draw_shaped), expected[i], fmt::format("triangles of step {}", i));
    repeat_often(draw_shaped);
    t.expect_equal(count_generated(draw_shaped), expected[i], fmt::format("triangles of step {}, often", i));
    if (i > 0) t.expect(expected[i] != expected[i - 1], fmt::format("step {} changes the depths", i));
  }
  t.expect_no_error("the draws");
}

constexpr Area surface_case{"ark.depth.error_of_surface."};

}  // namespace

Cases error_of_surfaces_cases() {
  const std::vector<std::string> clauses = {"11.R.4-19", "11.R.4-20", "11.R.4-21", "11.R.4-22"};
  return {surface_case("phong", clauses, "Phong surfaces of many shapes; the distance is sampled on the curve.",
                       "The shape is 0 or 0.75 for the measure.", [](Test& t) { check_phong(t, false); }),
          surface_case("phong_welded", clauses, "The same with WELD_ARK.", "Welding measures another curve.",
                       [](Test& t) { check_phong(t, true); }),
          surface_case("other_shapes", {"11.R.4-20", "11.R.4-23"},
                       "PHONG_SHAPE_ARK of 0 and 1, with the other refinements.", "It shapes them, too.",
                       check_other_shapes),
          surface_case(
              "displaced", clauses,
              "A parabola displaces upright normals, by every refinement, scale, bias, channel and coordinate.",
              "The measure looks at the surface before it is displaced.", [](Test& t) { check_displaced(t, false); }),
          surface_case("displaced_bent", clauses, "The same with normals that differ.",
                       "The heights are added along another normal.", [](Test& t) { check_displaced(t, true); }),
          surface_case("changes", {"11.R.4-19", "11.R.4-20", "11.R.13-1"},
                       "Draw often, change the shape or the displacement, and count.", "Depths of before are kept.",
                       check_changes)};
}

}  // namespace glark::conformance
