// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The effects of the extension's commands: tags from every source, parameters, refinement shaders.
#include <algorithm>
#include <cmath>

#include "tests/core/support/curved_program.h"
#include "tests/core/support/modes.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class Commands : public testing::Test {
 protected:
  Commands() {
    glARKinit(4);
    glEnable(GL_ARK);
  }
  template <typename Draw>
  static GLuint triangles_of(Draw&& draw) {
    picture_of(draw);
    return generated_primitives;
  }
  OsmesaContext context_{Profile::compatibility};
};

void emit_tagged_triangle(const std::array<GLuint, 3>& tag) {
  glBegin(GL_TRIANGLES);
  for (std::size_t i = 0; i < 3; ++i) {
    glDepthTag1i(tag[i]);
    emit(zigzag[i]);
  }
  glEnd();
}

TEST_F(Commands, TagsInBeginAndEnd) {
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({0, 0, 0}); }), 1U);
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({2, 2, 2}); }), 16U);
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({0, 1, 1}); }), 2U) << "depths 0, 1, 0";
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({4, 0, 0}); }), 7U) << "depths 2, 0, 2: 4 + 1 + 4 - 2";
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({3, 1, 1}); }), 8U) << "depths 2, 1, 2: 0 + 4 + 2 + 4 - 2";
}

TEST_F(Commands, CurrentTagCountsForAllVertices) {
  glDepthTag1i(3);
  EXPECT_EQ(triangles_of([] { draw_immediate(mode_shapes()[1]); }), 4U * 64);
  glDepthTag1i(0);
  EXPECT_EQ(triangles_of([] { draw_immediate(mode_shapes()[1]); }), 4U);
}

template <typename Tag>
GLuint triangles_with_array(GLenum type, const std::vector<Tag>& tags, GLsizei stride = 0) {
  point_conventional_arrays(zigzag);
  glDepthTagPointerARK(type, stride, tags.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  picture_of([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  return generated_primitives;
}

TEST_F(Commands, TagArraysOfEveryType) {
  EXPECT_EQ(triangles_with_array<GLubyte>(GL_UNSIGNED_BYTE, {3, 1, 1}), 8U);
  EXPECT_EQ(triangles_with_array<GLushort>(GL_UNSIGNED_SHORT, {3, 1, 1}), 8U);
  EXPECT_EQ(triangles_with_array<GLuint>(GL_UNSIGNED_INT, {3, 1, 1}), 8U);
  EXPECT_EQ(triangles_with_array<GLfloat>(GL_FLOAT, {2.5F, 1.4F, 0.5F}), 8U) << "rounded to the nearest, halves up";
  EXPECT_EQ(triangles_with_array<GLfloat>(GL_FLOAT, {4, -9, NAN}), 7U) << "clamped to 4, 0 and 0";
  EXPECT_EQ(triangles_with_array<GLuint>(GL_UNSIGNED_INT, {99, 4, 200}), 256U) << "clamped to the level of the pool";
  EXPECT_EQ(triangles_with_array<GLubyte>(GL_UNSIGNED_BYTE, {3, 9, 1, 9, 1, 9}, 2), 8U);
}

TEST_F(Commands, TagsOfMultiDrawsAndIndexedDraws) {
  const std::vector<GLubyte> tags = {1, 1, 1, 2, 2, 2};
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, tags.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  point_conventional_arrays(zigzag);
  const GLint first[] = {0, 3};
  const GLsizei count[] = {3, 3};
  EXPECT_EQ(triangles_of([&] { glMultiDrawArrays(GL_TRIANGLES, first, count, 2); }), 4U + 16);
  const GLubyte indices[] = {3, 4, 5, 0, 1, 2, 3, 5, 4};
  EXPECT_EQ(triangles_of([&] { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_BYTE, indices); }), 4U + 2 * 16);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glDrawArrays(GL_TRIANGLES, 0, 6);
  glEndList();
  glDisableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(triangles_of([&] { glCallList(list); }), 4U + 16) << "tags are compiled with the vertices";
}

TEST_F(Commands, TagsFromTheGenericAttribute) {
  EXPECT_EQ(triangles_of([] {
              glBegin(GL_TRIANGLES);
              for (int i = 0; i < 3; ++i) {
                glVertexAttrib1f(15, i == 0 ? 3.0F : 1.0F);
                emit(zigzag[i]);
              }
              glEnd();
            }),
            8U);
}

TEST_F(Commands, TagsPerInstance) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  make_buffer(GL_ARRAY_BUFFER, std::vector<ColoredVertex>{zigzag[0], zigzag[1], zigzag[2]});
  point_generic_arrays(nullptr);
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>{1, 2});
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glVertexAttribDivisor(15, 1);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(triangles_of([] { glDrawArraysInstanced(GL_TRIANGLES, 0, 3, 2); }), 4U + 16);
}

