// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement by a texture (11.R.7b), read back through transform feedback: positions against the heights, normals
// against finite differences of the positions, and the bits along edges.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "tests/core/support/osmesa_context.h"
#include "tests/core/support/refined_capture.h"

namespace glark::core::test {
namespace {

using Three = std::array<GLfloat, 3>;

struct Vertex {
  Three position;
  Three normal;
  std::array<GLfloat, 2> texture_coordinate;
  Three weights;
  GLfloat triangle;
};

enum class Shown { position, normal };
enum class Dialect { glsl_120, glsl_450 };

GLuint link_displaced_program(Shown shown, Dialect dialect) {
  const std::string value = shown == Shown::position ? "position" : "normal";
  const bool old = dialect == Dialect::glsl_120;
  const std::string in = old ? "attribute" : "in";
  const std::string out = old ? "varying" : "out";
  return link_program(
      {.vertex = (old ? "#version 120\n" : "#version 450 core\n") + in + " vec3 position; " + in + " vec3 normal; " +
                 in + " vec2 texcoord; " + in + " vec3 weights; " + in + " float triangle;\n" + out +
                 " vec3 passed_weights; " + out + " float passed_triangle;\nvoid main() { gl_Position = vec4(" + value +
                 ", position.x + normal.x + texcoord.x);\n  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = old ? "" : "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "texcoord", "weights", "triangle"}});
}

void append(std::vector<Vertex>& mesh, const std::array<Vertex, 3>& corners, int number) {
  for (std::size_t k = 0; k < 3; ++k) {
    mesh.push_back(corners[k]);
    mesh.back().weights = {};
    mesh.back().weights[k] = 1;
    mesh.back().triangle = static_cast<GLfloat>(number);
  }
}

std::vector<RefinedVertex> refine(const std::vector<Vertex>& mesh, Shown shown, Dialect dialect = Dialect::glsl_450) {
  glUseProgram(link_displaced_program(shown, dialect));
  make_buffer(GL_ARRAY_BUFFER, mesh);
  const GLint sizes[] = {3, 3, 2, 3, 1};
  std::size_t offset = 0;
  for (GLuint i = 0; i < 5; ++i) {
    glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, sizeof(Vertex), byte_offset(offset));
    glEnableVertexAttribArray(i);
    offset += static_cast<std::size_t>(sizes[i]) * sizeof(GLfloat);
  }
  const auto count = static_cast<GLsizei>(mesh.size());
  return capture_refined(mesh.size() * 400, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
}

constexpr int texels = 64;

// A height for every texel, in the channel asked for; the others hold something else.
void upload_heights(GLuint unit, std::size_t channel, const std::function<float(float, float)>& height) {
  std::vector<std::array<float, 4>> image;
  for (int t = 0; t < texels; ++t) {
    for (int s = 0; s < texels; ++s) {
      const auto center = [](int i) { return (static_cast<float>(i) + 0.5F) / texels; };
      image.push_back({7, 7, 7, 7});
      image.back().at(channel) = height(center(s), center(t));
    }
  }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texels, texels, 0, GL_RGBA, GL_FLOAT, image.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glActiveTexture(GL_TEXTURE0);
}

class Displacement : public testing::Test {
 protected:
  Displacement() {
    glARKinit(5);
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
    glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 4);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
  }
  OsmesaContext context_{Profile::compatibility};
};

// Two triangles of the plane z = 0.5, with the texture over them.
std::vector<Vertex> terrain() {
  const auto at = [](float x, float y) { return Vertex{{4 * x, 4 * y, 0.5F}, {0, 0, 2}, {x, y}, {}, 0}; };
  std::vector<Vertex> mesh;
  append(mesh, {at(0.1F, 0.1F), at(0.9F, 0.1F), at(0.9F, 0.9F)}, 0);
  append(mesh, {at(0.1F, 0.1F), at(0.9F, 0.9F), at(0.1F, 0.9F)}, 1);
  return mesh;
}

float hills(float s, float t) { return std::sin(5 * s) * std::cos(4 * t); }

