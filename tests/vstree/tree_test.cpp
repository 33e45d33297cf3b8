// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

using Vector = std::array<double, 3>;

Vector vector(const std::vector<float>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector scaled(const Vector& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector minus(const Vector& a, const Vector& b) { return plus(a, scaled(b, -1)); }

struct Plane {
  Vector centroid{}, normal{};
};

Plane mean_plane(const Shape& shape, std::span<const std::uint32_t> samples) {
  Plane plane;
  for (const std::uint32_t i : samples) {
    plane.centroid =
        plus(plane.centroid, scaled(vector(shape.positions, i), 1.0 / static_cast<double>(samples.size())));
    plane.normal = plus(plane.normal, vector(shape.normals, i));
  }
  plane.normal = scaled(plane.normal, 1 / std::sqrt(dot(plane.normal, plane.normal)));
  return plane;
}

// Computes the error by its definition, without sums that cancel.
double error_by_definition(const Shape& shape, std::span<const std::uint32_t> samples, Metric metric, double diagonal) {
  const Plane plane = mean_plane(shape, samples);
  double sum = 0;
  for (const std::uint32_t i : samples) {
    const Vector apart = metric == Metric::l2 ? minus(vector(shape.positions, i), plane.centroid)
                                              : minus(vector(shape.normals, i), plane.normal);
    const double distance = metric == Metric::l2 ? dot(apart, plane.normal) / diagonal : std::sqrt(dot(apart, apart));
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

std::vector<const Node*> leaves_of(const Tree& tree) {
  std::vector<const Node*> leaves;
  for (const Node& node : tree.nodes()) {
    if (node.is_leaf()) leaves.push_back(&node);
  }
  return leaves;
}

TEST(Tree, HasEachSampleInOneLeafWhichItsQueryFinds) {
  const Shape shape = torus(120);
  for (const bool surface : {true, false}) {
    const Tree tree(shape.points(), {.surface = surface, .threshold = 1e-3F});
    std::vector<int> seen(shape.size());
    for (const Node* leaf : leaves_of(tree)) {
      EXPECT_GT(leaf->size(), 0U);
      for (const std::uint32_t i : tree.samples(*leaf)) {
        ++seen[i];
        EXPECT_EQ(tree.leaf_of(shape.position(i)), static_cast<std::uint32_t>(leaf - tree.nodes().data()));
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(shape.size()));
  }
}

TEST(Tree, HasTheSamplesOfAParentInItsChildren) {
  const Shape shape = torus(100);
  const Tree tree(shape.points(), {.threshold = 1e-3F});
  for (const Node& node : tree.nodes()) {
    if (node.is_leaf()) continue;
    std::uint32_t begin = node.begin;
    for (unsigned k = 0; k < node.child_count(); ++k) {
      const Node& child = tree.nodes()[node.first_child + k];
      EXPECT_EQ(child.begin, begin);
      EXPECT_EQ(child.level, node.level + 1);
      EXPECT_TRUE((child.kind == Kind::surface) == (node.kind != Kind::volume));
      begin = child.end;
    }
    EXPECT_EQ(begin, node.end);
  }
}

class TreeMetric : public testing::TestWithParam<Metric> {};
INSTANTIATE_TEST_SUITE_P(All, TreeMetric, testing::Values(Metric::l2, Metric::l21));

TEST_P(TreeMetric, IsWhatItsDefinitionSaysAndBelowTheThresholdInLeaves) {
  const Shape shape = torus(150);
  const float threshold = GetParam() == Metric::l2 ? 1e-3F : 0.1F;
  const Tree tree(shape.points(), {.metric = GetParam(), .threshold = threshold});
  ASSERT_GT(tree.leaf_count(), 100U);
  for (const Node& node : tree.nodes()) {
    if (node.level < 2) continue;  // normals in all directions have no reliable mean
    const double expected = error_by_definition(shape, tree.samples(node), GetParam(), tree.diagonal());
    EXPECT_NEAR(node.error, expected, 1e-3 * expected + (GetParam() == Metric::l2 ? 1e-6 : 1e-3));
    if (node.is_leaf() && node.size() > 1) {
      EXPECT_LE(node.error, threshold);
    }
  }
}

TEST(Tree, DividesByTheNumberOfSamples) {
  const Shape shape = sphere(20000);
  const Tree tree(shape.points(), {.metric = Metric::density, .threshold = 40});
  for (const Node* leaf : leaves_of(tree)) EXPECT_LE(leaf->size(), 40U);
  EXPECT_LT(tree.leaf_count(), 20000U / 8);
}

TEST(Tree, QuadricErrorOfAPlaneIsNothing) {
  Shape flat = torus(60);
  for (std::size_t i = 0; i < flat.positions.size(); i += 3) {
    flat.positions[i + 2] = 0.5F * flat.positions[i];
    flat.normals[i] = -0.5F;
    flat.normals[i + 1] = 0;
    flat.normals[i + 2] = 1;
  }
  EXPECT_EQ(Tree(flat.points(), {.metric = Metric::qef, .threshold = 1e-5F}).leaf_count(), 1U);
  EXPECT_GT(Tree(torus(60).points(), {.metric = Metric::qef, .threshold = 1e-3F}).leaf_count(), 20U);
}

TEST(Tree, HasAHeightFieldInEachTransitionNode) {
  const Shape shape = torus(150);
  constexpr float delta_a = 0.2F, delta_d = 0.3F;
  const Tree tree(shape.points(), {.threshold = 1e-3F, .delta_a = delta_a, .delta_d = delta_d});
  ASSERT_GT(tree.frames().size(), 8U);
  for (const Frame& frame : tree.frames()) {
    const std::span<const std::uint32_t> samples = tree.samples(tree.nodes()[frame.node]);
    const Plane plane = mean_plane(shape, samples);
    double highest = 0, farthest = 0;
    for (const std::uint32_t i : samples) {
      const Vector apart = minus(vector(shape.positions, i), plane.centroid);
      highest = std::max(highest, std::abs(dot(apart, plane.normal)));
      farthest = std::max(farthest, std::sqrt(dot(apart, apart)));
      EXPECT_GT(dot(vector(shape.normals, i), plane.normal), delta_a - 1e-4);
    }
    EXPECT_LE(highest, delta_d * farthest + 1e-5);
    const Vector normal{frame.normal[0], frame.normal[1], frame.normal[2]};
    EXPECT_NEAR(dot(normal, plane.normal), 1, 1e-4);
  }
}

TEST(Tree, HasFramesThatAreOrthonormalAndHoldTheirSamples) {
  const Shape shape = torus(100);
  const Tree tree(shape.points(), {.threshold = 1e-3F});
  for (const Frame& frame : tree.frames()) {
    const auto wide = [](const std::array<float, 3>& a) { return Vector{a[0], a[1], a[2]}; };
    const Vector u = wide(frame.u), v = wide(frame.v), n = wide(frame.normal);
    EXPECT_NEAR(dot(u, u), 1, 1e-5);
    EXPECT_NEAR(dot(v, v), 1, 1e-5);
    EXPECT_NEAR(dot(u, v), 0, 1e-5);
    EXPECT_NEAR(dot(u, n), 0, 1e-5);
    EXPECT_EQ(tree.nodes()[frame.node].kind, Kind::transition);
    for (const std::uint32_t i : tree.samples(tree.nodes()[frame.node])) {
      const Vector apart = minus(vector(shape.positions, i), wide(frame.origin));
      EXPECT_GT(dot(apart, u), frame.low[0] - 1e-5);
      EXPECT_LT(dot(apart, v), frame.low[1] + frame.size[1] + 1e-5);
    }
  }
}

// The first axis of a frame is the direction in which a cylinder bends.
TEST(Tree, HasFramesAlongTheCurvature) {
  Shape cylinder;
  for (int i = 0; i < 40; ++i) {
    for (int k = 0; k < 40; ++k) {
      const float angle = 0.02F * static_cast<float>(i - 20), along = 0.02F * static_cast<float>(k);
      const float x = std::sin(angle), z = std::cos(angle);
      cylinder.positions.insert(cylinder.positions.end(), {0.8F * x - 0.6F * along, 0.6F * x + 0.8F * along, z});
      cylinder.normals.insert(cylinder.normals.end(), {0.8F * x, 0.6F * x, z});
    }
  }
  const Tree tree(cylinder.points(), {.delta_d = 1});
  ASSERT_EQ(tree.frames().size(), 1U);
  EXPECT_NEAR(std::abs(tree.frames()[0].u[0]), 0.8, 1e-3);
  EXPECT_NEAR(std::abs(tree.frames()[0].v[1]), 0.8, 1e-3);
}

bool same(const Tree& a, const Tree& b) {
  return a.nodes().size() == b.nodes().size() && a.order().size() == b.order().size() &&
         std::memcmp(a.order().data(), b.order().data(), a.order().size_bytes()) == 0 &&
         std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), [](const Node& p, const Node& q) {
           return p.begin == q.begin && p.end == q.end && p.first_child == q.first_child && p.frame == q.frame &&
                  p.error == q.error && p.kind == q.kind && p.level == q.level && p.children == q.children &&
                  p.joined == q.joined;
         });
}

// There are enough samples for several tasks.
TEST(Tree, IsTheSameForAnyNumberOfThreads) {
  const Shape shape = torus(500);
  for (const bool surface : {true, false}) {
    const Tree one(shape.points(), {.surface = surface, .threads = 1});
    for (const unsigned threads : {2U, 5U, 0U})
      EXPECT_TRUE(same(one, Tree(shape.points(), {.surface = surface, .threads = threads})));
  }
}

TEST(Tree, IsTheSameAtAnyScale) {
  const Shape shape = torus(200);
  const Tree tree(shape.points());
  for (const float scale : {1024.0F, 1.0F / 4096}) {
    Shape other = shape;
    for (float& number : other.positions) number *= scale;
    EXPECT_TRUE(same(tree, Tree(other.points())));
  }
  Shape other = shape;
  for (float& number : other.positions) number *= 1.7F;  // this rounds the positions
  const auto leaves = static_cast<double>(tree.leaf_count());
  EXPECT_NEAR(static_cast<double>(Tree(other.points()).leaf_count()), leaves, 0.01 * leaves);
}

TEST(Tree, TakesSixteenBytesASampleAtMost) {
  const Shape shape = sphere(200000);
  EXPECT_LE(Tree(shape.points(), {.threshold = 1e-4F}).bytes(), 16 * shape.size());
}

TEST(Tree, OfAHeightFieldIsAQuadtree) {
  Shape field = torus(64);
  for (std::size_t i = 0; i < field.positions.size(); i += 3) {
    const std::size_t row = i / 3 / 64;
    field.positions[i] = static_cast<float>(row);
    field.positions[i + 1] = static_cast<float>(i / 3 % 64);
    field.positions[i + 2] = std::sin(0.2F * field.positions[i]);
    field.normals[i] = -0.2F * std::cos(0.2F * field.positions[i]);
    field.normals[i + 1] = 0;
    field.normals[i + 2] = 1;
  }
  const Tree tree(field.points());
  EXPECT_EQ(tree.nodes()[0].kind, Kind::transition);
  EXPECT_EQ(tree.frames().size(), 1U);
}

TEST(Tree, HasFewerLeavesThanAnOctree) {
  const Shape shape = torus(700);
  const Tree tree(shape.points(), {.threshold = 3e-4F}), octree(shape.points(), {.surface = false, .threshold = 3e-4F});
  EXPECT_LT(static_cast<double>(tree.leaf_count()), 0.68 * static_cast<double>(octree.leaf_count()));
}

TEST(Tree, HasNoMoreLeavesThanAskedFor) {
  const Shape shape = torus(200);
  for (const std::uint32_t most : {1U, 10U, 500U, 5000U}) {
    const Tree tree(shape.points(), {.most_leaves = most});
    EXPECT_LE(tree.leaf_count(), most);
    EXPECT_GE(tree.leaf_count() + 3 + most / 20, most);
    for (const Frame& frame : tree.frames()) EXPECT_EQ(tree.nodes()[frame.node].kind, Kind::transition);
    EXPECT_NE(tree.leaf_of(shape.position(17)), none);
  }
}

TEST(Tree, KnowsWhatLiesOutside) {
  const Shape shape = sphere(1000);
  const Tree tree(shape.points());
  EXPECT_EQ(tree.leaf_of({3, 0, 0}), none);
  EXPECT_EQ(tree.leaf_of({std::nanf(""), 0, 0}), none);
  EXPECT_NE(tree.leaf_of({0, 0, 0}), none);  // the cell has no sample: the last node on the path to it
}

}  // namespace
}  // namespace glark::vstree::test
