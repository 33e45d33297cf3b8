// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_GEOMORPH_ARK (section 11.R.14), read back through transform feedback. There are no cracks at any fraction. Whole
// depths have the same vertices as without geomorphing. The surface is a continuous function of the tags. The control
// for continuity is the same path of tags without geomorphing, where the surface jumps.
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 6;

struct Way {
  Language language;
  GLenum refinement;
};

std::string name_of(const testing::TestParamInfo<Way>& info) {
  return std::string(info.param.language == Language::glsl_450_core ? "core" : "glsl120") +
         (info.param.refinement == GL_CURVED_PN_ARK        ? "Curved"
          : info.param.refinement == GL_PHONG_ARK          ? "Phong"
          : info.param.refinement == GL_LINEAR_OUTPUTS_ARK ? "Outputs"
                                                           : "Inputs");
}

struct Corner {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  GLfloat tag;
};

constexpr Corner corner_a{{0.13F, -0.71F, 0.33F}, {0.2F, -0.5F, 0.9F}, 0};
constexpr Corner corner_b{{1.07F, 0.59F, -0.41F}, {0.7F, 0.3F, 1.1F}, 0};
constexpr Corner corner_c{{-0.93F, 0.77F, 0.21F}, {-0.6F, 0.4F, 0.8F}, 0};
constexpr Corner corner_d{{1.31F, -1.03F, -0.17F}, {0.5F, -0.9F, 0.7F}, 0};

// With three parents, the number is a mix of equal numbers in thirds, so it is rounded.
std::size_t triangle_of(const RefinedVertex& vertex) { return static_cast<std::size_t>(std::lround(vertex.triangle)); }

Corner tagged(Corner corner, GLfloat tag) {
  corner.tag = tag;
  return corner;
}

struct TaggedMesh {
  std::vector<CurvedVertex> vertices;
  std::vector<GLfloat> tags;

  // Weights belong to the corners in this order, for every `rotation`.
  void add(const std::array<Corner, 3>& corners, int rotation, std::size_t number) {
    for (int k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>((k + rotation) % 3);
      CurvedVertex vertex{corners[corner].position, corners[corner].normal, {}, static_cast<GLfloat>(number), 0};
      vertex.weights[corner] = 1;
      vertices.push_back(vertex);
      tags.push_back(corners[corner].tag);
    }
  }
};

class Geomorph : public testing::TestWithParam<Way> {
 protected:
  Geomorph() {
    glARKinit(level);
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(GetParam().refinement));
    glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(link_curved_program(GetParam().language));
  }
  static std::vector<RefinedVertex> refine(const TaggedMesh& mesh, std::size_t most = 600000) {
    upload(mesh.vertices);
    make_buffer(GL_ARRAY_BUFFER, mesh.tags);
    glDepthTagPointerARK(GL_FLOAT, 0, nullptr);
    const auto count = static_cast<GLsizei>(mesh.vertices.size());
    return capture_refined(most, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
  }
  OsmesaContext context_{GetParam().language == Language::glsl_450_core ? Profile::core : Profile::compatibility};
};

class GeomorphCurved : public Geomorph {};

