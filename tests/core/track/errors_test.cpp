// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The errors of every command of the extension: the error is raised, and nothing else happens ("Errors" of the
// specification).
#include <cstring>
#include <string>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

struct State {
  GLint level, tag, attribute, refinement, source, uniform_level, split, interior;
  GLboolean enabled;
  GLint weld;
  GLboolean array;
  bool operator==(const State&) const = default;
};

GLint integer(GLenum name) {
  GLint value = -99;
  glGetIntegerv(name, &value);
  return value;
}

State state() {
  return {integer(GL_POOL_LEVEL_ARK),    integer(GL_CURRENT_DEPTH_TAG_ARK),  integer(GL_DEPTH_TAG_ATTRIBUTE_ARK),
          integer(GL_REFINEMENT_ARK),    integer(GL_DEPTH_SOURCE_ARK),       integer(GL_UNIFORM_DEPTH_LEVEL_ARK),
          integer(GL_POLYGON_SPLIT_ARK), integer(GL_PATTERN_INTERIOR_ARK),   glIsEnabled(GL_ARK),
          integer(GL_WELD_ARK),          glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK)};
}

// `call` gives exactly this error and changes nothing.
template <typename Call>
void expect_error(const char* error, Call&& call) {
  const State before = state();
  EXPECT_EQ(pending_errors(), "");
  call();
  EXPECT_EQ(pending_errors(), error);
  EXPECT_TRUE(before == state());
}

const char* const invalid_enum = "0x0500 ";
const char* const invalid_value = "0x0501 ";
const char* const invalid_operation = "0x0502 ";

class Errors : public testing::TestWithParam<Profile> {
 protected:
  bool core() const { return GetParam() == Profile::core; }
  OsmesaContext context_{GetParam()};
};
class ErrorsCompatibility : public Errors {};

INSTANTIATE_TEST_SUITE_P(All, Errors, testing::Values(Profile::compatibility, Profile::core), profile_name);
INSTANTIATE_TEST_SUITE_P(All, ErrorsCompatibility, testing::Values(Profile::compatibility), profile_name);

TEST_P(Errors, InitialState) {
  const State expected{-1,
                       0,
                       integer(GL_MAX_VERTEX_ATTRIBS) - 1,
                       GL_LINEAR_INPUTS_ARK,
                       GL_DEPTH_TAG_ARK,
                       0,
                       GL_POLYGON_TRIANGLES_ARK,
                       GL_MINIMUM_INTERIOR_ARK,
                       GL_FALSE,
                       GL_FALSE,
                       GL_FALSE};
  EXPECT_TRUE(expected == state());
  EXPECT_EQ(integer(GL_MAX_DEPTH_ARK), 11);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_TYPE_ARK), GL_FLOAT);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), 0);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK), 0);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, Init) {
  expect_error(invalid_value, [] { glARKinit(12); });
  expect_error(invalid_value, [] { glARKinit(0xFFFFFFFF); });
  glARKinit(3);
  expect_error(invalid_value, [] { glARKinit(12); });
  EXPECT_EQ(integer(GL_POOL_LEVEL_ARK), 3);
  glARKinit(11);
  EXPECT_EQ(integer(GL_POOL_LEVEL_ARK), 11);
}

TEST_P(Errors, BeforeInit) {
  expect_error(invalid_operation, [] { glEnable(GL_ARK); });
  expect_error(invalid_value, [] { glDepthTag1i(1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1); });
  expect_error(invalid_operation, [] { glDrawARP(GL_TRIANGLES, 0, 3); });
  expect_error(invalid_operation, [] { glDrawARPElementsARK(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr); });
  glDepthTag1i(0);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  glDisable(GL_ARK);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, Parameters) {
  glARKinit(4);
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_ARK, 0); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_POOL_LEVEL_ARK, 2); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_REFINEMENT_ARK, GL_DEPTH_TAG_ARK); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_LINEAR_INPUTS_ARK); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_POLYGON_SPLIT_ARK, 0); });
  expect_error(invalid_enum, [] { glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_POLYGON_CENTROID_ARK); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 5); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_EDGE_PIXELS_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_EDGE_DEGREES_ARK, 181); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_WELD_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_WELD_ARK, 2); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, -1); });
  expect_error(invalid_value, [] { glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 16); });
  if (!core()) {
    expect_error(invalid_value, [] { glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 0); });
  }
}

