// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_POLYGON_CENTROID_ARK (11.R.3, 11.R.4), read back through transform feedback.
//
// Plan: "weights" hold the place in the plane of the polygon. The third weight is 0 at the ends of one edge and 1
// elsewhere, so the refined vertices of this edge are those where it is 0. They have the same bits as those of a
// GL_TRIANGLES neighbour. The control is GL_POLYGON_TRIANGLES_ARK, which has no vertex at the centroid and another
// number of triangles.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tests/core/support/curved_program.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 5;

struct Shape {
  const char* name;
  GLenum mode;
  std::vector<std::array<GLfloat, 2>> places;   // in the order of the draw
  std::vector<std::vector<std::size_t>> rings;  // the boundary of each polygon
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> result = {
      {"quad", GL_QUADS, {{-0.9F, -0.7F}, {0.8F, -0.9F}, {0.9F, 0.6F}, {-0.6F, 0.8F}}, {{0, 1, 2, 3}}},
      {"two_quads",
       GL_QUADS,
       {{-0.9F, -0.7F},
        {0.1F, -0.9F},
        {0, 0.6F},
        {-0.6F, 0.8F},
        {0.2F, -0.5F},
        {0.9F, -0.4F},
        {0.8F, 0.3F},
        {0.3F, 0.4F}},
       {{0, 1, 2, 3}, {4, 5, 6, 7}}},
      {"quad_strip",
       GL_QUAD_STRIP,
       {{-0.9F, 0.8F}, {-0.8F, -0.7F}, {0.1F, 0.9F}, {0, -0.9F}, {0.8F, 0.6F}, {0.9F, -0.8F}},
       {{0, 1, 3, 2}, {2, 3, 5, 4}}},
      {"triangle", GL_POLYGON, {{-0.9F, -0.7F}, {0.8F, -0.9F}, {0.1F, 0.7F}}, {{0, 1, 2}}},
      {"pentagon",
       GL_POLYGON,
       {{-0.5F, -0.8F}, {0.6F, -0.9F}, {0.9F, 0.2F}, {0.1F, 0.9F}, {-0.8F, 0.3F}},
       {{0, 1, 2, 3, 4}}},
      {"hexagon",
       GL_POLYGON,
       {{-0.9F, 0.1F}, {-0.5F, -0.8F}, {0.4F, -0.9F}, {0.9F, -0.1F}, {0.5F, 0.8F}, {-0.4F, 0.9F}},
       {{0, 1, 2, 3, 4, 5}}},
  };
  return result;
}

enum class Path { arrays, elements, immediate, list };

struct Way {
  Shape shape;
  Path path;
  GLenum refinement = GL_LINEAR_INPUTS_ARK;
  GLenum convention = GL_LAST_VERTEX_CONVENTION;
};

std::ostream& operator<<(std::ostream& out, const Way& way) { return out << way.shape.name; }

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const Shape& shape : shapes()) {
    for (const Path path : {Path::arrays, Path::elements, Path::immediate, Path::list}) ways.push_back({shape, path});
    ways.push_back({shape, Path::arrays, GL_CURVED_PN_ARK});
    ways.push_back({shape, Path::arrays, GL_LINEAR_OUTPUTS_ARK});
    ways.push_back({shape, Path::immediate, GL_CURVED_PN_ARK, GL_FIRST_VERTEX_CONVENTION});
  }
  return ways;
}

std::string name_of(const testing::TestParamInfo<Way>& info) {
  const char* const paths[] = {"Arrays", "Elements", "Immediate", "List"};
  return std::string(info.param.shape.name) + paths[static_cast<int>(info.param.path)] +
         (info.param.refinement == GL_CURVED_PN_ARK        ? "Curved"
          : info.param.refinement == GL_LINEAR_OUTPUTS_ARK ? "Outputs"
                                                           : "Inputs") +
         (info.param.convention == GL_FIRST_VERTEX_CONVENTION ? "First" : "Last");
}

int tag_of(std::size_t vertex) { return std::array{3, 1, 4, 2, 5, 0, 2, 4}[vertex]; }

CurvedVertex vertex_of(const Shape& shape, std::size_t vertex, int tag, bool on_edge) {
  const auto [x, y] = shape.places[vertex];
  return {{x, y, 0.3F * x * y + 0.1F * x},
          {0.3F * x, -0.4F * y, 0.9F},
          {x, y, on_edge ? 0.0F : 1.0F},
          7,
          static_cast<GLubyte>(tag)};
}

