// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Bends and twists against their formulas, and deformed regions.
#include "tests/edit/samplings.h"

namespace glark::edit {
namespace {

TEST(Bend, IsAnArc) {
  Editor editor(plane(21));
  apply(editor, "bend -0.5 0 0 0.5 0 0 0 0 1 90");
  const double radius = 1 / (std::numbers::pi / 2);
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d p = position(editor.positions_before(), i);
    const double phi = std::clamp(p.x + 0.5, 0.0, 1.0) * std::numbers::pi / 2, beyond = std::max(0.0, p.x - 0.5);
    Vector3d wanted{-0.5 + radius * std::sin(phi) + beyond * std::cos(phi), p.y,
                    radius * (1 - std::cos(phi)) + beyond * std::sin(phi)};
    if (p.x < -0.5) wanted = p;
    EXPECT_LT(distance(position(editor.positions(), i), wanted), 1e-12) << i;
    if (std::abs(p.x + 0.5) < 0.2 || std::abs(p.x - 0.5) < 0.2) continue;  // the neighbours are bent and flat
    const auto n = common::vector_at(editor.normals(), i);
    EXPECT_GT(-std::sin(phi) * n.x + std::cos(phi) * n.z, 0.999) << i;
  }
}

TEST(Bend, KeepsHeights) {
  Sampling two{{0.5, 0, 0, 0.5, 0, 0.25}, {0, 0, 1, 0, 0, 1}, {}, {}};
  Editor editor(two);
  apply(editor, "bend 0 0 0 1 0 0 0 0 3 180");  // the radius is 1 / pi, and the middle turns by 90 degrees
  const double radius = 1 / std::numbers::pi;
  EXPECT_LT(distance(position(editor.positions(), 0), {radius, 0, radius}), 1e-12);
  EXPECT_LT(distance(position(editor.positions(), 1), {radius - 0.25, 0, radius}), 1e-12);
}

TEST(Twist, TurnsByTheHeight) {
  Editor editor(sphere(300));
  apply(editor, "twist 0 0 -0.5 0 0 0.5 60");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d p = position(editor.positions_before(), i);
    const double turn = std::clamp(p.z + 0.5, 0.0, 1.0) * std::numbers::pi / 3;
    const Vector3d wanted{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
                          p.z};
    EXPECT_LT(distance(position(editor.positions(), i), wanted), 1e-12) << i;
  }
}

TEST(Bend, NeedsALineAndADirection) {
  Editor editor(plane(5));
  EXPECT_NE(problem_of([&] { apply(editor, "bend 0 0 0 0 0 0 0 0 1 90"); }).find("one place"), std::string::npos);
  EXPECT_NE(problem_of([&] { apply(editor, "bend 0 0 0 1 0 0 2 0 0 90"); }).find("to its side"), std::string::npos);
  EXPECT_NE(problem_of([&] { apply(editor, "twist 1 1 1 1 1 1 90"); }).find("one place"), std::string::npos);
  EXPECT_EQ(editor.undo_count(), 0U);
}

TEST(Deform, HandleMovesAndFrozenPartStays) {
  Editor editor(plane(61));
  apply(editor, "deform 0 0 0 0.2 0 0 0 0.8 0.1 0 0.5");
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d before = position(editor.positions_before(), i), after = position(editor.positions(), i);
    const double r = common::length(before);
    if (r <= 0.2) {
      EXPECT_LT(distance(after, before + Vector3d{0.1, 0, 0.5}), 1e-15) << i;
    }
    if (r > 0.8) {
      EXPECT_EQ(after, before) << i;
    }
    EXPECT_GT(after.z, -0.02) << i;
    EXPECT_LT(after.z, 0.52) << i;
  }
}

// The height over a ring between two circles has no crease at either one: the plate of the analytic solution.
TEST(Deform, IsAsSmoothAsAThinPlate) {
  Editor editor(plane(101));
  apply(editor, "deform 0 0 0 0.2 0 0 0 0.8 0 0 1");
  // f(r) = a + b r^2 + c ln r + d r^2 ln r with f(0.2) = 1, f(0.8) = 0 and no slope at both.
  const double a = 0.2, b = 0.8, la = std::log(a), lb = std::log(b);
  double rows[4][5] = {{1, a * a, la, a * a * la, 1},
                       {1, b * b, lb, b * b * lb, 0},
                       {0, 2 * a, 1 / a, 2 * a * la + a, 0},
                       {0, 2 * b, 1 / b, 2 * b * lb + b, 0}};
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int j = k; j < 4; ++j)
      if (std::abs(rows[j][k]) > std::abs(rows[pivot][k])) pivot = j;
    std::swap(rows[k], rows[pivot]);
    for (int j = 0; j < 4; ++j)
      for (int c = 4; j != k && c >= k; --c) rows[j][c] -= rows[k][c] * rows[j][k] / rows[k][k];
  }
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const double r = common::length(position(editor.positions_before(), i));
    if (r < 0.2 || r > 0.8) continue;
    const double terms[4] = {1, r * r, std::log(r), r * r * std::log(r)};
    double wanted = 0;
    for (int k = 0; k < 4; ++k) wanted += rows[k][4] / rows[k][k] * terms[k];
    EXPECT_NEAR(editor.positions()[3 * i + 2], wanted, 0.03) << r;
  }
}