INSTANTIATE_TEST_SUITE_P(All, Geomorph,
                         testing::Values(Way{Language::glsl_120, GL_LINEAR_INPUTS_ARK},
                                         Way{Language::glsl_120, GL_CURVED_PN_ARK},
                                         Way{Language::glsl_450_core, GL_LINEAR_INPUTS_ARK},
                                         Way{Language::glsl_450_core, GL_LINEAR_OUTPUTS_ARK},
                                         Way{Language::glsl_450_core, GL_PHONG_ARK},
                                         Way{Language::glsl_450_core, GL_CURVED_PN_ARK}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(All, GeomorphCurved,
                         testing::Values(Way{Language::glsl_120, GL_CURVED_PN_ARK},
                                         Way{Language::glsl_450_core, GL_CURVED_PN_ARK},
                                         Way{Language::glsl_450_core, GL_LINEAR_INPUTS_ARK}),
                         name_of);

// Both triangles of a pair share the edge A-B. Their third corners differ, and so do all inner vertices.
TEST_P(Geomorph, SharedEdgesHaveTheSameBits) {
  constexpr std::size_t pairs = 400;
  std::mt19937 random(5);
  const auto tag = [&] { return static_cast<GLfloat>(random() % (64 * level + 1)) / 64; };
  for (int way = 0; way < 6; ++way) {
    TaggedMesh mesh;
    std::vector<std::size_t> segments;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const Corner a = tagged(corner_a, tag());
      const Corner b = tagged(corner_b, pair % 3 == 0 ? a.tag : tag());
      const bool flipped = random() % 2 != 0;
      mesh.add({a, b, tagged(corner_c, tag())}, way % 3, 2 * pair);
      const Corner other = tagged(corner_d, tag());
      mesh.add({flipped ? b : a, flipped ? a : b, other}, way / 3 + static_cast<int>(random() % 2), 2 * pair + 1);
      segments.push_back(std::size_t{1} << static_cast<int>(std::ceil(std::floor(64 * (a.tag + b.tag) / 2) / 64)));
    }
    std::vector<std::set<PositionBits>> on_edge(2 * pairs);
    for (const RefinedVertex& vertex : refine(mesh)) {
      if (vertex.weights[2] == 0) on_edge[triangle_of(vertex)].insert(bits_of(vertex));
    }
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      EXPECT_EQ(on_edge[2 * pair], on_edge[2 * pair + 1]) << pair;
      EXPECT_EQ(on_edge[2 * pair].size(), segments[pair] + 1) << pair;
    }
  }
}

TEST_P(Geomorph, ClosedMeshesStayClosed) {
  std::mt19937 random(7);
  for (int round = 0; round < 6; ++round) {
    const Mesh mesh = round == 1 ? tetrahedron() : icosahedron();
    std::vector<GLfloat> tag(mesh.positions.size());
    for (GLfloat& value : tag) value = static_cast<GLfloat>(random() % (64 * level)) / 64;
    TaggedMesh vertices;
    for (const auto& triangle : mesh.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = {mesh.positions[triangle[k]], mesh.positions[triangle[k]], tag[triangle[k]]};
      }
      vertices.add(corners, static_cast<int>(random() % 3), 0);
    }
    const std::vector<RefinedVertex> refined = refine(vertices);
    EXPECT_GT(refined.size(), 3 * mesh.triangles.size());
    EXPECT_EQ(open_edges(refined), 0);
  }
}

// The inner points that only geomorphing has: the centre of a shallow triangle, and the interior that a single shallow
// edge removes without geomorphing.
std::size_t added_points(GLfloat a, GLfloat b, GLfloat c) {
  std::array<int, 3> depths{static_cast<int>(a + b) / 2, static_cast<int>(b + c) / 2, static_cast<int>(c + a) / 2};
  std::sort(depths.begin(), depths.end());
  const int interior = std::max(depths[0], std::min(depths[1], 3));
  if (interior < 2) return 1;
  return interior == depths[0] ? 0U : static_cast<std::size_t>(((1 << interior) - 1) * ((1 << interior) - 2) / 2);
}

TEST_P(Geomorph, WholeDepthsHaveTheSameVertices) {
  TaggedMesh mesh;
  std::vector<std::size_t> added;
  std::size_t count = 0;
  for (int a = 0; a <= 6; a += 2) {
    for (int b = 0; b <= 6; b += 2) {
      for (int c = 0; c <= 6; c += 2) {
        mesh.add({tagged(corner_a, static_cast<GLfloat>(a)), tagged(corner_b, static_cast<GLfloat>(b)),
                  tagged(corner_c, static_cast<GLfloat>(c))},
                 static_cast<int>(count % 3), count);
        added.push_back(added_points(static_cast<GLfloat>(a), static_cast<GLfloat>(b), static_cast<GLfloat>(c)));
        ++count;
      }
    }
  }
  using Weights = std::array<GLfloat, 3>;
  std::vector<std::map<Weights, PositionBits>> morphed(count);
  std::vector<std::map<Weights, PositionBits>> plain(count);
  for (const RefinedVertex& vertex : refine(mesh)) {
    morphed[triangle_of(vertex)][vertex.weights] = bits_of(vertex);
  }
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_FALSE);
  for (const RefinedVertex& vertex : refine(mesh)) {
    plain[triangle_of(vertex)][vertex.weights] = bits_of(vertex);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& [weights, position] : plain[i]) {
      const auto found = morphed[i].find(weights);
      ASSERT_NE(found, morphed[i].end()) << i;
      EXPECT_EQ(found->second, position) << i;
    }
    EXPECT_LE(morphed[i].size(), plain[i].size() + added[i]) << i;
  }
}

