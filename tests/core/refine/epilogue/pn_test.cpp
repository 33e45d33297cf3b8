// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refinement::pn: curved PN triangles against a reference in double precision, and the bits along shared edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

using Vector = std::array<double, 3>;
Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& a) { return 1 / std::sqrt(dot(a, a)) * a; }

struct Corner {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  Vector p() const { return {position[0], position[1], position[2]}; }
  Vector n() const { return unit({normal[0], normal[1], normal[2]}); }
};
using Triangle = std::array<Corner, 3>;

// Vlachos et al. 2001, written down as in the paper.
Vector reference_position(const Triangle& t, double w, double u, double v) {
  const auto b = [&](int i, int j) {
    return 1.0 / 3 * (2.0 * t[i].p() + t[j].p() - dot(t[j].p() - t[i].p(), t[i].n()) * t[i].n());
  };
  const Vector e = 1.0 / 6 * (b(0, 1) + b(1, 0) + b(1, 2) + b(2, 1) + b(2, 0) + b(0, 2));
  const Vector middle = 1.0 / 3 * (t[0].p() + t[1].p() + t[2].p());
  const Vector b111 = e + 0.5 * (e - middle);
  return w * w * w * t[0].p() + u * u * u * t[1].p() + v * v * v * t[2].p() + 3 * w * w * u * b(0, 1) +
         3 * w * u * u * b(1, 0) + 3 * u * u * v * b(1, 2) + 3 * u * v * v * b(2, 1) + 3 * v * v * w * b(2, 0) +
         3 * v * w * w * b(0, 2) + 6 * w * u * v * b111;
}

Vector reference_normal(const Triangle& t, double w, double u, double v) {
  const auto n = [&](int i, int j) {
    const Vector d = t[j].p() - t[i].p();
    return unit(t[i].n() + t[j].n() - 2 * dot(d, t[i].n() + t[j].n()) / dot(d, d) * d);
  };
  return unit(w * w * t[0].n() + u * u * t[1].n() + v * v * t[2].n() + w * u * n(0, 1) + u * v * n(1, 2) +
              v * w * n(2, 0));
}

struct Form {
  std::string source;
  Api api;
  std::string position, normal;
  bool homogeneous;
};
const std::vector<Form>& forms() {
  static const std::vector<Form> all = {
      {"varying vec3 p; varying vec3 n; void main() { p = gl_Vertex.xyz; n = gl_Normal; gl_Position = gl_Vertex; }",
       Api::compatibility, "gl_Vertex", "gl_Normal", true},
      {"#version 150\nin vec3 a; in vec3 b; out vec3 p; out vec3 n; void main() { p = a; n = b; gl_Position = "
       "vec4(1.0); }",
       Api::core, "a", "b", false},
      {"#version 450 core\nin vec4 a; in vec4 b; out vec3 p; out vec3 n; void main() { p = a.xyz; n = b.xyz * b.w; "
       "gl_Position = a; }",
       Api::core, "a", "b", true}};
  return all;
}

std::vector<float> widened(const std::array<float, 3>& v, bool to_four) {
  std::vector<float> words(v.begin(), v.end());
  if (to_four) words.push_back(1);
  return words;
}

Refined refine(const Form& form, const Triangle& t, const std::vector<std::array<float, 2>>& lattice,
               const std::array<float, 3>& w = {1, 1, 1}) {
  Experiment e;
  e.request.vertex_sources = {form.source};
  e.request.refinement = core::Refinement::pn;
  FieldValues position = {form.position,
                          form.homogeneous ? static_cast<GLenum>(GL_FLOAT_VEC4) : GL_FLOAT_VEC3,
                          {},
                          capture::Role::position};
  const bool wide_normal = form.normal == "b" && form.homogeneous;
  FieldValues normal = {
      form.normal, wide_normal ? static_cast<GLenum>(GL_FLOAT_VEC4) : GL_FLOAT_VEC3, {}, capture::Role::normal};
  for (int k = 0; k < 3; ++k) {
    position.corners[k] = widened(t[k].position, form.homogeneous);
    if (form.homogeneous) position.corners[k][3] = w[k];
    normal.corners[k] = widened(t[k].normal, wide_normal);
  }
  e.record = make_record({normal, position});
  e.varyings = {"p", "n"};
  e.captured_words = 6;
  e.lattice = lattice;
  return run(e);
}

