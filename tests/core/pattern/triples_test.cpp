// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every pattern is a conforming triangulation: see defect_of.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "tests/core/pattern/assembly.h"

namespace glark::pattern {
namespace {

using testing::assemble;
using testing::Assembly;
using testing::defect_of;
using testing::Point;
using testing::Triangle;
using testing::whole;

const Pool& deepest_pool() {
  static const Pool pool = build_pool(11);
  return pool;
}

std::string defect_of_triple(const Pool& pool, std::array<int, 3> e, Interior interior) {
  std::string defect = defect_of(assemble(pool, expand(e[0], e[1], e[2], interior)), e);
  if (defect.empty()) return "";
  std::ostringstream out;
  out << e[0] << ' ' << e[1] << ' ' << e[2] << ": " << defect;
  return out.str();
}

void expect_conforming(const Pool& pool, std::array<int, 3> e) {
  EXPECT_EQ(defect_of_triple(pool, e, Interior::minimum), "");
  EXPECT_EQ(defect_of_triple(pool, e, Interior::smooth), "") << "smooth";
  EXPECT_EQ(defect_of_triple(pool, e, Interior::parts), "") << "parts";
}

// The pool is no deeper than needed, so that a missing piece is noticed.
TEST(Triples, EveryShallowTripleConforms) {
  for (int level = 0; level <= 6; ++level) {
    Pool pool = build_pool(static_cast<unsigned>(level));
    for (int e0 = 0; e0 <= level; ++e0) {
      for (int e1 = 0; e1 <= level; ++e1) {
        for (int e2 = 0; e2 <= level; ++e2) {
          if (e0 == level || e1 == level || e2 == level) expect_conforming(pool, {e0, e1, e2});
        }
      }
    }
  }
}

TEST(Triples, SampledDeepTriplesConform) {
  std::mt19937 random(20070704);
  for (int count = 0; count < 150;) {
    std::array<int, 3> e{};
    for (int& depth : e) depth = static_cast<int>(random() % 12);
    int least = std::min({e[0], e[1], e[2]});
    int most = std::max({e[0], e[1], e[2]});
    if (most < 7 || least > 6) continue;
    expect_conforming(deepest_pool(), e);
    ++count;
  }
}

class DeepTriple : public ::testing::TestWithParam<std::array<int, 3>> {};

TEST_P(DeepTriple, Conforms) { expect_conforming(deepest_pool(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Triples, DeepTriple,
                         ::testing::Values(std::array{7, 7, 7}, std::array{8, 8, 8}, std::array{9, 9, 9},
                                           std::array{7, 7, 8}, std::array{7, 9, 11}, std::array{11, 7, 9},
                                           std::array{9, 11, 7}, std::array{7, 11, 10}, std::array{8, 11, 8},
                                           std::array{11, 8, 10}, std::array{9, 10, 11}, std::array{10, 11, 10}));

TEST(Triples, DeepestPoolDrawsWhatASmallerOneDraws) {
  Pool small = build_pool(4);
  std::vector<Instance> instances = expand(2, 3, 4, Interior::minimum);
  EXPECT_EQ(assemble(small, instances).triangles, assemble(deepest_pool(), instances).triangles);
}

bool before(Point a, Point b) { return a.u != b.u ? a.u < b.u : a.v < b.v; }

// The triangles in an order of their own, each from its least corner on.
std::vector<Triangle> sorted_triangles(const Pool& pool, const std::vector<Instance>& instances) {
  std::vector<Triangle> triangles = assemble(pool, instances).triangles;
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end(), before), t.end());
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  return triangles;
}

TEST(Triples, WholePiecesHaveTheTrianglesOfTheirParts) {
  const Pool pool = build_pool(5);
  for (int e0 = 1; e0 <= 5; ++e0) {
    for (int e1 = 1; e1 <= 5; ++e1) {
      for (int e2 = 1; e2 <= 5; ++e2) {
        EXPECT_EQ(sorted_triangles(pool, expand(e0, e1, e2, Interior::minimum)),
                  sorted_triangles(pool, expand(e0, e1, e2, Interior::parts)))
            << e0 << ' ' << e1 << ' ' << e2;
      }
    }
  }
}

// Tests the checks themselves: they must notice each kind of damage.
class Damage : public ::testing::Test {
 protected:
  std::string defect() const { return defect_of(assemble(pool, instances), {2, 3, 4}); }
  Pool pool = build_pool(4);
  std::vector<Instance> instances = expand(2, 3, 4, Interior::parts);
};

TEST_F(Damage, NoneIsNone) { EXPECT_EQ(defect(), ""); }

TEST_F(Damage, MissingInstance) {
  instances.pop_back();
  EXPECT_NE(defect(), "");
}

TEST_F(Damage, DoubledInstance) {
  instances.push_back(instances.front());
  EXPECT_NE(defect(), "");
}

TEST_F(Damage, WrongRotation) {
  std::swap(instances[2].r, instances[3].r);
  EXPECT_NE(defect(), "");
}

TEST_F(Damage, TurnedTriangle) {
  std::size_t first = pool.pieces[static_cast<std::size_t>(skirt_piece(2, 3))].first_index;
  std::swap(pool.indices[first], pool.indices[first + 1]);
  EXPECT_NE(defect(), "");
}

TEST_F(Damage, MovedVertex) {
  const Piece& skirt = pool.pieces[static_cast<std::size_t>(skirt_piece(2, 4))];
  ++pool.vertices[static_cast<std::size_t>(skirt.base_vertex + skirt.vertex_count - 1)].u;
  EXPECT_NE(defect(), "");
}

TEST_F(Damage, SkirtOfAnotherDepth) {
  instances[2].piece = skirt_piece(2, 4);
  EXPECT_NE(defect(), "");
}

// The centre differs by a unit of the lattice from piece to piece. The vertex stage moves it to one place.
Assembly with_one_centre(Assembly assembly) {
  for (Triangle& triangle : assembly.triangles) {
    for (Point& point : triangle) {
      const std::int64_t third = whole / 3;
      if (std::abs(point.u - third) < 64 && std::abs(point.v - third) < 64) point = {third, third};
    }
  }
  return assembly;
}

TEST(NestedTriples, EveryShallowTripleConforms) {
  for (int level = 0; level <= 6; ++level) {
    Pool pool = build_pool(static_cast<unsigned>(level), true);
    for (int e0 = 0; e0 <= level; ++e0) {
      for (int e1 = 0; e1 <= level; ++e1) {
        for (int e2 = 0; e2 <= level; ++e2) {
          if (e0 != level && e1 != level && e2 != level) continue;
          const Assembly assembly = assemble(pool, expand(e0, e1, e2, Interior::morphing));
          EXPECT_EQ(defect_of(with_one_centre(assembly), {e0, e1, e2}), "") << e0 << ' ' << e1 << ' ' << e2;
          EXPECT_LE(expand(e0, e1, e2, Interior::morphing).size(), 4U);
        }
      }
    }
  }
}

TEST(NestedTriples, DeepTriplesConform) {
  const Pool pool = build_pool(11, true);
  for (std::array<int, 3> e :
       {std::array{7, 7, 7}, {7, 8, 11}, {9, 9, 9}, {2, 11, 11}, {6, 6, 11}, {0, 11, 3}, {8, 7, 7}}) {
    const Assembly assembly = assemble(pool, expand(e[0], e[1], e[2], Interior::morphing));
    EXPECT_EQ(defect_of(with_one_centre(assembly), e), "") << e[0] << ' ' << e[1] << ' ' << e[2];
  }
}

}  // namespace
}  // namespace glark::pattern