TEST(Deform, RigidMotionsOfTheWholeAreExact) {
  Editor editor(sphere(1000));
  apply(editor, "deform 0 0 1 0.3 0 0 0 10 1 2 3 0 0 1 90");  // nothing is frozen
  for (std::size_t i = 0; i < editor.size(); ++i) {
    const Vector3d p = position(editor.positions_before(), i);
    EXPECT_LT(distance(position(editor.positions(), i), {1 - p.y, 2 + p.x, 3 + p.z}), 1e-9) << i;
    const auto before = common::vector_at(editor.normals_before(), i), n = common::vector_at(editor.normals(), i);
    EXPECT_LT(common::length(n - common::Vector3f{-before.y, before.x, before.z}), 1e-5F) << i;
  }
}

TEST(Deform, KeepsOtherParts) {
  Sampling both = plane(21);
  const Sampling other = plane(21);
  for (std::size_t i = 0; i < other.positions.size(); ++i)
    both.positions.push_back(other.positions[i] + (i % 3 == 2 ? 0.5 : 0));
  both.normals.insert(both.normals.end(), other.normals.begin(), other.normals.end());
  Editor editor(both);
  apply(editor, "deform 0 0 0 0.2 0 0 0 0.9 0 0 -0.5");
  for (std::size_t i = 441; i < 882; ++i)
    EXPECT_EQ(position(editor.positions(), i), position(editor.positions_before(), i));
  EXPECT_NEAR(editor.positions()[3 * 220 + 2], -0.5, 1e-12);
}

TEST(Deform, NeedsAnAxisForAnAngle) {
  Editor editor(plane(5));
  EXPECT_NE(problem_of([&] { apply(editor, "deform 0 0 0 0.6 0 0 0 1 0 0 1 0 0 0 5"); }).find("axis"),
            std::string::npos);
}

// The samples 2 i and 2 i + 1 are mirrored.
TEST(Symmetric, EditsAreMirrored) {
  const Sampling pairs = sphere(500);
  for (const char* line : {"inflate 0.7 0 0.7 0.5 0.2", "inflate 0.1 0 1 0.5 0.2", "move 0.5 0.2 0.8 0.9 0.3 0.1 0.2",
                           "smooth 0.7 0 0.7 0.8", "bend 0.1 0 0 1 0.2 0 0 0 1 40", "twist 0.2 0 -0.5 0.3 0.1 0.5 60",
                           "paint 0.7 0 0.7 0.5 1 2 3", "deform 0.7 0 0.7 0.2 0.7 0 0.7 0.6 0.2 0.1 0.2 1 2 3 30"}) {
    Editor editor(pairs);
    apply(editor, "symmetric on x");
    apply(editor, line);
    double greatest = 0;
    for (std::size_t i = 0; i < editor.size(); i += 2) {
      const Vector3d a = position(editor.positions(), i), b = position(editor.positions(), i + 1);
      EXPECT_LT(distance(a, {-b.x, b.y, b.z}), 1e-12) << line;
      greatest = std::max(greatest, distance(a, position(editor.positions_before(), i)));
      if (editor.colours().empty()) continue;
      EXPECT_EQ(editor.colours()[3 * i], editor.colours()[3 * i + 3]);
      greatest = std::max(greatest, 255.0 - editor.colours()[3 * i]);
    }
    EXPECT_GT(greatest, 0.001) << line;
  }
}

TEST(Symmetric, CanBeSwitchedOffAndMoved) {
  Editor editor(sphere(500));
  apply(editor, "symmetric on z 0.25");
  EXPECT_EQ(editor.symmetric().axis, 2U);
  apply(editor, "paint 0 0 1 0.3 0 0 0");  // the mirrored ball is around 0 0 -0.5
  std::size_t below = 0;
  for (std::size_t i = 0; i < editor.size(); ++i)
    below += editor.positions()[3 * i + 2] < 0 && editor.colours()[3 * i] == 0;
  EXPECT_EQ(below, 0U);
  apply(editor, "paint 0 0 1.3 0.5 0 0 0");  // around 0 0 -0.8
  for (std::size_t i = 0; i < editor.size(); ++i)
    below += editor.positions()[3 * i + 2] < 0 && editor.colours()[3 * i] == 0;
  EXPECT_GT(below, 0U);
  apply(editor, "symmetric off");
  const std::string last = bytes_of(editor);
  apply(editor, "move 0 0 1 0.3 0 0 1");
  for (std::size_t i = 0; i < editor.size(); ++i)
    if (editor.positions_before()[3 * i + 2] < 0) {
      EXPECT_EQ(position(editor.positions(), i), position(editor.positions_before(), i));
    }
}

}  // namespace
}  // namespace glark::edit