std::vector<std::array<float, 2>> full_lattice(int segments) {
  std::vector<std::array<float, 2>> points;
  for (int i = 0; i <= segments; ++i) {
    for (int j = 0; i + j <= segments; ++j)
      points.push_back(
          {static_cast<float>(i) / static_cast<float>(segments), static_cast<float>(j) / static_cast<float>(segments)});
  }
  return points;
}

class Dice {
 public:
  Corner corner(double normal_length) {
    Corner c;
    for (float& x : c.position) x = number_(engine_);
    for (float& x : c.normal) x = static_cast<float>(normal_length) * number_(engine_);
    return c;
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<float> number_{-1, 1};
};

TEST(DerivePn, AgreesWithThePaper) {
  for (const Form& form : forms()) {
    ASSERT_TRUE(make_current(form.api));
    Dice dice;
    for (int round = 0; round < 4; ++round) {
      const Triangle t = {dice.corner(1), dice.corner(1), dice.corner(1)};
      const auto lattice = full_lattice(8);
      const Refined refined = refine(form, t, lattice);
      ASSERT_EQ(refined.error, "");
      for (std::size_t i = 0; i < lattice.size(); ++i) {
        const double u = lattice[i][0];
        const double v = lattice[i][1];
        const Vector p = reference_position(t, 1 - u - v, u, v);
        const Vector n = reference_normal(t, 1 - u - v, u, v);
        const auto& got = refined.values[i];
        const Vector got_normal = unit({got[3], got[4], got[5]});
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(got[axis], p[axis], 2e-6) << form.source;
          EXPECT_NEAR(got_normal[axis], n[axis], 2e-5) << form.source;
        }
      }
    }
  }
}

TEST(DerivePn, CornersAreReproducedExactly) {
  for (const Form& form : forms()) {
    ASSERT_TRUE(make_current(form.api));
    Dice dice;
    const Triangle t = {dice.corner(3), dice.corner(3), dice.corner(3)};
    const Refined refined = refine(form, t, {{0, 0}, {1, 0}, {0, 1}});
    ASSERT_EQ(refined.error, "");
    for (int k = 0; k < 3; ++k) {
      std::vector<float> expected(t[k].position.begin(), t[k].position.end());
      expected.insert(expected.end(), t[k].normal.begin(), t[k].normal.end());
      EXPECT_EQ(refined.values[k], expected);
    }
  }
}

// Lattice point at parameter s along the edge from corner k to corner k + 1.
std::array<float, 2> on_edge(int k, float s) {
  std::array<float, 3> weights = {};
  weights[k] = 1 - s;
  weights[(k + 1) % 3] = s;
  return {weights[1], weights[2]};
}

void expect_same_edge(const Form& form, bool mixed_w) {
  Dice dice;
  for (int round = 0; round < 3; ++round) {
    const Corner a = dice.corner(2);
    const Corner b = dice.corner(1);
    const Corner c = dice.corner(1);
    const Corner d = dice.corner(4);
    std::vector<Refined> seen;
    for (int side = 0; side < 2; ++side) {
      for (int rotation = 0; rotation < 3; ++rotation) {
        Triangle t;
        t[rotation] = side == 0 ? a : b;
        t[(rotation + 1) % 3] = side == 0 ? b : a;
        t[(rotation + 2) % 3] = side == 0 ? c : d;
        std::array<float, 3> w = {1, 1, 1};
        if (mixed_w) w[(rotation + 2) % 3] = side == 0 ? 1.0F : 2.0F;
        std::vector<std::array<float, 2>> lattice;
        // Odd multiples of 2^-15, too: there the products of weights are rounded.
        for (int i = 0; i <= 32; ++i) {
          const int s = std::min(i * 1023 + (i % 2), 32768);
          lattice.push_back(on_edge(rotation, static_cast<float>(side == 0 ? s : 32768 - s) / 32768));
        }
        seen.push_back(refine(form, t, lattice, w));
        ASSERT_EQ(seen.back().error, "");
      }
    }
    for (const Refined& other : seen) {
      for (std::size_t i = 0; i < other.values.size(); ++i) {
        for (int word = 0; word < 6; ++word) {
          ASSERT_EQ(std::bit_cast<int>(other.values[i][word]), std::bit_cast<int>(seen[0].values[i][word]))
              << form.source << i;
        }
      }
    }
  }
}