TEST_F(Commands, TagAttributeMoves) {
  glDepthTag1i(2);
  glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 7);
  GLint tag = -1;
  glGetIntegerv(GL_CURRENT_DEPTH_TAG_ARK, &tag);
  EXPECT_EQ(tag, 0) << "neither copied nor reset";
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({3, 1, 1}); }), 8U);
  point_conventional_arrays(zigzag);
  const GLubyte tags[] = {3, 1, 1};
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, tags);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(triangles_of([] { glDrawArrays(GL_TRIANGLES, 0, 3); }), 8U);
  glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 15);
  EXPECT_EQ(triangles_of([] { glDrawArrays(GL_TRIANGLES, 0, 3); }), 16U)
      << "the current tag of attribute 15 is still 2";
}

TEST_F(Commands, DrawArpRefinesWithArkDisabled) {
  glDisable(GL_ARK);
  glDepthTag1i(2);
  point_conventional_arrays(zigzag);
  const GLushort indices[] = {0, 1, 2, 2, 1, 3};
  EXPECT_EQ(triangles_of([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }), 4U);
  EXPECT_EQ(triangles_of([] { glDrawARP(GL_TRIANGLE_STRIP, 0, 6); }), 64U);
  EXPECT_EQ(triangles_of([&] { glDrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices); }), 32U);
  EXPECT_EQ(glIsEnabled(GL_ARK), GL_FALSE);
  EXPECT_EQ(triangles_of([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }), 4U);
}

TEST_F(Commands, UniformSource) {
  glDepthTag1i(3);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({3, 1, 1}); }), 1U);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({3, 1, 1}); }), 4U);
}

TEST_F(Commands, UniformLevelsToTheDeepest) {
  glARKinit(11);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  for (const GLint level : {7, 8, 9, 10}) {
    glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    EXPECT_EQ(triangles_of([] {
                draw_immediate({"", GL_TRIANGLES, 1, {zigzag[0], zigzag[1], zigzag[2]}});
              }),
              1U << (2 * level));
  }
}

TEST_F(Commands, InitAgainWithAnotherLevel) {
  glDepthTag1i(4);
  EXPECT_EQ(triangles_of([] { draw_immediate(mode_shapes()[0]); }), 2U * 256);
  glARKinit(1);
  EXPECT_EQ(triangles_of([] { draw_immediate(mode_shapes()[0]); }), 2U * 4);
  glARKinit(6);
  glDepthTag1i(6);
  EXPECT_EQ(triangles_of([] { draw_immediate(mode_shapes()[0]); }), 2U * 4096);
  const Picture refined = picture_of([] { draw_immediate(mode_shapes()[0]); });
  glDisable(GL_ARK);
  EXPECT_LE(differing_pixels(refined, picture_of([] { draw_immediate(mode_shapes()[0]); })), tolerated_pixels);
}

TEST_F(Commands, SmoothInteriorKeepsThePicture) {
  const auto draw = [] { emit_tagged_triangle({4, 4, 0}); };
  const Picture minimum = picture_of(draw);
  const GLuint fewest = generated_primitives;
  glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
  EXPECT_LE(differing_pixels(minimum, picture_of(draw)), tolerated_pixels);
  EXPECT_GE(generated_primitives, fewest);
  EXPECT_EQ(triangles_of([] { emit_tagged_triangle({3, 3, 3}); }), 64U) << "equal depths are the same for both";
}

// The centre of a quad split at its centroid has the mean of four colours; GL's own split gives the mean of two.
TEST_F(Commands, CentroidSplit) {
  const auto draw = [] {
    const GLfloat corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      glColor3f(i == 0 ? 1.0F : 0.0F, i == 1 ? 1.0F : 0.0F, i == 2 ? 1.0F : 0.0F);
      glVertex2fv(corners[i]);
    }
    glEnd();
  };
  glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  glDepthTag1i(2);
  const Picture picture = picture_of(draw);
  EXPECT_EQ(generated_primitives, 4U * 16);
  const std::size_t middle = 4 * (picture_size / 2 * picture_size + picture_size / 2);
  for (std::size_t channel = 0; channel < 3; ++channel) EXPECT_NEAR(picture[middle + channel], 64, 4);
}

