// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Curved triangles stay near their coarse ones: shared normals do not bend edges at creases, and no edge leaves its
// triangles by more than half of their least height. The control is the same mesh without limits.
#include <random>

#include "tests/core/support/meshes/creased_meshes.h"
#include "tests/core/support/meshes/models.h"
#include "tests/core/support/meshes/welded_records.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

constexpr float crease = 80;
class Creases : public testing::Test {
 protected:
  WeldedMesh weld(const SplitMesh& mesh, float degrees = crease) { return records_.weld(mesh, degrees); }
  WeldedMesh without_limits(const SplitMesh& mesh) { return weld(mesh, weld::no_crease); }
  void expect_unchanged(const SplitMesh& mesh) {
    const WeldedMesh free = without_limits(mesh);
    EXPECT_GT(bent_edges(free), 0) << "the mesh is not curved";
    EXPECT_EQ(changed_edges(weld(mesh), free), 0);
  }
  void expect_straight(const SplitMesh& mesh, float degrees = crease) {
    EXPECT_GT(bent_edges(without_limits(mesh)), 0) << "the mesh is not curved";
    EXPECT_EQ(bent_edges(weld(mesh, degrees)), 0);
  }
  // The offsets of all sides of an edge have the same bits, and stay below half of the least height of all sides.
  void expect_near(const SplitMesh& mesh) {
    std::map<std::pair<Vector, Vector>, std::vector<WeldedEdge>> sides;
    for (WeldedEdge edge : weld(mesh)) {
      if (edge.to < edge.from) {
        std::swap(edge.from, edge.to);
        std::swap(edge.near_from, edge.near_to);
      }
      sides[{edge.from, edge.to}].push_back(edge);
    }
    for (const auto& [ends, edges] : sides) {
      double height = INFINITY;
      for (const WeldedEdge& edge : edges) {
        EXPECT_TRUE(same_offsets(edge, edges[0]));
        const CurvedVertex* corner = &mesh.vertices[3 * edge.triangle];
        height = std::min(height, least_height(corner[0].position, corner[1].position, corner[2].position));
      }
      const double rounding = 1e-5 * (length(ends.first) + length(ends.second));
      for (const Vector& offset : {edges[0].near_from, edges[0].near_to}) {
        for (const GLfloat value : offset) ASSERT_TRUE(std::isfinite(value));
        ASSERT_LE(length(offset), 1.5 * height * 1.001 + rounding);
      }
    }
  }
  PlainContext context_;
  WeldedRecords records_{context_.gl};
};

TEST_F(Creases, ACubeStaysFlat) {
  expect_straight(averaged(cube()));
  expect_straight(rows_of(averaged(cube()), 20));  // more triangles than one work group takes
}

TEST_F(Creases, ASplitCubeStaysFlat) { EXPECT_EQ(bent_edges(weld(flat_shaded(cube()))), 0); }

TEST_F(Creases, AnOctahedralBallRounds) {
  expect_unchanged(averaged(octahedron()));
  expect_unchanged(rows_of(averaged(octahedron()), 30));
}

TEST_F(Creases, TheLimitIsTheAngleOfTheFaces) {
  EXPECT_GT(bent_edges(weld(averaged(cube()), 90)), 0);
  EXPECT_EQ(bent_edges(weld(averaged(cube()), 89)), 0);
  EXPECT_GT(bent_edges(weld(averaged(octahedron()), 71)), 0);
  EXPECT_EQ(bent_edges(weld(averaged(octahedron()), 70)), 0);
  EXPECT_EQ(bent_edges(weld(averaged(icosahedron()), 0)), 0);
}

TEST_F(Creases, SmoothMeshesAreUnchanged) {
  expect_unchanged(averaged(icosahedron()));
  for (const auto& [slices, stacks] : {std::pair(8, 4), {16, 8}, {64, 32}, {12, 12}, {6, 3}, {6, 6}}) {
    SCOPED_TRACE(slices);
    expect_unchanged(sphere(slices, stacks));
  }
  expect_unchanged(torus(24, 12, 0.4F));
  expect_unchanged(torus(12, 6, 0.3F));
}

// The rim of a cylinder with its own normals on wall and lids is a hard edge, which the normals explain.
TEST_F(Creases, HardEdgesKeepTheirCurve) {
  expect_unchanged(gear(7, 0, true));
  expect_unchanged(gear(60, 0, true));
}

TEST_F(Creases, APoleKeepsItsThickness) {
  for (const int sides : {3, 4, 5, 6, 8, 12}) expect_straight(pole(sides, 60));
}