std::vector<CurvedVertex> mesh_of(const Shape& shape, std::size_t edge_from, std::size_t edge_to) {
  std::vector<CurvedVertex> mesh;
  for (std::size_t i = 0; i < shape.places.size(); ++i) {
    mesh.push_back(vertex_of(shape, i, tag_of(i), i == edge_from || i == edge_to));
  }
  return mesh;
}

void emit_curved(const CurvedVertex& vertex) {
  glDepthTag1i(vertex.tag);
  glVertexAttrib3fv(1, vertex.normal.data());
  glVertexAttrib3fv(2, vertex.weights.data());
  glVertexAttrib1f(3, vertex.triangle);
  glVertexAttrib3fv(0, vertex.position.data());
}

void draw_begun(GLenum mode, const std::vector<CurvedVertex>& mesh) {
  glBegin(mode);
  for (const CurvedVertex& vertex : mesh) emit_curved(vertex);
  glEnd();
}

// Section 11.R.5, MINIMUM_INTERIOR_ARK, for a triangle about a centroid.
int triangles_about_centroid(int edge, int face) {
  const int m = 1 << std::min(edge, face);
  return (m - 1) * (m - 2) + (1 << edge) + 2 * (1 << face) - 2;
}

int expected_triangles(const std::vector<std::size_t>& ring) {
  std::vector<int> edges;
  for (std::size_t k = 0; k < ring.size(); ++k)
    edges.push_back((tag_of(ring[k]) + tag_of(ring[(k + 1) % ring.size()])) / 2);
  const int face = std::accumulate(edges.begin(), edges.end(), 0) / static_cast<int>(edges.size());
  return std::accumulate(edges.begin(), edges.end(), 0,
                         [&](int sum, int edge) { return sum + triangles_about_centroid(edge, face); });
}

double area_of(const Shape& shape) {
  double area = 0;
  for (const auto& ring : shape.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto [ax, ay] = shape.places[ring[k]];
      const auto [bx, by] = shape.places[ring[(k + 1) % ring.size()]];
      area += 0.5 * (double{ax} * double{by} - double{bx} * double{ay});
    }
  }
  return area;
}

// Returns the signed area of every refined triangle.
std::vector<double> areas_of(const std::vector<RefinedVertex>& vertices) {
  std::vector<double> areas;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const auto& [p, q, r] = std::array{vertices[i].weights, vertices[i + 1].weights, vertices[i + 2].weights};
    areas.push_back(0.5 * (double{q[0] - p[0]} * double{r[1] - p[1]} - double{q[1] - p[1]} * double{r[0] - p[0]}));
  }
  return areas;
}

std::set<PositionBits> edge_vertices(const std::vector<RefinedVertex>& vertices) {
  std::set<PositionBits> result;
  for (const RefinedVertex& vertex : vertices) {
    if (vertex.weights[2] == 0) result.insert(bits_of(vertex));
  }
  return result;
}

// Counts different vertices within 1e-6 of the centroid of the ring.
std::size_t vertices_at_centroid(const std::vector<RefinedVertex>& vertices, const Shape& shape,
                                 const std::vector<std::size_t>& ring) {
  double x = 0;
  double y = 0;
  for (const std::size_t vertex : ring) {
    x += shape.places[vertex][0] / static_cast<double>(ring.size());
    y += shape.places[vertex][1] / static_cast<double>(ring.size());
  }
  std::set<PositionBits> found;
  for (const RefinedVertex& vertex : vertices) {
    if (std::hypot(vertex.weights[0] - x, vertex.weights[1] - y) < 1e-6) found.insert(bits_of(vertex));
  }
  return found.size();
}

