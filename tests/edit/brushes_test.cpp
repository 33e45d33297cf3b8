// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each brush against what it must do to known surfaces.
#include <limits>

#include "tests/edit/samplings.h"

namespace glark::edit {
namespace {

TEST(Paint, ChangesTheSamplesOfTheBall) {
  Editor editor(sphere(500));
  EXPECT_TRUE(editor.colours().empty());
  apply(editor, "paint 0.2 0 1 0.5 255 0 10");
  ASSERT_EQ(editor.colours().size(), 3000U);
  std::size_t painted = 0;
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const bool inside = distance(position(editor.positions(), i), {0.2, 0, 1}) <= 0.5;
    painted += inside ? 1 : 0;
    EXPECT_EQ(editor.colours()[3 * i + 1], inside ? 0 : 255) << i;
    EXPECT_EQ(editor.colours()[3 * i + 2], inside ? 10 : 255) << i;
  }
  EXPECT_GT(painted, 20U);
  EXPECT_TRUE(std::equal(editor.positions().begin(), editor.positions().end(), editor.positions_before().begin()));
}

TEST(Paint, MixesByItsStrength) {
  Sampling one{{0, 0, 0}, {0, 0, 1}, {200, 100, 0}, {}};
  Editor editor(one);
  apply(editor, "paint 0 0 0 1 100 200 255 0.25");
  EXPECT_EQ(editor.colours()[0], 175);
  EXPECT_EQ(editor.colours()[1], 125);
  EXPECT_EQ(editor.colours()[2], 64);
  EXPECT_EQ(editor.colours_before()[0], 200);
}

TEST(Inflate, MovesAlongTheNormals) {
  Editor editor(sphere(500));
  const Vector3d centre = position(editor.positions(), 40);
  editor.apply(Inflate{{common::to_array(centre), 0.4}, 0.125});
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d before = position(editor.positions_before(), i), after = position(editor.positions(), i);
    const double x = distance(before, centre) / 0.4, rest = 1 - x * x;
    const double amount = rest > 0 ? 0.125 * rest * rest : 0;
    EXPECT_LT(distance(after, before * (1 + amount)), 1e-7) << i;  // normals are floats
  }
  EXPECT_NEAR(distance(position(editor.positions(), 40), {}), 1.125, 1e-7);
}

TEST(Inflate, TurnsNormals) {
  Editor editor(plane(41));
  apply(editor, "inflate 0 0 0 0.8 0.3");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d p = position(editor.positions(), i);
    const double rest = 1 - (p.x * p.x + p.y * p.y) / 0.64;  // the height is 0.3 rest^2
    const double slope = rest > 0 ? -0.3 * 2 * rest * 2 / 0.64 : 0;
    const Vector3d wanted = common::unit(Vector3d{-slope * p.x, -slope * p.y, 1});
    const auto n = common::vector_at(editor.normals(), i);
    EXPECT_GT(wanted.x * n.x + wanted.y * n.y + wanted.z * n.z, std::cos(0.06)) << i;
    EXPECT_NEAR(common::length(n), 1, 1e-6);
  }
}

TEST(Move, FollowsTheFalloff) {
  Editor editor(plane(21));
  apply(editor, "move 0 0 0 0.5 0.1 0.2 -0.3");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d before = position(editor.positions_before(), i);
    const double rest = std::max(0.0, 1 - common::dot(before, before) / 0.25);
    EXPECT_LT(distance(position(editor.positions(), i), before + Vector3d{0.1, 0.2, -0.3} * (rest * rest)), 1e-12);
  }
}

TEST(Smooth, KeepsAPlane) {
  Editor editor(plane(21));
  const std::string before = bytes_of(editor);
  apply(editor, "smooth 1 0 0 0.7");
  for (std::size_t i = 0; i < editor.size(); ++i)
    EXPECT_EQ(position(editor.positions(), i), position(editor.positions_before(), i));
}

// The sum of the squared differences of the heights of neighbours.
double roughness(const Editor& editor, std::size_t side) {
  double sum = 0;
  for (std::size_t i = 0; i + side < editor.size(); ++i) {
    const double z = editor.positions()[3 * i + 2];
    if (i % side + 1 < side) sum += std::pow(z - editor.positions()[3 * (i + 1) + 2], 2);
    sum += std::pow(z - editor.positions()[3 * (i + side) + 2], 2);
  }
  return sum;
}

