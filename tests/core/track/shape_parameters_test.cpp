// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The parameters of scalar tags and of displacement (11.R.2): what they accept, what they give back, and their errors.
#include <cmath>

#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLenum names[] = {GL_REFINEMENT_ARK,         GL_DISCONTINUITY_ATTRIBUTE_ARK, GL_SCALAR_TAG_ATTRIBUTE_ARK,
                            GL_DISPLACEMENT_UNIT_ARK,  GL_DISPLACEMENT_CHANNEL_ARK,    GL_DISPLACEMENT_COORDINATE_ARK,
                            GL_DISPLACEMENT_SCALE_ARK, GL_DISPLACEMENT_BIAS_ARK};

std::vector<GLfloat> state() {
  std::vector<GLfloat> values;
  for (const GLenum name : names) glGetFloatv(name, &values.emplace_back(-99.0F));
  return values;
}

GLint integer(GLenum name) {
  GLint value = -99;
  glGetIntegerv(name, &value);
  return value;
}

template <typename Call>
void expect_error(const char* error, Call&& call) {
  const std::vector<GLfloat> before = state();
  call();
  EXPECT_EQ(pending_errors(), error);
  EXPECT_EQ(before, state());
}

const char* const invalid_enum = "0x0500 ";
const char* const invalid_value = "0x0501 ";
const char* const invalid_operation = "0x0502 ";

class ShapeParameters : public testing::TestWithParam<Profile> {
 protected:
  OsmesaContext context_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(All, ShapeParameters, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(ShapeParameters, InitialValues) {
  const auto attributes = static_cast<GLfloat>(integer(GL_MAX_VERTEX_ATTRIBS));
  const std::vector<GLfloat> expected = {GL_LINEAR_INPUTS_ARK, attributes - 2, attributes - 3, -1, GL_RED, -1, 1, 0};
  EXPECT_EQ(state(), expected);
}

TEST_P(ShapeParameters, WhatIsSetIsGivenBack) {
  const std::pair<GLenum, GLint> values[] = {{GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK},
                                             {GL_DISCONTINUITY_ATTRIBUTE_ARK, 3},
                                             {GL_SCALAR_TAG_ATTRIBUTE_ARK, 4},
                                             {GL_DISPLACEMENT_UNIT_ARK, 5},
                                             {GL_DISPLACEMENT_UNIT_ARK, -1},
                                             {GL_DISPLACEMENT_CHANNEL_ARK, GL_ALPHA},
                                             {GL_DISPLACEMENT_COORDINATE_ARK, 6},
                                             {GL_DISPLACEMENT_COORDINATE_ARK, -1},
                                             {GL_DISPLACEMENT_SCALE_ARK, -3},
                                             {GL_DISPLACEMENT_BIAS_ARK, 2}};
  for (const auto& [name, value] : values) {
    glARKParameteriARK(name, value);
    EXPECT_EQ(integer(name), value);
  }
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 2.75F);
  glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, -0.125F);
  EXPECT_EQ(state()[6], 2.75F);
  EXPECT_EQ(state()[7], -0.125F);
  EXPECT_EQ(integer(GL_DISPLACEMENT_SCALE_ARK), 3) << "rounded";
  GLboolean is_set = GL_FALSE;
  glGetBooleanv(GL_DISPLACEMENT_BIAS_ARK, &is_set);
  EXPECT_EQ(is_set, GL_TRUE);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(ShapeParameters, Errors) {
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, 16); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, 16); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, -2); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -2); });
  const GLint units = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  expect_error(invalid_value, [units] { glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, units); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, GL_RGBA); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_SCALAR_TAGGED_PN_ARK, 1); });
  expect_error(invalid_enum, [] { glARKParameterfARK(GL_DISPLACEMENT_UNIT_ARK, 2); });
  expect_error(invalid_enum, [] { glARKParameterfARK(GL_EDGE_PIXELS_ARK, 2); });
  expect_error(invalid_value, [] { glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, INFINITY); });
  expect_error(invalid_value, [] { glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, NAN); });
  if (GetParam() == Profile::compatibility) {
    expect_error(invalid_value, [] { glARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, 0); });
    glBegin(GL_TRIANGLES);
    glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 4);
    glEnd();
    EXPECT_EQ(pending_errors(), invalid_operation);
    EXPECT_EQ(state()[6], 1.0F);
  }
}

}  // namespace
}  // namespace glark::core::test