struct Surface {
  std::vector<std::array<RefinedVertex, 3>> triangles;
  double area = 0;
  double smallest = 1;

  void add(const RefinedVertex& p, const RefinedVertex& q, const RefinedVertex& r) {
    const double size = double{q.weights[0] - p.weights[0]} * double{r.weights[1] - p.weights[1]} -
                        double{q.weights[1] - p.weights[1]} * double{r.weights[0] - p.weights[0]};
    area += size;
    smallest = std::min(smallest, size);
    triangles.push_back({p, q, r});
  }
  // The position over given barycentrics.
  std::array<double, 3> at(const std::array<double, 3>& weights) const {
    double least_outside = 1e9;
    std::array<double, 3> best{};
    for (const auto& [p, q, r] : triangles) {
      const auto cross = [&](const RefinedVertex& a, const RefinedVertex& b) {
        return (double{b.weights[0]} - double{a.weights[0]}) * (weights[1] - double{a.weights[1]}) -
               (double{b.weights[1]} - double{a.weights[1]}) * (weights[0] - double{a.weights[0]});
      };
      const std::array<double, 3> inside{cross(q, r), cross(r, p), cross(p, q)};
      const double sum = inside[0] + inside[1] + inside[2];
      if (sum < 1e-9) continue;
      const double outside = -std::min({inside[0], inside[1], inside[2]}) / sum;
      if (outside >= least_outside) continue;
      least_outside = outside;
      for (std::size_t k = 0; k < 3; ++k) {
        best[k] = (inside[0] * double{p.position[k]} + inside[1] * double{q.position[k]} +
                   inside[2] * double{r.position[k]}) /
                  sum;
      }
    }
    return best;
  }
};

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::vector<Surface> by_triangle(const std::vector<RefinedVertex>& vertices, std::size_t count) {
  std::vector<Surface> surfaces(count);
  for (std::size_t i = 0; i < vertices.size(); i += 3)
    surfaces[triangle_of(vertices[i])].add(vertices[i], vertices[i + 1], vertices[i + 2]);
  return surfaces;
}

std::vector<std::array<double, 3>> sample_points() {
  std::vector<std::array<double, 3>> points;
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    double u = static_cast<double>(random() % 10007) / 10007;
    double v = static_cast<double>(random() % 10007) / 10007;
    if (i % 3 == 0) v *= 0.02;  // near an edge
    if (i % 6 == 0) u *= 0.02;  // near a corner
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    points.push_back({1 - u - v, u, v});
  }
  return points;
}

struct Motion {
  double largest = 0;  // of one step
  double whole = 0;    // from the first step to the last
};

// Measures how far the surface moves over fixed points while the tags follow a path.
Motion motion_of(const std::vector<Surface>& path) {
  Motion motion;
  for (const auto& point : sample_points()) {
    const auto first = path.front().at(point);
    auto before = first;
    for (const Surface& surface : path) {
      const auto now = surface.at(point);
      motion.largest = std::max(motion.largest, distance(before, now));
      motion.whole = std::max(motion.whole, distance(first, now));
      before = now;
    }
  }
  return motion;
}