TEST_F(Displacement, TerrainHasTheHeightsOfTheTexture) {
  for (const Dialect dialect : {Dialect::glsl_120, Dialect::glsl_450}) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      upload_heights(3, channel, hills);
      glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 3);
      glARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, static_cast<GLint>(GL_RED + channel));
      glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
      glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.25F);
      const std::vector<RefinedVertex> refined = refine(terrain(), Shown::position, dialect);
      ASSERT_EQ(refined.size(), 2U * 256 * 3);
      for (const RefinedVertex& vertex : refined) {
        const auto& [x, y, z, other] = vertex.position;
        ASSERT_NEAR(z, 0.5F + 0.5F * hills(x / 4, y / 4) + 0.25F, 2e-3F) << "channel " << channel;
      }
    }
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(Displacement, TerrainHasTheNormalsOfTheGraph) {
  upload_heights(0, 0, hills);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  const auto positions = refine(terrain(), Shown::position);
  const auto normals = refine(terrain(), Shown::normal);
  ASSERT_EQ(positions.size(), normals.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float s = positions[i].position[0] / 4;
    const float t = positions[i].position[1] / 4;
    const float slope_x = 0.5F * 5 * std::cos(5 * s) * std::cos(4 * t) / 4;
    const float slope_y = 0.5F * -4 * std::sin(5 * s) * std::sin(4 * t) / 4;
    const float size = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
    EXPECT_NEAR(normals[i].position[0], -2 * slope_x / size, 0.02F);
    EXPECT_NEAR(normals[i].position[1], -2 * slope_y / size, 0.02F);
    EXPECT_NEAR(normals[i].position[2], 2 / size, 0.02F) << "as long as the normal that was given";
  }
}

std::array<double, 3> difference(const RefinedVertex& a, const RefinedVertex& b) {
  return {double{a.position[0]} - b.position[0], double{a.position[1]} - b.position[1],
          double{a.position[2]} - b.position[2]};
}

// The greatest angle, in degrees, between the normals and those of finite differences of the positions, at the inner
// vertices of the patterns.
double worst_angle(const std::vector<Vertex>& mesh) {
  using Place = std::array<int, 3>;  // triangle, 16 u, 16 v
  std::map<Place, RefinedVertex> positions;
  std::map<Place, RefinedVertex> normals;
  const auto place = [](const RefinedVertex& v) {
    return Place{static_cast<int>(v.triangle), static_cast<int>(std::lround(16 * v.weights[1])),
                 static_cast<int>(std::lround(16 * v.weights[2]))};
  };
  for (const RefinedVertex& v : refine(mesh, Shown::position)) positions[place(v)] = v;
  for (const RefinedVertex& v : refine(mesh, Shown::normal)) normals[place(v)] = v;
  double worst = 0;
  for (const auto& [at, normal] : normals) {
    const auto [triangle, u, v] = at;
    if (u < 1 || v < 1 || u + v > 15) continue;
    const auto du = difference(positions.at({triangle, u + 1, v}), positions.at({triangle, u - 1, v}));
    const auto dv = difference(positions.at({triangle, u, v + 1}), positions.at({triangle, u, v - 1}));
    const std::array<double, 3> across = {du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
                                          du[0] * dv[1] - du[1] * dv[0]};
    double along = 0;
    double size = 0;
    double other = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along += across[axis] * normal.position[axis];
      size += across[axis] * across[axis];
      other += double{normal.position[axis]} * normal.position[axis];
    }
    worst = std::max(worst, std::acos(std::clamp(along / std::sqrt(size * other), -1.0, 1.0)) * 180 / M_PI);
  }
  return worst;
}

// A piece of the unit sphere, with its own normals; small enough that its PN triangle is almost the sphere.
std::vector<Vertex> piece_of_sphere() {
  std::array<Vertex, 3> corners{};
  const std::array<std::array<float, 2>, 3> places = {{{0.2F, 0.3F}, {0.6F, 0.35F}, {0.35F, 0.7F}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [a, b] = places[k];
    const Three p = {std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)};
    corners[k] = {p, p, {a, b}, {}, 0};
  }
  std::vector<Vertex> mesh;
  append(mesh, corners, 0);
  return mesh;
}