// Its faces meet at 45 degrees or less, so that it counts as round. Only the least height keeps it thin.
TEST_F(Creases, AChamferedPoleHardlySwells) {
  const SplitMesh mesh = chamfered_pole(12, 60);
  EXPECT_GT(greatest_offset(without_limits(mesh)), 10);
  EXPECT_LT(greatest_offset(weld(mesh)), 0.8);
  EXPECT_GT(greatest_offset(weld(mesh)), 0.1);
  expect_near(mesh);
}

// The edges of an antenna are 24 times as long as it is thick, and its tip has a normal along its axis.
TEST_F(Creases, AnAntennaStaysThin) {
  EXPECT_LT(greatest_offset(weld(antenna(6, 24))), 0.8);
  EXPECT_GT(greatest_offset(without_limits(antenna(6, 24))), 10);
}

TEST_F(Creases, SliversStayNear) {
  expect_near(sliver_fan(200, 1e-3F));
  expect_near(sliver_fan(50, 1e-7F));
  expect_near(seams_everywhere(icosahedron(), 0.6F, 3));
  expect_near(rows_of(seams_everywhere(cube(), 0.6F, 4), 30));
}

TEST_F(Creases, WindingDoesNotMatter) {
  for (const Mesh& shape : {octahedron(), cube(), icosahedron()}) {
    const SplitMesh mesh = averaged(shape);
    const WeldedMesh straight = weld(mesh);
    SplitMesh turned = mesh;
    for (std::size_t t = 0; t < mesh.triangles(); t += 3) {
      std::swap(turned.vertices[3 * t], turned.vertices[3 * t + 1]);
    }
    EXPECT_EQ(bent_edges(weld(turned)), bent_edges(straight));
  }
}

// Each triangle exists twice, the second time from behind.
TEST_F(Creases, ASheetOfTwoFacesIsOneSurface) {
  const SplitMesh ball = averaged(octahedron());
  const SplitMesh doubled = with_backs(ball);
  WeldedMesh front = weld(doubled);
  front.resize(ball.vertices.size());
  EXPECT_EQ(changed_edges(front, weld(ball)), 0);
  EXPECT_EQ(bent_edges(weld(with_backs(averaged(cube())))), 0);
  const SplitMesh leaf = bent_leaf();
  expect_unchanged(leaf);
  expect_unchanged(with_backs(leaf));
}

TEST_F(Creases, GentleBoundariesStayCurved) { expect_unchanged(bent_leaf()); }

// Nothing beyond the ends of a wall pulls its normals. A lid in another draw must meet it, so its edges stay straight.
TEST_F(Creases, AWallEndsAtItsLid) {
  for (const int sides : {6, 8, 16}) {
    expect_straight(wall(sides, 1));
    expect_straight(wall(sides, 0.5F));
  }
}

// The upper corners stand above the middles of the lower edges, so no side of a triangle is upright.
TEST_F(Creases, ATwistedWallEndsAtItsLid) {
  constexpr int sides = 8;
  const auto at = [](float side, float z) {
    const float turn = 2 * 3.14159265F * std::fmod(side, static_cast<float>(sides)) / sides;
    return Vector{std::cos(turn), std::sin(turn), z};
  };
  SplitMesh wall;
  for (int side = 0; side < sides; ++side) {
    const auto number = static_cast<float>(side);
    const auto add = [&wall](const Vector& a, const Vector& b, const Vector& c) {
      const auto outwards = [](const Vector& v) { return Vector{v[0], v[1], 0}; };
      wall.add({a, b, c}, {outwards(a), outwards(b), outwards(c)});
    };
    add(at(number, 0), at(number + 1, 0), at(number + 0.5F, 1));
    add(at(number + 1, 0), at(number + 1.5F, 1), at(number + 0.5F, 1));
  }
  expect_straight(wall);
}

// The normals of a strip lean towards the next strip, which has the same ones.
TEST_F(Creases, StripsOfABallStayCurved) {
  const float step = 3.14159265F / 8;
  for (int strip = -3; strip < 3; ++strip) {
    expect_unchanged(zone_of_sphere(8, step * static_cast<float>(strip), step * static_cast<float>(strip + 1)));
  }
}