TEST_P(GeomorphCurved, TheSurfaceIsContinuousInTheTags) {
  constexpr std::size_t steps = 64 * 4 + 1;
  struct Path {
    GLfloat from[3], to[3];
  };
  const Path paths[] = {{{0, 0, 0}, {4, 4, 4}},       {{0, 0, 0}, {4, 0, 0}},          {{4, 4, 0}, {4, 4, 4}},
                        {{0, 2.5F, 4}, {4, 2.5F, 0}}, {{3.3F, 0, 1}, {3.3F, 4, 1}},    {{4, 1, 1}, {0, 1, 1}},
                        {{1.5F, 4, 4}, {5.5F, 4, 4}}, {{5, 2, 0.3F}, {1, 6, 4.3F}},    {{0, 0, 2}, {0, 0, 6}},
                        {{6, 0, 0}, {6, 4, 0}},       {{0.6F, 0.9F, 6}, {4.6F, 0, 6}}, {{6, 0, 0.5F}, {2, 0, 0.5F}}};
  for (const Path& path : paths) {
    SCOPED_TRACE(testing::Message() << "from " << path.from[0] << ' ' << path.from[1] << ' ' << path.from[2]);
    Motion motions[2];
    for (const bool morphs : {true, false}) {
      glARKParameteriARK(GL_GEOMORPH_ARK, morphs ? GL_TRUE : GL_FALSE);
      TaggedMesh mesh;
      for (std::size_t i = 0; i < steps; ++i) {
        std::array<Corner, 3> corners{corner_a, corner_b, corner_c};
        for (std::size_t k = 0; k < 3; ++k) {
          const GLfloat along = static_cast<GLfloat>(i) / static_cast<GLfloat>(steps - 1);
          corners[k].tag = path.from[k] + along * (path.to[k] - path.from[k]);
        }
        mesh.add(corners, 0, i);
      }
      const std::vector<Surface> surfaces = by_triangle(refine(mesh), steps);
      for (std::size_t i = 0; i < steps; ++i) {
        EXPECT_NEAR(surfaces[i].area, 1.0, 1e-4) << i;
        EXPECT_GT(surfaces[i].smallest, -1e-7) << "a triangle flips at step " << i;
      }
      motions[morphs ? 0 : 1] = motion_of(surfaces);
    }
    // A level has 64 steps, and the first levels move most. A pop would move a whole level at once.
    EXPECT_LT(motions[0].largest, 0.08 * motions[0].whole);
    EXPECT_GT(motions[1].largest, 0.25 * motions[1].whole);
  }
}

// Between two triples of whole depths, the surface is nowhere much farther from the limit (the deepest level) than one
// of the two surfaces without GL_GEOMORPH_ARK. It may be somewhat farther where it has a single inner point and they
// have no inner point.
TEST_P(GeomorphCurved, FractionsAreAsGoodAsTheWholeDepthsAbout) {
  const auto points = sample_points();
  const auto surfaces_of = [](bool morphs, std::array<Corner, 3> corners, std::size_t moved, std::size_t count) {
    glARKParameteriARK(GL_GEOMORPH_ARK, morphs ? GL_TRUE : GL_FALSE);
    TaggedMesh mesh;
    const GLfloat from = corners[moved].tag;
    for (std::size_t i = 0; i < count; ++i) {
      corners[moved].tag = from + 2 * static_cast<GLfloat>(i) / static_cast<GLfloat>(count - 1);
      mesh.add(corners, 0, i);
    }
    return by_triangle(refine(mesh), count);
  };
  const std::array<Corner, 3> deepest{tagged(corner_a, level), tagged(corner_b, level), tagged(corner_c, level)};
  const Surface limit = surfaces_of(false, deepest, 0, 2)[0];
  const auto error_of = [&](const Surface& surface) {
    double error = 0;
    for (const auto& point : points) error = std::max(error, distance(surface.at(point), limit.at(point)));
    return error;
  };
  std::mt19937 random(13);
  for (int path = 0; path < 24; ++path) {
    const auto tag = [&] { return static_cast<GLfloat>(2 * (random() % 3)); };
    std::array<Corner, 3> corners{tagged(corner_a, tag()), tagged(corner_b, tag()), tagged(corner_c, tag())};
    if (path % 2 == 0) corners[0].tag = corners[1].tag = 0;  // beside deep edges
    const std::size_t moved = random() % 3;
    const double share = added_points(corners[0].tag, corners[1].tag, corners[2].tag) == 1 ? 1.7 : 1.2;
    const std::vector<Surface> whole = surfaces_of(false, corners, moved, 2);
    const double bound = share * std::max(error_of(whole[0]), error_of(whole[1])) + 1e-4;
    for (const Surface& surface : surfaces_of(true, corners, moved, 9)) {
      EXPECT_LE(error_of(surface), bound)
          << corners[0].tag << ' ' << corners[1].tag << ' ' << corners[2].tag << ", " << moved << " moves";
    }
  }
}

