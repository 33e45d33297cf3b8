// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depths by the distance between a refined edge and its segments on the screen (11.R.4).
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using reference::Depths;

constexpr int pool = 6;

struct Place {
  double x = 0;
  double y = 0;
};
Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
Place operator*(double factor, Place a) { return {factor * a.x, factor * a.y}; }

// In pixels, from the middle of the surface. Positions and normals lie in the plane of the screen.
struct End {
  Place place;
  double degrees = 0;  // of the normal
};

Place normal_of(const End& end) {
  const double angle = end.degrees * std::acos(-1.0) / 180;
  return {std::cos(angle), std::sin(angle)};
}

// Three times the control point next to `near`, of a curved PN triangle.
Place control(const End& near, const End& far) {
  const Place normal = normal_of(near);
  const Place along = far.place - near.place;
  const double height = along.x * normal.x + along.y * normal.y;
  return 2 * near.place + far.place - height * normal;
}

Place curve(const End& a, const End& b, double t) {
  const double s = 1 - t;
  return s * s * s * a.place + t * t * t * b.place + s * s * t * control(a, b) + s * t * t * control(b, a);
}

// The greatest distance between the curve and its 2^depth segments, at the same parameters.
double distance(const End& a, const End& b, int depth) {
  constexpr int samples = 32;
  const int segments = 1 << depth;
  double greatest = 0;
  for (int segment = 0; segment < segments; ++segment) {
    const Place begin = curve(a, b, double(segment) / segments);
    const Place end = curve(a, b, double(segment + 1) / segments);
    for (int i = 1; i < samples; ++i) {
      const double share = double(i) / samples;
      const Place off = curve(a, b, (segment + share) / segments) - ((1 - share) * begin + share * end);
      greatest = std::max(greatest, std::hypot(off.x, off.y));
    }
  }
  return greatest;
}

int least_depth(const End& a, const End& b, double error) {
  int depth = 0;
  while (depth < pool && distance(a, b, depth) > error) ++depth;
  return depth;
}

using Corners = std::array<End, 3>;
// Edge 0 is an arc, or an S.
constexpr Corners bent = {{{{-50, -40}, 110}, {{50, -40}, 70}, {{-45, 45}, 140}}};
constexpr Corners s_shaped = {{{{-50, -40}, 70}, {{50, -40}, 70}, {{-45, 45}, 140}}};

Mesh mesh_of(const Corners& corners) {
  Mesh mesh = one_triangle({6, 6, 6});
  for (std::size_t i = 0; i < 3; ++i) {
    const float scale = 2.0F / static_cast<float>(surface_size);
    const Place normal = normal_of(corners[i]);
    mesh[i].position = {scale * static_cast<float>(corners[i].place.x), scale * static_cast<float>(corners[i].place.y),
                        0, 1};
    mesh[i].normal = {static_cast<float>(normal.x), static_cast<float>(normal.y), 0};
  }
  return mesh;
}

void measure_error(GLfloat error, GLint refinement = GL_CURVED_PN_ARK) {
  refine_by_tags(pool);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, error);
  gl.Viewport(0, 0, surface_size, surface_size);
}

GLuint program(Test& t, const char* position) {
  return build_program(t, {.vertex = std::string("layout(location = 0) in vec4 position;\n"
                                                 "layout(location = 1) in vec3 normal;\n"
                                                 "layout(location = 2) in vec3 weights;\n"
                                                 "layout(location = 6) in float triangle;\n"
                                                 "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                                                 "void main() { weights_out = weights; colour = vec4(1.0);\n"
                                                 "  triangle_out = triangle + normal.z; gl_Position = ") +
                                     position + "; }\n",
                           .captured = {"gl_Position", "weights_out", "triangle_out"}});
}

Depths found(Test& t, const Corners& corners) {
  upload(mesh_of(corners));
  return depths_of(t, 1, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).front();
}

void check_depths(Test& t) {
  gl.UseProgram(program(t, "position"));
  for (const GLfloat error : {20.0F, 4.0F, 1.3F, 0.6F, 0.3F, 0.11F, 0.03F}) {
    measure_error(error);
    for (const Corners& corners : {bent, s_shaped}) {
      const Depths depths = found(t, corners);
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const int least = least_depth(corners[edge], corners[(edge + 1) % 3], double{error});
        const int depth = depths[edge];
        t.expect(depth >= least && depth <= std::min(least + 2, pool),
                 fmt::format("an error of {} pixels: edge {} has depth {}, and needs {}", error, edge, depth, least));
      }
    }
  }
}

void check_straight(Test& t) {
  gl.UseProgram(program(t, "position"));
  Corners straight = bent;
  straight[0].degrees = straight[1].degrees = 90;
  measure_error(0.01F);
  t.expect_equal(int{found(t, straight)[0]}, 0, "the depth of an edge whose normals are perpendicular to it");
  for (const GLint refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK}) {
    measure_error(0.01F, refinement);
    t.expect(found(t, bent) == Depths{0, 0, 0}, "depths of a linear refinement");
  }
}