// Each ring of a ball is a draw of its own, as those of gluSphere are. Coarse rings lean less towards one neighbour than
// towards the other one, yet both decide alike about their common edges.
TEST_F(Creases, RingsOfABallMeet) {
  for (const auto& [slices, stacks] : {std::pair<int, int>{5, 5},
                                       {6, 6},
                                       {7, 7},
                                       {8, 8},
                                       {12, 24},
                                       {20, 20},
                                       {64, 44},
                                       {64, 45},
                                       {64, 79},
                                       {16, 79},
                                       {12, 90}}) {
    const float step = 3.14159265F / static_cast<float>(stacks);
    const auto ring = [&, sides = slices](int i) {
      const auto low = static_cast<float>(i) * step - 1.57079633F;
      return weld(zone_of_sphere(sides, low, static_cast<float>(i + 1) * step - 1.57079633F));
    };
    WeldedMesh below = ring(1);
    for (int i = 2; i < stacks - 1; ++i) {
      const WeldedMesh above = ring(i);
      int common = 0;
      for (const WeldedEdge& a : below)
        for (const WeldedEdge& b : above) {
          if (!same_bits(a.from, b.to) || !same_bits(a.to, b.from)) continue;
          ++common;
          EXPECT_EQ(a.is_straight(), b.is_straight()) << slices << " slices, " << stacks << " stacks, below " << i;
        }
      EXPECT_EQ(common, slices);
      below = above;
    }
  }
}

// Each face is a draw of its own, as where faces have different textures.
TEST_F(Creases, NormalsOfNoSurfaceBendNothing) { expect_straight(leaning_ring()); }

TEST_F(Creases, FacesDrawnAloneKeepTheirShape) {
  SplitMesh box = averaged(cube());
  for (CurvedVertex& vertex : box.vertices) vertex.normal = unit(vertex.position);
  const SplitMesh ball = averaged(octahedron());
  for (std::size_t t = 0; t < box.triangles(); t += 2) {
    SplitMesh face;
    face.add(positions_of(box, t), normals_of(box, t));
    face.add(positions_of(box, t + 1), normals_of(box, t + 1));
    expect_straight(face);
  }
  for (std::size_t t = 0; t < ball.triangles(); ++t) {
    SplitMesh face;
    face.add(positions_of(ball, t), normals_of(ball, t));
    expect_unchanged(face);
  }
}

// The roof of a house whose walls are other draws. Its normals are its own at two corners. At the others, a wall pulls
// them by fewer degrees than a crease has.
TEST_F(Creases, ARoofStaysFlat) {
  const std::array<Vector, 4> corners = {Vector{-1, -0.5F, 0}, {1, -0.5F, 0}, {1, 0.5F, 0}, {-1, 0.5F, 0}};
  const Vector up{0, 0, 1};
  for (const Vector& pulled : {Vector{0, -0.6F, 1}, {0.3F, -0.3F, 1}}) {
    const std::array<Vector, 4> normals = {pulled, pulled, up, up};
    SplitMesh roof;
    roof.add({corners[0], corners[1], corners[2]}, {normals[0], normals[1], normals[2]});
    roof.add({corners[0], corners[2], corners[3]}, {normals[0], normals[2], normals[3]});
    EXPECT_EQ(bent_edges(weld(roof)), 0);
    EXPECT_EQ(bent_edges(weld(rows_of(roof, 20))), 0);
    SplitMesh half;
    half.add(positions_of(roof, 0), normals_of(roof, 0));
    expect_straight(half);
  }
}

// The next panel of the body curves at the common edge.
TEST_F(Creases, APanelThatLeansLittleStaysCurved) {
  const Vector up{0, 0, 1};
  const Vector pulled = unit({-0.15F, -0.15F, 1});
  SplitMesh panel;
  panel.add({Vector{-1, -0.5F, 0}, {1, -0.5F, 0}, {1, 0.5F, 0}}, {pulled, up, up});
  panel.add({Vector{-1, -0.5F, 0}, {1, 0.5F, 0}, {-1, 0.5F, 0}}, {pulled, up, up});
  EXPECT_GT(bent_edges(weld(panel)), 0);
}

// A facet of a ball that is drawn alone has no normal of its own.
TEST_F(Creases, AQuadOfABallStaysCurved) {
  const float step = 3.14159265F / 8;
  const SplitMesh zone = zone_of_sphere(8, 0, step);
  SplitMesh quad;
  for (const std::size_t t : {0, 1}) quad.add(positions_of(zone, t), normals_of(zone, t));
  expect_unchanged(quad);
}

