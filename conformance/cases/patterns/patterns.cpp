// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The properties of every pattern (11.R.5), captured and judged in exact arithmetic.
#include <fmt/core.h>
#include <algorithm>
#include <set>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

using reference::Depths;
using reference::Weights;
using Tags = std::array<int, 3>;

// One coarse triangle for each triple of tags, numbered and with weights. Their places do not matter.
Mesh mesh_of(const std::vector<Tags>& triples) {
  Mesh mesh;
  for (const Tags& tags : triples) {
    const Mesh triangle =
        one_triangle({static_cast<float>(tags[0]), static_cast<float>(tags[1]), static_cast<float>(tags[2])});
    mesh.insert(mesh.end(), triangle.begin(), triangle.end());
  }
  number_triangles(mesh);
  return mesh;
}

std::vector<std::vector<Weights>> draw_patterns(Test& t, const std::vector<Tags>& triples) {
  gl.UseProgram(capture_program(t));
  upload(mesh_of(triples));
  const auto count = static_cast<GLsizei>(3 * triples.size());
  const auto vertices = capture(
      t, [count] { gl.DrawArrays(GL_TRIANGLES, 0, count); }, 120000);
  return patterns_of(t, vertices, triples.size());
}

std::vector<Tags> triples_to(int level) {
  std::vector<Tags> triples;
  for (int a = 0; a <= level; ++a)
    for (int b = 0; b <= level; ++b)
      for (int c = 0; c <= level; ++c) triples.push_back({a, b, c});
  return triples;
}

// Tags above 7 at one or two corners, such that the depth inside stays small.
std::vector<Tags> deep_triples() {
  return {{11, 11, 0}, {0, 11, 11}, {11, 0, 11}, {11, 10, 1}, {2, 10, 11}, {9, 0, 9},  {10, 3, 0},
          {0, 0, 11},  {0, 11, 0},  {11, 0, 0},  {8, 1, 2},   {7, 8, 2},   {4, 8, 10}, {5, 11, 3}};
}

enum class Interior { minimum, smooth };

void expect_patterns(Test& t, const std::vector<Tags>& triples, Interior interior) {
  const auto patterns = draw_patterns(t, triples);
  for (std::size_t i = 0; i < triples.size(); ++i) {
    const Depths depths = reference::edge_depths(triples[i]);
    const std::string fault = interior == Interior::minimum ? reference::fault_of_minimum(patterns[i], depths)
                                                            : reference::fault_of_pattern(patterns[i], depths);
    t.expect(fault.empty(), "the pattern of depths " + text_of(depths) + ": " + fault);
  }
}

Case pattern_case(const std::string& leaf, std::vector<std::string> clauses, const std::string& plan,
                  std::vector<Tags> triples, Interior interior, GLuint pool_level) {
  return {.name = "ark.pattern." + leaf,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong =
              "Missing or doubled triangles, a vertex inside an edge, flipped triangles, misplaced vertices, the "
              "pattern of the depths in another order.",
          .check = [triples = std::move(triples), interior, pool_level](Test& t) {
            refine_by_tags(pool_level);
            gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK,
                                interior == Interior::minimum ? GL_MINIMUM_INTERIOR_ARK : GL_SMOOTH_INTERIOR_ARK);
            expect_patterns(t, triples, interior);
          }};
}

void check_uniform_count(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle());
  for (int level = 0; level <= 4; ++level) {
    refine_uniformly(static_cast<GLuint>(level));
    const auto vertices = capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    t.expect_equal(vertices.size(), std::size_t{3} << (2 * level), fmt::format("vertices at depth {}", level));
  }
}

void check_unrefined_count(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U, "vertices of the coarse triangle");
}

// Every pattern with three equal depths that is small enough to capture quickly.
void check_uniform(Test& t, GLenum interior, GLenum source) {
  gl.UseProgram(capture_program(t));
  Mesh mesh = one_triangle();
  for (int level = 0; level <= 7; ++level) {
    for (MeshVertex& vertex : mesh) vertex.tag = static_cast<float>(level);
    upload(mesh);
    refine_uniformly(static_cast<GLuint>(level));
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(interior));
    const auto weights = weights_of(t, capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }));
    const std::string fault = reference::fault_of_minimum(weights, {level, level, level});
    t.expect(fault.empty(), fmt::format("uniform depth {}: {}", level, fault));
  }
}