// The vertex stage alone bends the edges, by 8 pixels: a parabola has a quarter of the factor as its height.
void check_stage(Test& t) {
  gl.UseProgram(program(t, "position + vec4(0.0, 8.0 / 64.0 * 4.0 * weights.x * weights.y, 0.0, 0.0)"));
  for (const auto& [error, depth] : {std::pair<GLfloat, int>{9, 0}, {3, 1}, {0.7F, 2}, {0.18F, 3}}) {
    measure_error(error, GL_LINEAR_INPUTS_ARK);
    const Depths depths = found(t, bent);
    const auto scale = static_cast<double>(surface_size) / 128;
    const int least = depth + static_cast<int>(std::lround(0.5 * std::log2(scale)));
    t.expect(depths[0] >= least && depths[0] <= least + 2,
             fmt::format("an error of {}: depth {}, needs {}", error, depths[0], least));
    t.expect_equal(int{depths[1]}, 0, "the depth of an edge that stays straight");
  }
}

void check_least(Test& t) {
  gl.UseProgram(program(t, "position"));
  measure_error(0.03F);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 60);
  const Depths depths = found(t, bent);
  t.expect_equal(int{depths[0]}, 1, "the depth of an edge of 100 pixels");
}

// Edges of triangles that are culled need no depth. When the other side is culled, what shows again has its depths,
// also after many repetitions.
void check_culling(Test& t, bool is_welded, bool is_reversed) {
  gl.UseProgram(program(t, "position"));
  measure_error(0.3F);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  Corners corners = bent;
  if (is_reversed) std::swap(corners[0], corners[1]);
  upload(mesh_of(corners));
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const GLuint all = count_generated(draw);
  t.expect(all > 4, "the triangle is refined");
  gl.Enable(GL_CULL_FACE);
  const Picture nothing(surface_size, surface_size);
  int shown = 0;
  for (const GLenum front : {GL_CCW, GL_CW, GL_CCW}) {
    gl.FrontFace(front);
    for (const GLenum side : {GL_FRONT, GL_FRONT_AND_BACK, GL_BACK, GL_FRONT, GL_BACK}) {
      gl.CullFace(side);
      repeat_often(draw);
      if (count_different(picture_of(draw), nothing, 8) == 0) continue;
      ++shown;
      for (int again = 0; again < 3; ++again)
        t.expect_equal(count_generated(draw), all, "triangles of a triangle that is not culled");
    }
  }
  t.expect_equal(shown, 6, "one of the sides shows");
}

void check_refused(Test& t) {
  set_everything(t);
  for (const GLfloat value : {-0.01F, -std::numeric_limits<GLfloat>::infinity(),
                              std::numeric_limits<GLfloat>::infinity(), std::numeric_limits<GLfloat>::quiet_NaN()})
    expect_refused(t, GL_INVALID_VALUE, "a number out of range",
                   [&] { gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, value); });
  expect_refused(t, GL_INVALID_VALUE, "a negative integer", [&] { gl.ARKParameteriARK(GL_SCREEN_ERROR_ARK, -1); });
  gl.ARKParameteriARK(GL_SCREEN_ERROR_ARK, 3);
  t.expect_equal(number_of(GL_SCREEN_ERROR_ARK), 3.0F, "the parameter");
}

constexpr Area screen_error_case{"ark.depth.screen_error."};

}  // namespace

Cases screen_error_cases() {
  return {screen_error_case("depths", {"11.R.4-19", "11.R.4-20", "11.R.4-21", "11.R.4-22"},
                            "An arc and an S on the screen, with seven errors; the distance is sampled on the curve.",
                            "Half of the distance; an S counts as straight; one depth for the triangle.", check_depths),
          screen_error_case("straight", {"11.R.4-23"}, "An edge whose curve is its chord; both linear refinements.",
                            "The depth of the pool; the curve of CURVED_PN_ARK for all refinements.", check_straight),
          screen_error_case("stage", {"11.R.4-20"}, "A vertex stage that bends one edge, with LINEAR_INPUTS_ARK.",
                            "Only the refinement's own curve is measured.", check_stage),
          screen_error_case("least", {"11.R.4-18"}, "With pixels too, an edge has the lesser depth.",
                            "The greater depth.", check_least),
          screen_error_case("culling", {"11.R.4-19"}, "Repeat a draw often, cull the other side, and repeat it.",
                            "Depths of a culled triangle are used when it shows again.",
                            [](Test& t) { check_culling(t, false, false); }),
          screen_error_case("culling_welded", {"11.R.4-19"}, "The same with WELD_ARK.",
                            "Depths of a culled triangle are used when it shows again.",
                            [](Test& t) { check_culling(t, true, false); }),
          screen_error_case("culling_reversed", {"11.R.4-19"}, "The same, but the triangle shows its back.",
                            "The side that was culled first counts as culled.",
                            [](Test& t) { check_culling(t, true, true); }),
          screen_error_case("refused", {"11.R.2-37", "11.R.2-39", "errors-25"},
                            "Numbers and integers out of the range.", "Negative numbers are accepted.", check_refused)};
}

}  // namespace glark::conformance