// A fin stands on a smooth surface and shares its normals. The sheet does not bend where the fin stands.
TEST_F(Creases, TheGreatestAngleOfThreeSidesCounts) {
  SplitMesh mesh = bent_leaf();
  const CurvedVertex a = mesh.vertices[0];
  const CurvedVertex b = mesh.vertices[1];
  const WeldedMesh before = weld(mesh);
  ASSERT_FALSE(before[0].is_straight());
  mesh.add(
      {a.position, b.position, {0.5F * (a.position[0] + b.position[0]), 0.5F * (a.position[1] + b.position[1]), 3}},
      {a.normal, b.normal, a.normal});
  EXPECT_TRUE(weld(mesh)[0].is_straight());
}

TEST_F(Creases, ManySidesOfOneEdgeStayStraight) {
  SplitMesh mesh = bent_leaf();
  const SplitMesh leaf = mesh;
  for (int i = 0; i < 40; ++i) mesh.add(positions_of(leaf, 0), normals_of(leaf, 0));
  EXPECT_TRUE(weld(mesh)[0].is_straight());
}

// The result does not depend on the order of triangles and corners.
TEST_F(Creases, OrderDoesNotMatter) {
  std::mt19937 random(5);
  for (const SplitMesh& mesh : {rows_of(averaged(cube()), 12), chamfered_pole(8, 30), sliver_fan(100, 1e-3F),
                                rows_of(seams_everywhere(octahedron(), 0.3F, 2), 30)}) {
    std::vector<std::size_t> order(mesh.triangles());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    SplitMesh other;
    for (const std::size_t t : order) other.add(positions_of(mesh, t, t % 3), normals_of(mesh, t, t % 3));
    std::map<std::pair<Vector, Vector>, WeldedEdge> edges;
    for (const WeldedEdge& edge : weld(mesh)) edges[{edge.from, edge.to}] = edge;
    for (const WeldedEdge& edge : weld(other)) EXPECT_TRUE(same_offsets(edge, edges.at({edge.from, edge.to})));
  }
}

TEST_F(Creases, DegenerateTrianglesChangeNothing) {
  SplitMesh mesh = averaged(octahedron());
  const WeldedMesh before = weld(mesh);
  const Vector a = mesh.vertices[0].position;
  const Vector b = mesh.vertices[1].position;
  mesh.add({a, b, b}, normals_of(mesh, 0));
  mesh.add({a, a, b}, normals_of(mesh, 0));
  WeldedMesh after = weld(mesh);
  after.resize(before.size());
  EXPECT_EQ(changed_edges(after, before), 0);
}

// Zero and strange normals, and extreme sizes, give finite control points.
TEST_F(Creases, StrangeValuesStayFinite) {
  for (const GLfloat size : {1e-30F, 1e-10F, 1.0F, 1e10F, 1e17F}) {
    SplitMesh mesh = seams_everywhere(cube(), 0.4F, 6);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      for (GLfloat& value : mesh.vertices[i].position) value *= size;
      if (i % 5 == 0) mesh.vertices[i].normal = {0, 0, 0};
      if (i % 7 == 0) mesh.vertices[i].normal = {0, std::nanf(""), 1};
      if (i % 11 == 0) mesh.vertices[i].normal = {INFINITY, 0, 1};
    }
    expect_near(mesh);
  }
}

// A real scan is smooth: nearly all of its edges are unchanged.
class CreasesOfModel : public Creases, public testing::WithParamInterface<const char*> {};

TEST_P(CreasesOfModel, NearlyAllEdgesAreUnchanged) {
  const auto mesh = coarse_model(GetParam(), 100000);
  if (!mesh) GTEST_SKIP() << GetParam() << " is not in " GLARK_MODELS ", or zstd is missing";
  const SplitMesh smooth = averaged(*mesh);
  const WeldedMesh free = without_limits(smooth);
  const int changed = changed_edges(weld(smooth), free);
  const int by_height = changed_edges(weld(smooth, 179.9F), free);
  std::printf("%s: of %zu half-edges, %d changed, %d of them by the least height alone\n", GetParam(), free.size(),
              changed, by_height);
  EXPECT_LT(changed, static_cast<int>(smooth.vertices.size() / 25));
}

TEST_P(CreasesOfModel, CoarseOnesStayNear) {
  const auto mesh = coarse_model(GetParam(), 16);
  if (!mesh) GTEST_SKIP() << GetParam() << " is not in " GLARK_MODELS ", or zstd is missing";
  expect_near(averaged(*mesh));
}

INSTANTIATE_TEST_SUITE_P(All, CreasesOfModel, testing::Values("armadillo", "bunny", "horse", "igea", "nefertiti"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace glark::core::test