std::vector<CurvedVertex> curved_triangle() {
  return {{{-1, -1, 0}, {-0.7F, -0.7F, 1}, {1, 0, 0}, 0, 3},
          {{1, -1, 0}, {0.7F, -0.7F, 1}, {0, 1, 0}, 0, 3},
          {{0, 1, 0}, {0, 1, 1}, {0, 0, 1}, 0, 3}};
}

TEST_F(Commands, CurvedRefinementBulges) {
  glUseProgram(link_curved_program(Language::glsl_120));
  upload(curved_triangle());
  const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 3); };
  const std::vector<RefinedVertex> flat = capture_refined(1000, draw);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  const std::vector<RefinedVertex> curved = capture_refined(1000, draw);
  ASSERT_EQ(flat.size(), 3U * 64);
  ASSERT_EQ(curved.size(), flat.size());
  GLfloat farthest = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    ASSERT_EQ(flat[i].weights, curved[i].weights) << "the order of a pattern does not change";
    const bool corner = *std::max_element(flat[i].weights.begin(), flat[i].weights.end()) == 1;
    const GLfloat distance = std::abs(curved[i].position[2] - flat[i].position[2]);
    if (!corner) farthest = std::max(farthest, distance);
  }
  EXPECT_GT(farthest, 0.05F);
}

GLint refinement_value(GLuint program, GLenum name) {
  GLint value = -1;
  glGetRefinementivARK(program, name, &value);
  return value;
}

TEST_F(Commands, RefinementShaderOfTheFixedFunction) {
  const char* const source = "void refine() { gl_Vertex.xy *= 0.5; gl_Color = vec4(ark_barycentric, 1.0); }\n";
  glDepthTag1i(2);
  const auto draw = [] {
    glBegin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {0.0F, 1.0F}}) glVertex2f(x, y);
    glEnd();
  };
  const Picture plain = picture_of(draw);
  glRefinementShaderSourceARK(0, 1, &source, nullptr);
  EXPECT_EQ(refinement_value(0, GL_REFINEMENT_SOURCE_LENGTH_ARK), static_cast<GLint>(std::string(source).size() + 1));
  EXPECT_EQ(refinement_value(0, GL_REFINEMENT_STATUS_ARK), GL_TRUE);
  const Picture refined = picture_of(draw);
  const std::size_t middle = 4 * (picture_size / 2 * picture_size + picture_size / 2);
  EXPECT_NEAR(refined[middle], 64, 8) << "w is a quarter in the middle of the halved triangle";
  EXPECT_NEAR(refined[middle + 2], 128, 8);
  const std::size_t below = 4 * (picture_size / 8 * picture_size + picture_size / 2);
  EXPECT_EQ(plain[below], 255) << "white";
  EXPECT_EQ(refined[below], 0) << "the refined triangle is half as large";
  glRefinementShaderSourceARK(0, 0, nullptr, nullptr);
  EXPECT_EQ(refinement_value(0, GL_REFINEMENT_SOURCE_LENGTH_ARK), 0);
  EXPECT_EQ(differing_pixels(plain, picture_of(draw)), 0);
}

// A point at each refined vertex has the size of the fixed function, for any setting of GL_PROGRAM_POINT_SIZE.
TEST_F(Commands, PointSizesOfTheFixedFunction) {
  const GLfloat attenuation[] = {1.5625F, 0, 0};
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  glPointSize(5);
  glDepthTag1i(1);
  const auto covered = [] {
    const Picture picture = picture_of([] {
      glBegin(GL_TRIANGLES);
      for (const auto& [x, y] : {std::pair{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.0F, 0.5F}}) glVertex2f(x, y);
      glEnd();
    });
    int pixels = 0;
    for (std::size_t i = 0; i < picture.size(); i += 4) pixels += picture[i] != 0 ? 1 : 0;
    return pixels;
  };
  EXPECT_EQ(covered(), 6 * 25);
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  EXPECT_EQ(covered(), 6 * 16);
  EXPECT_EQ(glIsEnabled(GL_PROGRAM_POINT_SIZE), GL_FALSE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  EXPECT_EQ(covered(), 6 * 16);
  EXPECT_EQ(glIsEnabled(GL_PROGRAM_POINT_SIZE), GL_TRUE);
}

class RefinementShaderCommands : public testing::TestWithParam<Language> {
 protected:
  RefinementShaderCommands() {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glARKinit(4);
    glEnable(GL_ARK);
    program_ = link_curved_program(GetParam());
    glUseProgram(program_);
    upload(curved_triangle());
  }
  GLfloat highest() const {
    GLfloat result = -9;
    for (const RefinedVertex& v : capture_refined(1000, [] { glDrawArrays(GL_TRIANGLES, 0, 3); }))
      result = std::max(result, v.weights[0]);
    return result;
  }
  OsmesaContext context_{GetParam() == Language::glsl_450_core ? Profile::core : Profile::compatibility};
  GLuint program_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, RefinementShaderCommands, testing::Values(Language::glsl_120, Language::glsl_450_core),
                         [](const testing::TestParamInfo<Language>& parameter) {
                           return parameter.param == Language::glsl_120 ? "glsl120" : "core";
                         });

TEST_P(RefinementShaderCommands, UniformOfItsOwn) {
  const char* const parts[] = {"uniform float lift;\nuniform float unused;\nvoid refine() { weights.x = ",
                               "ark_corner_weights[0].x + lift; }\nwaste"};
  const GLint lengths[] = {-1, 34};
  glRefinementShaderSourceARK(program_, 2, parts, lengths);
  EXPECT_EQ(refinement_value(program_, GL_REFINEMENT_STATUS_ARK), GL_TRUE);
  const GLint lift = glGetUniformLocation(program_, "lift");
  ASSERT_GE(lift, 0);
  EXPECT_EQ(glGetUniformLocation(program_, "no_such_uniform"), -1);
  glUniform1f(lift, 2);
  EXPECT_EQ(highest(), 3);
  glUniform1f(lift, 5);
  EXPECT_EQ(highest(), 6);
  glProgramUniform1f(program_, lift, 7);
  EXPECT_EQ(highest(), 8);
  EXPECT_EQ(pending_errors(), "");
  GLint active = -1;
  glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &active);
  EXPECT_EQ(active, 0) << "it is no uniform of the program";
}