TEST_P(Errors, ParametersAreSet) {
  glARKinit(4);
  const std::pair<GLenum, GLint> values[] = {{GL_REFINEMENT_ARK, GL_CURVED_PN_ARK},
                                             {GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK},
                                             {GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK},
                                             {GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK},
                                             {GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK},
                                             {GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK},
                                             {GL_EDGE_PIXELS_ARK, 12},
                                             {GL_EDGE_DEGREES_ARK, 180},
                                             {GL_TRIANGLE_BUDGET_ARK, 100000},
                                             {GL_WELD_ARK, GL_TRUE},
                                             {GL_WELD_ARK, GL_FALSE},
                                             {GL_UNIFORM_DEPTH_LEVEL_ARK, 4},
                                             {GL_DEPTH_TAG_ATTRIBUTE_ARK, core() ? 0 : 1},
                                             {GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK},
                                             {GL_POLYGON_SPLIT_ARK, GL_POLYGON_TRIANGLES_ARK},
                                             {GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK},
                                             {GL_PATTERN_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK}};
  for (const auto& [name, value] : values) {
    glARKParameteriARK(name, value);
    EXPECT_EQ(integer(name), value);
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, DepthTag) {
  glARKinit(4);
  glDepthTag1i(4);
  EXPECT_EQ(integer(GL_CURRENT_DEPTH_TAG_ARK), 4);
  expect_error(invalid_value, [] { glDepthTag1i(5); });
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 4);
  glARKinit(2);
  EXPECT_EQ(integer(GL_CURRENT_DEPTH_TAG_ARK), 2);
  EXPECT_EQ(integer(GL_UNIFORM_DEPTH_LEVEL_ARK), 2);
  GLfloat value[4] = {};
  glGetVertexAttribfv(static_cast<GLuint>(integer(GL_DEPTH_TAG_ATTRIBUTE_ARK)), GL_CURRENT_VERTEX_ATTRIB, value);
  EXPECT_EQ(value[0], 2.0F);
}

TEST_P(Errors, DepthTagIsTheAttribute) {
  glARKinit(4);
  const auto attribute = static_cast<GLuint>(integer(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  for (const auto& [value, tag] : {std::pair{2.5F, 3}, {2.49F, 2}, {-7.0F, 0}, {99.0F, 4}}) {
    glVertexAttrib1f(attribute, value);
    EXPECT_EQ(integer(GL_CURRENT_DEPTH_TAG_ARK), tag) << value;
  }
  glDepthTag1i(3);
  GLfloat current[4] = {};
  glGetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, current);
  EXPECT_EQ((std::vector<GLfloat>{current, current + 4}), (std::vector<GLfloat>{3, 0, 0, 1}));
}

TEST_P(Errors, DepthTagPointer) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>(64));
  for (const GLenum type : {GL_BYTE, GL_SHORT, GL_INT, GL_DOUBLE, GL_HALF_FLOAT}) {
    expect_error(invalid_enum, [type] { glDepthTagPointerARK(type, 0, nullptr); });
  }
  expect_error(invalid_value, [] { glDepthTagPointerARK(GL_FLOAT, -1, nullptr); });
  expect_error(invalid_value, [] { glDepthTagPointerARK(GL_FLOAT, 1 << 20, nullptr); });
  glDepthTagPointerARK(GL_UNSIGNED_SHORT, 6, byte_offset(4));
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_TYPE_ARK), GL_UNSIGNED_SHORT);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), 6);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK), static_cast<GLint>(buffer));
  void* pointer = nullptr;
  glGetPointerv(GL_DEPTH_TAG_ARRAY_POINTER_ARK, &pointer);
  EXPECT_EQ(pointer, byte_offset(4));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const GLubyte client[4] = {};
  expect_error(invalid_operation, [&] { glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, client); });
}