// The finest pattern of a pool is counted, not captured.
void check_deepest(Test& t, GLuint level) {
  GLint deepest = 0;
  gl.GetIntegerv(GL_MAX_DEPTH_ARK, &deepest);
  t.require(deepest >= 11, "MAX_DEPTH_ARK is at least 11");
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(level);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  gl.Disable(GL_RASTERIZER_DISCARD);
  GLuint count = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  gl.DeleteQueries(1, &query);
  t.expect_equal(count, 1U << (2 * level), fmt::format("triangles at uniform depth {}", level));
}

// The levels of a smaller pool have the same patterns as those of a greater pool.
void check_small_pools(Test& t) {
  for (int level = 0; level <= 5; ++level) {
    refine_by_tags(static_cast<GLuint>(level));
    expect_patterns(t, {{level, 0, level}, {level, level, level}, {0, level, level / 2}}, Interior::minimum);
  }
}

void check_unchanged(Test& t) {
  refine_by_tags(4);
  const std::vector<Tags> triples = {{4, 0, 1}, {3, 3, 3}, {1, 4, 2}, {0, 3, 4}};
  const auto before = draw_patterns(t, triples);
  for (const GLenum interior : {GL_SMOOTH_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK}) {
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(interior));
    draw_patterns(t, {{2, 4, 4}, {4, 4, 4}});  // with other levels in between
  }
  const std::vector<Tags> turned = {triples[3], triples[1], triples[0], triples[2]};
  const auto after = draw_patterns(t, turned);
  const std::array<std::size_t, 4> was = {3, 1, 0, 2};
  for (std::size_t i = 0; i < was.size(); ++i)
    t.expect(after[i] == before[was[i]], "the triangles of a pattern, and their corners, keep their order");
}

// Each weight is a multiple of 1 / 2^d, where d is the greatest depth of the edges.
void check_multiples(Test& t) {
  refine_by_tags(5);
  const std::vector<Tags> triples = triples_to(5);
  const auto patterns = draw_patterns(t, {triples.begin(), triples.begin() + 150});
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const Depths depths = reference::edge_depths(triples[i]);
    const std::int64_t step = reference::unit >> std::max({depths[0], depths[1], depths[2]});
    bool are_multiples = true;
    for (const Weights& at : patterns[i])
      are_multiples = are_multiples && at.w % step == 0 && at.u % step == 0 && at.v % step == 0;
    t.expect(are_multiples && !patterns[i].empty(), "weights of depths " + text_of(depths) + " are multiples");
  }
}

// Each case pairs three tags with every fourth tag. Where two edges meet, both triangles have the same vertices.
void check_neighbours(Test& t) {
  refine_by_tags(3);
  std::vector<Tags> triples;
  for (const Tags& tags : triples_to(3)) {
    triples.push_back(tags);
    triples.push_back({tags[1], tags[0], (tags[2] + 2) % 4});  // on the other side of edge 0, rotated
  }
  const auto patterns = draw_patterns(t, triples);
  for (std::size_t i = 0; i < triples.size(); i += 2) {
    std::set<Weights> here;
    std::set<Weights> there;
    for (const Weights& at : patterns[i])
      if (at.v == 0) here.insert(at);
    for (const Weights& at : patterns[i + 1])
      if (at.v == 0) there.insert({at.u, at.w, 0});
    t.expect(here == there, "both sides of an edge of depths " + text_of(reference::edge_depths(triples[i])));
  }
}

Cases uniform_cases() {
  Cases cases;
  for (const bool is_smooth : {false, true})
    for (const bool by_tags : {false, true})
      cases.push_back(
          {.name = std::string("ark.pattern.uniform.") + (by_tags ? "tags_" : "level_") +
                   (is_smooth ? "smooth" : "minimum"),
           .clauses = {"11.R.5-10", "11.R.5-11", "11.R.5-15"},
           .plan = "Capture one triangle with three equal depths, 0 to 7. The vertices and the shape of every triangle "
                   "are known exactly.",
           .wrong = "A missing or flipped triangle; triangles split along another diagonal; additional vertices with "
                    "the smooth interior.",
           .control = check_unrefined_count,
           .check = [is_smooth, by_tags](Test& t) {
             check_uniform(t, is_smooth ? GL_SMOOTH_INTERIOR_ARK : GL_MINIMUM_INTERIOR_ARK,
                           by_tags ? GL_DEPTH_TAG_ARK : GL_UNIFORM_DEPTH_ARK);
           }});
  return cases;
}

}  // namespace

