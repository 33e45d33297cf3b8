// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Shapes as programs write them, with sines and cosines: positions of one place differ by rounding. Their edges must be
// those of the shape whose positions are equal. Also triangles with one normal that is not that of their face.
#include <cmath>

#include "tests/core/support/meshes/creased_meshes.h"
#include "tests/core/support/meshes/welded_records.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

constexpr float crease = 80;

// How a program computes sines. `exact`: in doubles; equal places get equal positions.
enum class Sines { doubles, floats, exact };

struct Written {
  Sines sines = Sines::doubles;
  GLfloat size = 1;
  Vector middle{};
};

struct Direction {
  double cosine = 1;
  double sine = 0;
};
Direction direction(Sines sines, double turn) {
  if (sines == Sines::floats) {
    const float angle = 2 * 3.14159265F * static_cast<float>(turn);
    return {std::cos(angle), std::sin(angle)};
  }
  if (sines == Sines::doubles) return {std::cos(2 * M_PI * turn), std::sin(2 * M_PI * turn)};
  const Direction d = direction(Sines::doubles, turn - std::floor(turn));
  return {std::abs(d.cosine) < 1e-9 ? 0 : d.cosine, std::abs(d.sine) < 1e-9 ? 0 : d.sine};
}

// The profile of a shape about the z axis. The direction is that of the normal.
struct Profile {
  double radius = 0;
  double height = 0;
  Direction normal;
};

Vector around(const Direction& turn, double radius, double height) {
  return {static_cast<GLfloat>(turn.cosine * radius), static_cast<GLfloat>(turn.sine * radius),
          static_cast<GLfloat>(height)};
}

// A band of quads between two profiles, as GL_QUAD_STRIP splits them.
void add_band(SplitMesh& mesh, const Written& how, int slices, const Profile& low, const Profile& high) {
  const auto vertex = [&](int slice, const Profile& profile) {
    const Direction turn = direction(how.sines, double(slice) / slices);
    Vector position = around(turn, profile.radius, profile.height);
    for (std::size_t k = 0; k < 3; ++k) position[k] = position[k] * how.size + how.middle[k];
    return std::pair(position, around(turn, profile.normal.cosine, profile.normal.sine));
  };
  for (int i = 0; i < slices; ++i) {
    const auto a = vertex(i, high), b = vertex(i, low), c = vertex(i + 1, high), d = vertex(i + 1, low);
    mesh.add({a.first, b.first, c.first}, {a.second, b.second, c.second});
    mesh.add({c.first, b.first, d.first}, {c.second, b.second, d.second});
  }
}

// Bands `first` to `last` of a ball, counted from its south pole.
SplitMesh ball(const Written& how, int slices, int stacks, int first, int last) {
  SplitMesh mesh;
  const auto at = [&](int stack) {
    const Direction tilt = direction(how.sines, double(stack) / stacks / 2 - 0.25);
    return Profile{tilt.cosine, tilt.sine, tilt};
  };
  for (int band = first; band < last; ++band) add_band(mesh, how, slices, at(band), at(band + 1));
  return mesh;
}

SplitMesh ring(const Written& how, int slices, int sides) {
  SplitMesh mesh;
  const auto at = [&](int side) {
    const Direction tilt = direction(how.sines, double(side) / sides);
    return Profile{1 + 0.4 * tilt.cosine, 0.4 * tilt.sine, tilt};
  };
  for (int side = 0; side < sides; ++side) add_band(mesh, how, slices, at(side), at(side + 1));
  return mesh;
}

class RoundedPositions : public testing::Test {
 protected:
  WeldedMesh weld(const SplitMesh& mesh, float degrees = crease) { return records_.weld(mesh, degrees); }
  // Makes a shape as each kind of program would, and with equal positions.
  template <typename Make>
  void expect_as_exact(Make make) {
    for (const Sines sines : {Sines::doubles, Sines::floats}) {
      for (const auto& [size, middle] : {std::pair(1.0F, Vector{}), {3.7F, Vector{}}, {0.7F, {3.3F, -2.1F, 0.9F}}}) {
        const WeldedMesh written = weld(make(Written{sines, size, middle}));
        const WeldedMesh exact = weld(make(Written{Sines::exact, size, middle}));
        ASSERT_EQ(written.size(), exact.size());
        int differ = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const GLfloat most = std::max(length(minus(written[i].near_from, exact[i].near_from)),
                                        length(minus(written[i].near_to, exact[i].near_to)));
          differ += most > 1e-5F * (length(middle) + size) ? 1 : 0;
        }
        EXPECT_EQ(differ, 0) << "of " << exact.size() << ", size " << size << ", sines " << static_cast<int>(sines);
      }
    }
  }

  PlainContext context_;
  WeldedRecords records_{context_.gl};
};