TEST_P(Errors, DepthTagArrayIsStateOfTheVertexArray) {
  GLuint arrays[2] = {};
  glGenVertexArrays(2, arrays);
  glBindVertexArray(arrays[0]);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK), GL_TRUE);
  EXPECT_EQ(integer(GL_DEPTH_TAG_ARRAY_ARK), 1);
  glBindVertexArray(arrays[1]);
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK), GL_FALSE);
  glBindVertexArray(arrays[0]);
  glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK), GL_FALSE);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, IndexedEnables) {
  glARKinit(1);
  expect_error(invalid_enum, [] { glEnablei(GL_ARK, 0); });
  expect_error(invalid_enum, [] { glDisablei(GL_ARK, 0); });
  expect_error(invalid_enum, [] { glIsEnabledi(GL_DEPTH_TAG_ARRAY_ARK, 0); });
}

TEST_P(Errors, DrawModes) {
  glARKinit(2);
  if (core()) {
    expect_error(invalid_enum, [] { glDrawARP(GL_QUADS, 0, 4); });
    expect_error(invalid_enum, [] { glDrawARPElementsARK(GL_POLYGON, 4, GL_UNSIGNED_BYTE, nullptr); });
  }
  for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_PATCHES, GL_TRIANGLES_ADJACENCY, 0x7777}) {
    expect_error(invalid_enum, [mode] { glDrawARP(mode, 0, 3); });
    expect_error(invalid_enum, [mode] { glDrawARPElementsARK(mode, 3, GL_UNSIGNED_BYTE, nullptr); });
  }
}

TEST_P(Errors, DrawArguments) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  make_buffer(GL_ARRAY_BUFFER, mode_shapes()[0].vertices);
  point_generic_arrays(nullptr);
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2});
  glUseProgram(link_program(
      {.vertex = "#version 430\nlayout(location = 0) in vec2 p; void main() { gl_Position = vec4(p, 0.0, 1.0); }\n",
       .fragment = "#version 430\nout vec4 c; void main() { c = vec4(1.0); }\n"}));
  glARKinit(2);
  expect_error(invalid_value, [] { glDrawARP(GL_TRIANGLES, -1, 3); });
  expect_error(invalid_value, [] { glDrawARP(GL_TRIANGLES, 0, -3); });
  expect_error(invalid_value, [] { glDrawARPElementsARK(GL_TRIANGLES, -3, GL_UNSIGNED_BYTE, nullptr); });
  expect_error(invalid_enum, [] { glDrawARPElementsARK(GL_TRIANGLES, 3, GL_FLOAT, nullptr); });
  glDrawARP(GL_TRIANGLES, 0, 0);
  glDrawARP(GL_TRIANGLES, 0, 2);
  EXPECT_EQ(pending_errors(), "");
}

// A refined draw gives the errors of the unrefined one.
TEST_P(Errors, ErrorsOfRefinedDraws) {
  refine_uniformly(2);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  expect_error(invalid_value, [] { glDrawArrays(GL_TRIANGLES, 0, -1); });
  expect_error(invalid_enum, [] { glDrawArrays(0x7777, 0, 3); });
  expect_error(invalid_enum, [] { glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); });
  if (core()) {
    expect_error(invalid_operation, [] { glDrawArraysIndirect(GL_TRIANGLES, nullptr); });
  }
}