TEST_F(Displacement, NormalsOfCurvedSurfacesAreThoseOfFiniteDifferences) {
  upload_heights(0, 0, [](float s, float t) { return std::sin(9 * s + 3 * t); });
  for (const GLenum refinement : {GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK}) {
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
    glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0);
    glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
    EXPECT_LT(worst_angle(piece_of_sphere()), 2.5) << "of the base surface";
    glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.1F);
    glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.3F);
    EXPECT_LT(worst_angle(piece_of_sphere()), 3.0);
  }
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  EXPECT_GT(worst_angle(piece_of_sphere()), 5.0) << "control: smooth normals are not those of a flat triangle";
}

TEST_F(Displacement, SharedEdgesHaveTheSameBits) {
  upload_heights(0, 0, hills);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  std::mt19937 random(19);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto corner = [&] {
    Vertex v{};
    for (float& x : v.position) x = number(random);
    for (float& x : v.normal) x = number(random);
    for (float& x : v.texture_coordinate) x = number(random);
    return v;
  };
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK}) {
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
    std::vector<Vertex> mesh;
    for (int pair = 0; pair < 64; ++pair) {
      const Vertex a = corner();
      const Vertex b = corner();
      append(mesh, {a, b, corner()}, 2 * pair);
      append(mesh, {corner(), b, a}, 2 * pair + 1);
    }
    std::map<int, std::set<PositionBits>> along;
    for (RefinedVertex vertex : refine(mesh, Shown::position)) {
      vertex.position[3] = 0;  // holds the normal
      const bool second = static_cast<int>(vertex.triangle) % 2 != 0;
      if (vertex.weights[second ? 0 : 2] == 0) along[static_cast<int>(vertex.triangle)].insert(bits_of(vertex));
    }
    for (int pair = 0; pair < 64; ++pair) {
      EXPECT_EQ(along[2 * pair].size(), 17U);
      EXPECT_EQ(along[2 * pair], along[2 * pair + 1]) << pair;
    }
  }
}

TEST_F(Displacement, WithoutRefinementCornersMove) {
  upload_heights(0, 0, [](float, float) { return 1.0F; });
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  const auto refined = refine(terrain(), Shown::position);
  ASSERT_EQ(refined.size(), 6U);
  EXPECT_EQ(refined[0].position[2], 1.5F);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
  EXPECT_EQ(refine(terrain(), Shown::position)[0].position[2], 0.5F);
}

TEST_F(Displacement, ByAnAttributeThatTheProgramDoesNotRead) {
  upload_heights(0, 0, [](float s, float) { return s; });
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, 9);
  glVertexAttrib2f(9, 0.5F, 0.5F);
  for (const RefinedVertex& vertex : refine(terrain(), Shown::position)) ASSERT_NEAR(vertex.position[2], 1.0F, 1e-3F);
}

TEST_F(Displacement, TheFixedFunctionToo) {
  upload_heights(1, 0, [](float, float) { return 1.0F; });
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 1);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.25F);
  const auto pixels_of = [&](float normal) {
    glUseProgram(0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(1, 1, 1);
    glBegin(GL_TRIANGLE_STRIP);
    glNormal3f(normal, 0, 0);
    for (int corner = 0; corner < 4; ++corner) {
      const auto side = [corner](int bit) { return (corner & bit) != 0 ? 0.5F : -0.5F; };
      glTexCoord2f(0.5F + side(1), 0.5F + side(2));
      glVertex2f(side(1), side(2));
    }
    glEnd();
    std::vector<GLubyte> pixels(std::size_t{4} * picture_size * picture_size);
    glReadPixels(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  };
  EXPECT_NE(pixels_of(1), pixels_of(-1)) << "moved to the right and to the left";
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(Displacement, WithoutACoordinateNothingMoves) {
  upload_heights(0, 0, [](float, float) { return 1.0F; });
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  const GLuint program =
      link_program({.vertex = "#version 120\nattribute vec3 position; attribute vec3 normal;\n"
                              "varying vec3 passed_weights; varying float passed_triangle;\n"
                              "void main() { gl_Position = vec4(position, 1.0); passed_weights = normal;\n"
                              "  passed_triangle = 0.0; }\n",
                    .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
                    .attributes = {"position", "normal"}});
  refine(terrain(), Shown::position);
  glUseProgram(program);
  for (const RefinedVertex& vertex : capture_refined(10000, [] { glDrawArrays(GL_TRIANGLES, 0, 6); })) {
    ASSERT_EQ(vertex.position[2], 0.5F);
  }
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace
}  // namespace glark::core::test