TEST_P(RefinementShaderCommands, UniformWithEveryParameter) {
  const char* const source = "uniform float lift;\nvoid refine() { weights.x = ark_corner_weights[0].x + lift; }\n";
  glRefinementShaderSourceARK(program_, 1, &source, nullptr);
  EXPECT_EQ(refinement_value(program_, GL_REFINEMENT_STATUS_ARK), GL_TRUE);
  glUniform1f(glGetUniformLocation(program_, "lift"), 2);
  for (const auto& [name, value] : {std::pair{GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK},
                                    {GL_REFINEMENT_ARK, GL_CURVED_PN_ARK},
                                    {GL_WELD_ARK, GL_TRUE},
                                    {GL_GEOMORPH_ARK, GL_TRUE},
                                    {GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK}}) {
    glARKParameteriARK(static_cast<GLenum>(name), value);
    EXPECT_EQ(highest(), 3) << name;
  }
}

TEST_P(RefinementShaderCommands, KeptWhenLinkedAgainAndReplaced) {
  const char* source = "void refine() { weights.x = 4.0; }\n";
  glRefinementShaderSourceARK(program_, 1, &source, nullptr);
  EXPECT_EQ(highest(), 4);
  glLinkProgram(program_);
  glUseProgram(program_);
  EXPECT_EQ(highest(), 4);
  source = "void refine() { weights.x = 9.0; }\n";
  glRefinementShaderSourceARK(program_, 1, &source, nullptr);
  EXPECT_EQ(highest(), 9);
  glRefinementShaderSourceARK(program_, 0, nullptr, nullptr);
  EXPECT_EQ(highest(), 1);
}

TEST_P(RefinementShaderCommands, BrokenSourceIsNoGlError) {
  const char* const source = "void refine() { weights.x = no_such_name; }\n";
  glRefinementShaderSourceARK(program_, 1, &source, nullptr);
  EXPECT_EQ(refinement_value(program_, GL_REFINEMENT_STATUS_ARK), GL_FALSE);
  const GLint length = refinement_value(program_, GL_REFINEMENT_LOG_LENGTH_ARK);
  ASSERT_GT(length, 1);
  std::string log(static_cast<std::size_t>(length), '?');
  GLsizei written = 0;
  glGetRefinementInfoLogARK(program_, length, &written, log.data());
  EXPECT_EQ(written, length - 1);
  EXPECT_NE(log.find("no_such_name"), std::string::npos) << log;
  char cut[5] = "????";
  glGetRefinementInfoLogARK(program_, 3, &written, cut);
  EXPECT_EQ(written, 2);
  EXPECT_EQ(cut[2], '\0');
  EXPECT_EQ(highest(), 1) << "drawn unrefined";
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(RefinementShaderCommands, RunsAtDepthZeroToo) {
  const char* const source = "void refine() { weights.x = 4.0; }\n";
  glRefinementShaderSourceARK(program_, 1, &source, nullptr);
  glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(highest(), 4);
}

}  // namespace
}  // namespace glark::core::test