TEST_F(RoundedPositions, ABallClosesAtItsSeamAndPoles) {
  for (const auto& [slices, stacks] : {std::pair(10, 6), {8, 4}, {12, 12}, {32, 16}}) {
    SCOPED_TRACE(slices);
    expect_as_exact([n = slices, m = stacks](const Written& how) { return ball(how, n, m, 0, m); });
  }
}

// Programs draw each band by itself.
TEST_F(RoundedPositions, ABandAtAPoleIsCurved) {
  expect_as_exact([](const Written& how) { return ball(how, 10, 6, 0, 1); });
  expect_as_exact([](const Written& how) { return ball(how, 10, 6, 5, 6); });
  EXPECT_GT(bent_edges(weld(ball({}, 10, 6, 5, 6))), 40);
}

// If welding missed the other side of the seam, the ring would have two ends there.
TEST_F(RoundedPositions, ARingIsRoundAtItsSeam) {
  expect_as_exact([](const Written& how) { return ring(how, 64, 8); });
  expect_as_exact([](const Written& how) { return ring(how, 12, 6); });
}

TEST_F(RoundedPositions, SmallPartsStayApart) {
  SplitMesh mesh = averaged(octahedron());
  for (const CurvedVertex& vertex : averaged(octahedron()).vertices) {
    CurvedVertex small = vertex;
    for (GLfloat& value : small.position) value *= 1e-4F;
    mesh.vertices.push_back(small);
  }
  EXPECT_EQ(changed_edges(weld(mesh), weld(mesh, weld::no_crease)), 0);
}

// The extension's text: positions are the same if their bits are.
TEST_F(RoundedPositions, BitsDecideWithoutLimits) {
  SplitMesh leaf = bent_leaf();
  for (std::size_t i = 3; i < 5; ++i) {
    leaf.vertices[i].position[0] = 1e-8F;
    leaf.vertices[i].normal = {0.3F, 0, 1};
  }
  const auto apart = [](const WeldedMesh& mesh) { return length(minus(mesh[0].near_from, mesh[3].near_to)); };
  EXPECT_LT(apart(weld(leaf)), 1e-6F);
  EXPECT_GT(apart(weld(leaf, weld::no_crease)), 1e-2F);
}

// A triangle without an area stitches the middle of an edge. It has no height that could limit this edge.
TEST_F(RoundedPositions, ASliverDoesNotStraightenItsEdge) {
  SplitMesh mesh = bent_leaf();
  const CurvedVertex a = mesh.vertices[0];
  const CurvedVertex b = mesh.vertices[1];
  const WeldedMesh before = weld(mesh);
  ASSERT_FALSE(before[0].is_straight());
  mesh.add({a.position, b.position, {1e-8F, 0, 0}}, {a.normal, b.normal, {0, 0, 1}});
  WeldedMesh after = weld(mesh);
  after.resize(before.size());
  EXPECT_EQ(changed_edges(after, before), 0);
}

SplitMesh quad(const Vector& normal) {
  SplitMesh mesh;
  mesh.add({Vector{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}, {normal, normal, normal});
  mesh.add({Vector{-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {normal, normal, normal});
  return mesh;
}

TEST_F(RoundedPositions, AFaceWithOneTiltedNormalStaysFlat) {
  for (const Vector& normal : {Vector{0, 0.7071F, 1}, {0, 0.7071F, -1}, {0.05F, 0, 1}}) {
    EXPECT_GT(bent_edges(weld(quad(normal), weld::no_crease)), 0) << "the control is not curved";
    EXPECT_EQ(bent_edges(weld(quad(normal))), 0);
  }
}

// The edge that a flat triangle shares with a curved one is straight on both sides. The other edges of the curved one
// stay curved.
TEST_F(RoundedPositions, ATiltedFaceMeetsItsNeighbour) {
  SplitMesh mesh = bent_leaf();
  for (std::size_t i = 0; i < 3; ++i) mesh.vertices[i].normal = {0, -0.4F, 1};
  const WeldedMesh welded = weld(mesh);
  for (const std::size_t i : {0, 1, 2, 3}) EXPECT_TRUE(welded[i].is_straight()) << i;
  EXPECT_FALSE(welded[4].is_straight());
  EXPECT_FALSE(welded[5].is_straight());
}

// Normals have few digits. A lid that leans by a degree still follows the round wall at its edge.
TEST_F(RoundedPositions, AFaceWithItsOwnNormalFollowsItsNeighbours) {
  SplitMesh mesh = gear(7, 0, true);
  int lids = 0;
  for (CurvedVertex& vertex : mesh.vertices) {
    if (std::abs(vertex.normal[2]) < 0.99F) continue;
    vertex.normal[0] += 0.01F;
    ++lids;
  }
  EXPECT_GT(lids, 0);
  EXPECT_EQ(changed_edges(weld(mesh), weld(mesh, weld::no_crease)), 0);
}

}  // namespace
}  // namespace glark::core::test