TEST_P(Errors, RefinementShader) {
  const char* const source = "void refine() {}";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const GLuint program = glCreateProgram();
  GLint value = 77;
  GLchar text[8] = "unused";
  GLsizei length = 77;
  expect_error(invalid_value, [&] { glRefinementShaderSourceARK(program, -1, &source, nullptr); });
  expect_error(invalid_value, [&] { glRefinementShaderSourceARK(9999, 1, &source, nullptr); });
  expect_error(invalid_operation, [&] { glRefinementShaderSourceARK(shader, 1, &source, nullptr); });
  expect_error(invalid_value, [&] { glGetRefinementivARK(9999, GL_REFINEMENT_STATUS_ARK, &value); });
  expect_error(invalid_operation, [&] { glGetRefinementivARK(shader, GL_REFINEMENT_STATUS_ARK, &value); });
  expect_error(invalid_enum, [&] { glGetRefinementivARK(program, GL_LINK_STATUS, &value); });
  expect_error(invalid_value, [&] { glGetRefinementInfoLogARK(9999, 8, &length, text); });
  expect_error(invalid_operation, [&] { glGetRefinementInfoLogARK(shader, 8, &length, text); });
  expect_error(invalid_value, [&] { glGetRefinementInfoLogARK(program, -1, &length, text); });
  if (core()) {
    expect_error(invalid_value, [&] { glRefinementShaderSourceARK(0, 1, &source, nullptr); });
    expect_error(invalid_value, [&] { glGetRefinementivARK(0, GL_REFINEMENT_STATUS_ARK, &value); });
  }
  EXPECT_EQ(value, 77);
  EXPECT_EQ(length, 77);
  EXPECT_STREQ(text, "unused");
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &value);
  EXPECT_EQ(value, GL_FALSE) << "the program is not linked";
  glGetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &value);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, ExtensionString) {
  const char* const name = "GL_ARK_adaptive_refinement";
  const GLint count = integer(GL_NUM_EXTENSIONS);
  int found = 0;
  for (GLint i = 0; i < count; ++i) {
    const auto* text = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    ASSERT_NE(text, nullptr);
    found += std::strcmp(text, name) == 0 ? 1 : 0;
  }
  EXPECT_EQ(found, 1);
  EXPECT_EQ(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(count)), nullptr);
  EXPECT_EQ(pending_errors(), invalid_value);
  if (core()) return;
  const std::string all = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  EXPECT_NE((" " + all + " ").find(" " + std::string(name) + " "), std::string::npos);
}

TEST_P(Errors, QueriesInAllForms) {
  glARKinit(5);
  glEnable(GL_ARK);
  for (const GLenum name :
       {GL_ARK, GL_MAX_DEPTH_ARK, GL_POOL_LEVEL_ARK, GL_REFINEMENT_ARK, GL_DEPTH_TAG_ARRAY_TYPE_ARK}) {
    const GLint expected = integer(name);
    GLboolean boolean = 9;
    GLint64 wide = -1;
    GLfloat single = -1;
    GLdouble real = -1;
    glGetBooleanv(name, &boolean);
    glGetInteger64v(name, &wide);
    glGetFloatv(name, &single);
    glGetDoublev(name, &real);
    EXPECT_EQ(boolean, GL_TRUE);
    EXPECT_EQ(wide, expected);
    EXPECT_EQ(single, static_cast<GLfloat>(expected));
    EXPECT_EQ(real, expected);
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(Errors, UnassignedTokensAreErrors) {
  for (const GLenum name :
       {0x6F0A, 0x6F0F, GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK, GL_MINIMUM_INTERIOR_ARK, 0x6F1E, 0x6F20}) {
    GLint value = 77;
    expect_error(invalid_enum, [&] { glGetIntegerv(name, &value); });
    EXPECT_EQ(value, 77);
    expect_error(invalid_enum, [&] { glEnable(name); });
  }
}

TEST_P(ErrorsCompatibility, BetweenBeginAndEnd) {
  glARKinit(3);
  const GLuint program = glCreateProgram();
  const char* const source = "void refine() {}";
  const State before = state();
  GLint value = 77;
  const auto expect_refused = [](const char* what, auto&& call) {
    glBegin(GL_TRIANGLES);
    call();
    glEnd();
    EXPECT_EQ(pending_errors(), invalid_operation) << what;
  };
  expect_refused("init", [] { glARKinit(5); });
  expect_refused("parameter", [] { glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK); });
  expect_refused("enable", [] { glEnable(GL_ARK); });
  expect_refused("array", [] { glEnable(GL_DEPTH_TAG_ARRAY_ARK); });
  expect_refused("draw", [] { glDrawARP(GL_TRIANGLES, 0, 3); });
  expect_refused("elements", [] { glDrawARPElementsARK(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr); });
  expect_refused("source", [&] { glRefinementShaderSourceARK(program, 1, &source, nullptr); });
  expect_refused("status", [&] { glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &value); });
  expect_refused("log", [&] { glGetRefinementInfoLogARK(program, 0, nullptr, nullptr); });
  expect_refused("query", [&] { glGetIntegerv(GL_POOL_LEVEL_ARK, &value); });
  expect_refused("pointer", [] { glDepthTagPointerARK(GL_FLOAT, 0, nullptr); });
  EXPECT_EQ(value, 77);
  EXPECT_TRUE(before == state());
  glBegin(GL_TRIANGLES);
  glDepthTag1i(2);
  glEnd();
  EXPECT_EQ(pending_errors(), "");
  EXPECT_EQ(integer(GL_CURRENT_DEPTH_TAG_ARK), 2);
}