TEST(DerivePn, AnEdgeHasTheSameBitsFromBothTrianglesInEveryRotation) {
  for (const Form& form : forms()) {
    ASSERT_TRUE(make_current(form.api));
    expect_same_edge(form, false);
  }
}

TEST(DerivePn, AnEdgeIsNotAffectedByTheWOfTheThirdCorner) {
  ASSERT_TRUE(make_current(Api::compatibility));
  expect_same_edge(forms()[0], true);
}

TEST(DerivePn, AnEdgeBetweenDifferentWStaysStraightInHomogeneousSpace) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const Triangle t = {Corner{{0, 0, 0}, {-1, 0, 1}}, Corner{{1, 0, 0}, {1, 0, 1}}, Corner{{0, 1, 0}, {0, 1, 1}}};
  const Refined mixed = refine(forms()[0], t, {{0.5F, 0}}, {1, 2, 1});
  const Refined equal = refine(forms()[0], t, {{0.5F, 0}}, {2, 2, 2});
  ASSERT_EQ(mixed.error + equal.error, "");
  EXPECT_NEAR(mixed.values[0][2], 0.0F, 1e-6F);
  EXPECT_GT(equal.values[0][2], 0.1F);
}

TEST(DerivePn, EdgesAreCurved) {
  ASSERT_TRUE(make_current(Api::core));
  const Triangle t = {Corner{{0, 0, 0}, {-1, 0, 1}}, Corner{{1, 0, 0}, {1, 0, 1}}, Corner{{0, 1, 0}, {0, 1, 1}}};
  const Refined refined = refine(forms()[1], t, {{0.5F, 0}});
  ASSERT_EQ(refined.error, "");
  EXPECT_GT(refined.values[0][2], 0.1F);
}

TEST(DerivePn, ZeroNormalsAndDegenerateEdgesStayLinearWithoutNan) {
  for (const Form& form : forms()) {
    ASSERT_TRUE(make_current(form.api));
    const Triangle zero = {Corner{{0, 0, 0}, {0, 0, 0}}, Corner{{4, 0, 0}, {0, 0, 0}}, Corner{{0, 8, 0}, {0, 0, 0}}};
    const Refined linear = refine(form, zero, {{0.5F, 0.25F}});
    ASSERT_EQ(linear.error, "");
    EXPECT_EQ(linear.values[0], (std::vector<float>{2, 2, 0, 0, 0, 0}));
    Triangle point = zero;
    for (Corner& c : point) c = {{1, 2, 3}, {0, 0, 5}};
    const Refined degenerate = refine(form, point, full_lattice(4));
    ASSERT_EQ(degenerate.error, "");
    for (const auto& value : degenerate.values) {
      const std::vector<float> expected = {1, 2, 3, 0, 0, 5};
      for (int word = 0; word < 6; ++word) EXPECT_FLOAT_EQ(value[word], expected[word]);
    }
  }
}

TEST(DerivePn, NormalsKeepTheirLength) {
  ASSERT_TRUE(make_current(Api::core));
  const Triangle t = {Corner{{0, 0, 0}, {-1, 0, 1}}, Corner{{1, 0, 0}, {2, 0, 2}}, Corner{{0, 1, 0}, {0, 1, 1}}};
  const Refined refined = refine(forms()[1], t, {{0.5F, 0}});
  ASSERT_EQ(refined.error, "");
  EXPECT_NEAR(std::hypot(refined.values[0][3], refined.values[0][4], refined.values[0][5]), 1.5 * std::sqrt(2.0), 1e-5);
}

TEST(DerivePn, WithoutANormalTheInputsAreLinear) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e;
  e.request.vertex_sources = {"void main() { gl_Position = gl_Vertex; }"};
  e.request.refinement = core::Refinement::pn;
  e.record = make_record(
      {{"gl_Vertex", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {8, 0, 2, 1}, {0, 16, 4, 1}}}, capture::Role::position}});
  e.varyings = {"gl_Position"};
  const Refined refined = run(e);
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{4, 4, 2, 1}));
}

}  // namespace
}  // namespace glark::refine::test