TEST(Smooth, LowersTheEnergy) {
  Sampling rough = plane(31);
  for (std::size_t i = 0; i < rough.positions.size() / 3; ++i)
    rough.positions[3 * i + 2] = 0.01 * static_cast<double>((i * 7919) % 13);
  Editor editor(rough);
  double last = roughness(editor, 31);
  const double first = last;
  for (int stroke = 0; stroke < 4; ++stroke) {
    apply(editor, "smooth 0 0 0 2");
    const double now = roughness(editor, 31);
    EXPECT_LT(now, last);
    last = now;
  }
  EXPECT_LT(last, 0.1 * first);
}

TEST(Smooth, KeepsWhatIsOutside) {
  Sampling rough = plane(31);
  for (std::size_t i = 0; i < rough.positions.size() / 3; ++i)
    rough.positions[3 * i + 2] = 0.01 * static_cast<double>((i * 7919) % 13);
  Editor editor(rough);
  apply(editor, "smooth 0 0 0 0.5");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d before = position(editor.positions_before(), i);
    if (common::length(before) > 0.5) {
      EXPECT_EQ(position(editor.positions(), i), before) << i;
    }
  }
}

TEST(Brushes, NeedSamples) {
  Editor editor(plane(5));
  const std::string before = bytes_of(editor);
  for (const char* line : {"paint 9 0 0 1 1 2 3", "inflate 9 0 0 1 1", "smooth 9 0 0 1", "move 9 0 0 1 1 1 1",
                           "deform 9 0 0 1 0 0 0 1 1 1 1"})
    EXPECT_EQ(problem_of([&] { apply(editor, line); }),
              "no sample is within 1 of 9 0 0; the samples lie from -1 -1 0 to 1 1 0");
  EXPECT_EQ(bytes_of(editor), before);
  EXPECT_EQ(editor.undo_count(), 0U);
}

TEST(Brushes, BadNumbersOfAProgramAreRejected) {
  Editor editor(plane(5));
  const std::string before = bytes_of(editor);
  EXPECT_NE(problem_of([&] { editor.apply(Inflate{{{0, 0, 0}, -1}, 1}); }).find("RADIUS is -1"), std::string::npos);
  EXPECT_NE(problem_of([&] { editor.apply(Move{{{0, 0, 0}, 1}, {NAN, 0, 0}}); }).find("DX"), std::string::npos);
  EXPECT_NE(problem_of([&] { editor.apply(Symmetric{true, 3, 0}); }).find("axis"), std::string::npos);
  EXPECT_NE(problem_of([&] { apply(editor, "move 0 0 0 1 1e300 0 0"); }).find("smaller numbers"), std::string::npos);
  EXPECT_NE(problem_of([&] { apply(editor, "refine 0 0 0 1"); }).find("open a session"), std::string::npos);
  EXPECT_EQ(bytes_of(editor), before);
}

TEST(Samplings, BadArraysAreRejected) {
  const auto problem = [](const Sampling& sampling) { return problem_of([&] { Editor editor(sampling); }); };
  EXPECT_NE(problem({}).find("no samples"), std::string::npos);
  EXPECT_NE(problem({{0, 0}, {}, {}, {}}).find("three for each"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0}, {1}, {}, {}}).find("normals has 1"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0}, {}, {1}, {}}).find("colours has 1"), std::string::npos);
  EXPECT_NE(problem({{0, 0, NAN}, {}, {}, {}}).find("coordinate nan"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0}, {}, {}, {0, 0}}).find("triangles has 2"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0}, {}, {}, {0, 0, 1}}).find("has the index 1"), std::string::npos);
}

// Many exporters write zero for a normal that they do not know.
TEST(Brushes, NormalsThatAreMissingAreEstimated) {
  for (const float missing : {0.0F, std::numeric_limits<float>::quiet_NaN()}) {
    Sampling sampling = sphere(2000);
    std::fill(sampling.normals.begin(), sampling.normals.end(), missing);
    Editor editor(sampling);
    editor.apply(parse("inflate 0 0 1 0.5 0.1"));
    double farthest = 0;
    for (std::size_t i = 0; i < editor.size(); ++i) {
      const double* p = &editor.positions()[3 * i];
      farthest = std::max(farthest, std::hypot(p[0], p[1], p[2]));
    }
    EXPECT_NEAR(farthest, 1.1, 0.01);
  }
}

}  // namespace
}  // namespace glark::edit