class Centroid : public testing::TestWithParam<Way> {
 protected:
  Centroid() {
    glARKinit(level);
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(GetParam().refinement));
    glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
    glProvokingVertex(GetParam().convention);
    glEnable(GL_ARK);
    glUseProgram(link_curved_program(Language::glsl_120));
  }
  std::vector<RefinedVertex> refine(const std::vector<CurvedVertex>& mesh) {
    const GLenum mode = GetParam().shape.mode;
    const auto count = static_cast<GLsizei>(mesh.size());
    switch (GetParam().path) {
      case Path::arrays: upload(mesh); return capture_refined(most, [=] { glDrawArrays(mode, 0, count); });
      case Path::elements: return refine_elements(mesh);
      case Path::immediate: return capture_refined(most, [&] { draw_begun(mode, mesh); });
      default: return refine_list(mesh);
    }
  }
  std::vector<RefinedVertex> refine_elements(std::vector<CurvedVertex> mesh) {
    std::vector<GLushort> indices(mesh.size());
    std::iota(indices.rbegin(), indices.rend(), GLushort{0});
    std::reverse(mesh.begin(), mesh.end());
    upload(mesh);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    return capture_refined(most, [&] {
      glDrawElements(GetParam().shape.mode, static_cast<GLsizei>(mesh.size()), GL_UNSIGNED_SHORT, nullptr);
    });
  }
  std::vector<RefinedVertex> refine_list(const std::vector<CurvedVertex>& mesh) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    draw_begun(GetParam().shape.mode, mesh);
    glEndList();
    return capture_refined(most, [=] { glCallList(list); });
  }
  static constexpr std::size_t most = 60000;
  OsmesaContext context_{Profile::compatibility};
};

INSTANTIATE_TEST_SUITE_P(All, Centroid, testing::ValuesIn(all_ways()), name_of);

TEST_P(Centroid, TrianglesOfEveryPolygon) {
  const Shape& shape = GetParam().shape;
  int expected = 0;
  for (const auto& ring : shape.rings) expected += expected_triangles(ring);
  const std::vector<RefinedVertex> vertices = refine(mesh_of(shape, 0, 1));
  ASSERT_EQ(vertices.size(), 3 * static_cast<std::size_t>(expected));
  const std::vector<double> areas = areas_of(vertices);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), area_of(shape), 1e-5);
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.0);
  for (const auto& ring : shape.rings) EXPECT_EQ(vertices_at_centroid(vertices, shape, ring), 1U);
  for (const RefinedVertex& vertex : vertices) EXPECT_NEAR(vertex.triangle, 7.0F, 1e-5F);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Centroid, EdgesAreThoseOfANeighbour) {
  const Shape& shape = GetParam().shape;
  for (const auto& ring : shape.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::size_t from = ring[k];
      const std::size_t to = ring[(k + 1) % ring.size()];
      SCOPED_TRACE(testing::Message() << "edge " << from << " " << to);
      const std::set<PositionBits> own = edge_vertices(refine(mesh_of(shape, from, to)));
      const std::vector<CurvedVertex> neighbour = {vertex_of(shape, to, tag_of(to), true),
                                                   vertex_of(shape, from, tag_of(from), true),
                                                   {{1.3F, 0.2F, 0.1F}, {0, 0, 1}, {2, 2, 1}, 7, 2}};
      const std::set<PositionBits> others =
          edge_vertices(capture_refined(most, [&] { draw_begun(GL_TRIANGLES, neighbour); }));
      EXPECT_EQ(own.size(), (std::size_t{1} << ((tag_of(from) + tag_of(to)) / 2)) + 1);
      EXPECT_EQ(own, others);
    }
  }
}

TEST_P(Centroid, UniformDepth) {
  const Shape& shape = GetParam().shape;
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  for (const GLint depth : {0, 2, 3}) {
    SCOPED_TRACE(depth);
    glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, depth);
    const std::vector<RefinedVertex> vertices = refine(mesh_of(shape, 0, 1));
    const std::size_t sides = shape.rings.size() * shape.rings[0].size();
    ASSERT_EQ(vertices.size(), (3 * sides) << (2 * depth));
    const std::vector<double> areas = areas_of(vertices);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), area_of(shape), 1e-5);
    EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.0);
    EXPECT_EQ(vertices_at_centroid(vertices, shape, shape.rings[0]), 1U);
  }
}

TEST_P(Centroid, TrianglesHaveNoVertexThere) {
  glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_TRIANGLES_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  const Shape& shape = GetParam().shape;
  const std::vector<RefinedVertex> vertices = refine(mesh_of(shape, 0, 1));
  EXPECT_EQ(vertices.size(), 3 * shape.rings.size() * (shape.rings[0].size() - 2));
  EXPECT_EQ(vertices_at_centroid(vertices, shape, shape.rings[0]), 0U);
}

}  // namespace
}  // namespace glark::core::test