// The point in the middle of a triangle without an interior: s A + (1 - s) / 3 (A_0 + A_1 + A_2).
TEST_P(GeomorphCurved, TheMiddleGoesByTheDeepestEdge) {
  TaggedMesh mesh;
  mesh.add({tagged(corner_a, 0), tagged(corner_b, 1.75F), tagged(corner_c, 1)}, 0, 0);     // 0.5, 0.875 and 1.375
  mesh.add({tagged(corner_a, 0), tagged(corner_b, 0.5F), tagged(corner_c, 0.25F)}, 0, 1);  // 0.125, 0.25 and 0.375
  std::array<std::map<std::array<GLfloat, 3>, std::array<GLfloat, 4>>, 2> vertices;
  for (const RefinedVertex& vertex : refine(mesh)) vertices[triangle_of(vertex)][vertex.weights] = vertex.position;
  std::array<std::vector<std::array<GLfloat, 4>>, 2> middles;
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& [weights, position] : vertices[i]) {
      if (*std::min_element(weights.begin(), weights.end()) > 0) middles[i].push_back(position);
    }
    ASSERT_EQ(middles[i].size(), 1U);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const GLfloat corners = vertices[1][{1, 0, 0}][k] + vertices[1][{0, 1, 0}][k] + vertices[1][{0, 0, 1}][k];
    EXPECT_NEAR(middles[1][0][k], 0.375F * middles[0][0][k] + 0.625F / 3 * corners, 1e-5F);
  }
}

TEST_P(GeomorphCurved, ACurrentTagMayBeAFraction) {
  TaggedMesh mesh;
  mesh.add({tagged(corner_a, 2.5F), tagged(corner_b, 2.5F), tagged(corner_c, 2.5F)}, 0, 0);
  std::set<PositionBits> by_array;
  for (const RefinedVertex& vertex : refine(mesh)) by_array.insert(bits_of(vertex));
  glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  GLint attribute = 0;
  glGetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  glVertexAttrib1f(static_cast<GLuint>(attribute), 2.5F);
  std::set<PositionBits> by_value;
  for (const RefinedVertex& vertex : capture_refined(10000, [] { glDrawArrays(GL_TRIANGLES, 0, 3); })) {
    by_value.insert(bits_of(vertex));
  }
  EXPECT_EQ(by_array, by_value);
}

TEST_P(Geomorph, TilesAreClosedToo) {
  glARKinit(8);
  std::mt19937 random(3);
  const Mesh mesh = tetrahedron();
  std::vector<GLfloat> tag(mesh.positions.size());
  for (GLfloat& value : tag) value = 5.5F + static_cast<GLfloat>(random() % 128) / 64;
  TaggedMesh vertices;
  for (const auto& triangle : mesh.triangles) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {mesh.positions[triangle[k]], mesh.positions[triangle[k]], tag[triangle[k]]};
    }
    vertices.add(corners, 0, 0);
  }
  EXPECT_EQ(open_edges(refine(vertices)), 0);
}

// A camera that comes nearer step by step: depths are measured, and edges meet at every fraction.
TEST(GeomorphMeasured, EdgesMeetAndFractionsAppear) {
  const OsmesaContext context(Profile::core);
  glViewport(0, 0, picture_size, picture_size);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  const GLuint program = link_measured_program();
  glUseProgram(program);
  glUniform1f(glGetUniformLocation(program, "bend"), 0.2F);
  measure_depths(5, 4, 3);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  std::vector<CurvedVertex> vertices;
  const Mesh mesh = icosahedron();
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      vertices.push_back({mesh.positions[triangle[k]], mesh.positions[triangle[k]], {}, 0, 0});
  }
  upload(vertices);
  const auto refine = [&](bool morphs) {
    glARKParameteriARK(GL_GEOMORPH_ARK, morphs ? GL_TRUE : GL_FALSE);
    return capture_refined(200000, [&] { glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size())); });
  };
  int moved = 0;
  for (int step = 0; step < 12; ++step) {
    set_view(program, perspective(12.0F - 0.7F * static_cast<GLfloat>(step), 0.3F));
    const std::vector<RefinedVertex> morphed = refine(true);
    EXPECT_EQ(open_edges(morphed), 0) << step;
    std::set<PositionBits> plain;
    for (const RefinedVertex& vertex : refine(false)) plain.insert(bits_of(vertex));
    for (const RefinedVertex& vertex : morphed) moved += plain.count(bits_of(vertex)) == 0 ? 1 : 0;
  }
  EXPECT_GT(moved, 1000);
}

}  // namespace
}  // namespace glark::core::test