TEST_P(ErrorsCompatibility, AttributeStacks) {
  glARKinit(3);
  glPushAttrib(GL_ENABLE_BIT);
  glPushAttrib(GL_CURRENT_BIT);
  glEnable(GL_ARK);
  glDepthTag1i(2);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_ARK), GL_TRUE) << "not in this group";
  EXPECT_EQ(integer(GL_CURRENT_DEPTH_TAG_ARK), 0);
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_ARK), GL_FALSE);
  EXPECT_EQ(integer(GL_REFINEMENT_ARK), GL_CURVED_PN_ARK) << "in no group";
  glPopAttrib();
  EXPECT_EQ(pending_errors(), "0x0504 ");
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK), GL_TRUE);
  glPopClientAttrib();
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TAG_ARRAY_ARK), GL_FALSE);
}

TEST_P(ErrorsCompatibility, AttributeStackOverflows) {
  glARKinit(3);
  const GLint depth = integer(GL_MAX_ATTRIB_STACK_DEPTH);
  for (GLint i = 0; i <= depth; ++i) {
    (i % 3 == 0 ? glEnable : glDisable)(GL_ARK);
    glPushAttrib(GL_ENABLE_BIT);
  }
  EXPECT_EQ(pending_errors(), "0x0503 ");
  for (GLint i = depth; i-- > 0;) {
    glPopAttrib();
    EXPECT_EQ(glIsEnabled(GL_ARK), i % 3 == 0 ? GL_TRUE : GL_FALSE) << i;
  }
}

TEST_P(ErrorsCompatibility, DrawArpIsNotCompiled) {
  glARKinit(2);
  glNewList(glGenLists(1), GL_COMPILE);
  expect_error(invalid_operation, [] { glDrawARP(GL_TRIANGLES, 0, 3); });
  expect_error(invalid_operation, [] { glDrawARPElementsARK(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr); });
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);  // executed at once
  EXPECT_EQ(integer(GL_REFINEMENT_ARK), GL_CURVED_PN_ARK);
  glEnable(GL_ARK);
  EXPECT_EQ(glIsEnabled(GL_ARK), GL_TRUE);
  glDisable(GL_ARK);
  glEndList();
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(ErrorsCompatibility, DrawArpTakesQuadsAndPolygons) {
  glARKinit(2);
  for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) glDrawARP(mode, 0, 4);
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace
}  // namespace glark::core::test
