// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14) at every level up to the deepest one. The outputs change at random from vertex to vertex, so that
// a wrong neighbour shows where a smooth output would hide it.
#include <fmt/core.h>

#include <cmath>
#include <set>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/geomorph.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct DeepVertex {
  Vec4 position;
  Vec2 place;    // x: the number of the vertex on the deep edge; y is 0 there
  Vec4 outputs;  // integers below 64, if the vertex stage is executed there
};

GLuint deep_program(Test& t) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 4) in vec2 place; out vec2 place_out; out vec4 outputs; out vec4 colour;\n"
                    "void main() { int k = int(place.x); place_out = place; colour = abs(vec4(normal, 1.0));\n"
                    "  outputs = vec4((ivec4(7, 3, 5, 11) * k * k + ivec4(3, 9, 1, 4) * k + ivec4(1, 2, 3, 4)) & 63);\n"
                    "  gl_Position = position; }\n",
          .captured = {"gl_Position", "place_out", "outputs"}});
}

Vec4 outputs_at(int k) {
  const int squares[] = {7, 3, 5, 11};
  const int factors[] = {3, 9, 1, 4};
  Vec4 outputs{};
  for (int i = 0; i < 4; ++i)
    outputs[static_cast<std::size_t>(i)] = static_cast<float>((squares[i] * k * k + factors[i] * k + i + 1) & 63);
  return outputs;
}

using Numbered = std::pair<float, Vec4>;

// (11.R.8). s is a multiple of 1/64, so that all values are exact.
std::set<Numbered> expected_of(double depth) {
  const int whole = static_cast<int>(std::ceil(depth));
  const auto s = static_cast<float>(depth - whole + 1);
  std::set<Numbered> expected;
  for (int k = 0; k <= 1 << whole; ++k) {
    Vec4 outputs = outputs_at(k);
    if (k % 2 != 0 && whole > 0) {
      const Vec4 before = outputs_at(k - 1);
      const Vec4 after = outputs_at(k + 1);
      for (std::size_t i = 0; i < 4; ++i)
        outputs[i] = ((1 - s) / 2 * before[i] + (1 - s) / 2 * after[i]) + s * outputs[i];
    }
    expected.emplace(static_cast<float>(k), outputs);
  }
  return expected;
}

// Edge `edge` has this depth; the other two have half of it, because the third corner has no tag.
void expect_deep_edge(Test& t, int edge, double depth, GLenum refinement) {
  const auto steps = static_cast<float>(1 << static_cast<int>(std::ceil(depth)));
  const auto tag = static_cast<float>(depth);
  const auto from = static_cast<std::size_t>(edge);
  std::array<float, 3> tags = {tag, tag, tag};
  tags[(from + 2) % 3] = 0;
  Mesh mesh = one_triangle(tags);
  mesh[from].texture = {0, 0};
  mesh[(from + 1) % 3].texture = {steps, 0};
  mesh[(from + 2) % 3].texture = {0, 1};
  upload(mesh);
  morph_by_tags(static_cast<GLuint>(std::ceil(depth)), refinement);
  std::set<Numbered> found;
  for (const DeepVertex& vertex : capture_as<DeepVertex>(t, 100000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }))
    if (vertex.place[1] == 0) found.emplace(vertex.place[0], vertex.outputs);
  const std::set<Numbered> expected = expected_of(depth);
  const std::string what = fmt::format("edge {} of depth {}", edge, depth);
  if (!t.expect_equal(found.size(), expected.size(), what + ": vertices")) return;
  t.expect(found == expected, what + ": the outputs are those of (11.R.8), by bits");
}

void check_deep(Test& t, GLenum refinement) {
  gl.UseProgram(deep_program(t));
  const int deepest = integer_of(GL_MAX_DEPTH_ARK);
  for (int level = 1; level <= std::min(deepest, 14); ++level)
    for (int edge = 0; edge < 3; ++edge)
      for (const double less : {0.5, 0.0, 1.0 / 64, 63.0 / 64})
        if (less == 0.5 || level > deepest - 2) expect_deep_edge(t, edge, level - less, refinement);
  t.expect_no_error("the draws");
}

}  // namespace

Cases deep_edges_cases() {
  Cases cases;
  for (const auto& [leaf, refinement] :
       {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK}, {"curved", GL_CURVED_PN_ARK}})
    cases.push_back({.name = std::string("ark.geomorph.deep.") + leaf,
                     .clauses = {"11.R.14-10", "11.R.14-11", "11.R.14-5"},
                     .plan = "Edges of every depth up to the deepest one. Outputs differ much from vertex to vertex.",
                     .wrong = "At the deepest level, the vertices between which a vertex moves are not its neighbours.",
                     .check = [mode = refinement](Test& t) { check_deep(t, mode); }});
  return cases;
}

}  // namespace glark::conformance