Cases patterns_cases() {
  const std::vector<std::string> every = {"11.R.5-1", "11.R.5-2", "11.R.5-4", "11.R.5-5", "11.R.5-6",
                                          "11.R.5-7", "11.R.5-8", "11.R.5-9", "11.R.3-4", "11.R.4-2"};
  std::vector<std::string> minimum = every;
  minimum.insert(minimum.end(), {"11.R.5-12", "11.R.5-13"});
  std::vector<std::string> smooth = every;
  smooth.emplace_back("11.R.5-14");
  Cases cases = uniform_cases();
  const std::string all = "Capture a triangle for every triple of tags from 0 to 4 and judge each pattern exactly.";
  const std::string deep =
      "Capture triples of tags up to 11 whose inside stays coarse, and judge each pattern exactly.";
  cases.push_back(pattern_case("triples.minimum", minimum, all, triples_to(4), Interior::minimum, 4));
  cases.push_back(pattern_case("triples.smooth", smooth, all, triples_to(4), Interior::smooth, 4));
  cases.push_back(pattern_case("deep.minimum", minimum, deep, deep_triples(), Interior::minimum, 11));
  cases.push_back(pattern_case("deep.smooth", smooth, deep, deep_triples(), Interior::smooth, 11));
  cases.push_back({.name = "ark.pattern.uniform.count",
                   .clauses = {"11.R.5-11"},
                   .plan = "Capture one triangle at uniform depths 0 to 4 and count.",
                   .wrong = "2^d or 3^d triangles; one level too few.",
                   .control = check_unrefined_count,
                   .check = check_uniform_count});
  cases.push_back({.name = "ark.pattern.uniform.deep_count",
                   .clauses = {"11.R.5-11"},
                   .plan = "Count the primitives of one triangle at uniform depth 9.",
                   .wrong = "A limit on triangles; numbers of 16 bits.",
                   .control = check_unrefined_count,
                   .check = [](Test& t) { check_deepest(t, 9); }});
  for (const GLuint level : {10U, 11U})
    cases.push_back({.name = fmt::format("ark.pattern.uniform.deep_count_{}", level),
                     .clauses = {"11.R.5-11"},
                     .plan = fmt::format("Count the primitives of one triangle at a uniform depth of {}.", level),
                     .wrong = "A limit on triangles; a product of 16-bit numbers; a record that is too small.",
                     .control = check_unrefined_count,
                     .check = [level](Test& t) { check_deepest(t, level); }});
  cases.push_back({.name = "ark.pattern.small_pools",
                   .clauses = {"11.R.5-1", "11.R.5-12"},
                   .plan = "Judge patterns with the greatest depth of pools of level 0 to 5.",
                   .wrong = "The last level of a pool is missing; a pool keeps the patterns of another.",
                   .check = check_small_pools});
  cases.push_back(
      {.name = "ark.pattern.order.unchanged",
       .clauses = {"11.R.5-16", "11.R.5-17"},
       .plan = "Capture four patterns, draw others, capture the four again in another order of coarse triangles.",
       .wrong = "Another order of triangles or of corners the second time.",
       .check = check_unchanged});
  cases.push_back({.name = "ark.pattern.minimum.multiples",
                   .clauses = {"11.R.5-13"},
                   .plan = "Check every weight of 150 patterns up to level 5.",
                   .wrong = "Weights such as 1/3 inside.",
                   .check = check_multiples});
  cases.push_back(
      {.name = "ark.pattern.neighbours",
       .clauses = {"11.R.5-5", "11.R.8-4"},
       .plan = "Compare the vertices along the common edge of two triangles, rotated, for all pairs of tags.",
       .wrong = "The greater or the lesser tag for an edge; an edge takes the depth of another edge.",
       .check = check_neighbours});
  return cases;
}

}  // namespace glark::conformance
