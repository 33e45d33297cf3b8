// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar tags together with many other attributes. The coarse record is read from a storage block, or does not fit at
// all.
#include "tests/core/support/osmesa_context.h"
#include "tests/pn/tagged_program.h"

namespace glark::pn::test {
namespace {

// A program with `more` additional vec4 attributes, at locations from 4.
GLuint link_wide_program(int more) {
  std::string inputs;
  std::string sum = "0.0";
  std::vector<std::string> names = {"position", "normal", "weights", "triangle"};
  for (int i = 0; i < more; ++i) {
    names.push_back("wide" + std::to_string(i));
    inputs += "in vec4 " + names.back() + ";\n";
    sum += " + dot(" + names.back() + ", vec4(1.0))";
  }
  std::vector<const char*> attributes;
  for (const std::string& name : names) attributes.push_back(name.c_str());
  return link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n" + inputs +
                 "out vec3 passed_weights; out float passed_triangle;\n"
                 "void main() { gl_Position = vec4(position, position.x + normal.x + 0.0 * (" +
                 sum + "));\n  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = attributes});
}

class TaggedLimits : public testing::Test {
 protected:
  TaggedLimits() {
    glARKinit(3);
    glEnable(GL_ARK);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    Dice dice(29);
    std::vector<TaggedVertex> mesh;
    for (int i = 0; i < 4; ++i) append(mesh, {dice.corner(true), dice.corner(true), dice.corner(false)}, i);
    upload(mesh);
  }
  static std::vector<RefinedVertex> refine() {
    return capture_refined(10000, [] { glDrawArrays(GL_TRIANGLES, 0, 12); });
  }
  OsmesaContext context_{Profile::core};
};

TEST_F(TaggedLimits, LongRecords) {
  glUseProgram(link_tagged_program(Shown::position));
  const std::vector<RefinedVertex> expected = refine();
  ASSERT_EQ(expected.size(), 4U * 64 * 3);
  glUseProgram(link_wide_program(8));
  const std::vector<RefinedVertex> wide = refine();
  ASSERT_EQ(wide.size(), expected.size());
  for (std::size_t i = 0; i < wide.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(wide[i].position[axis], expected[i].position[axis]);
  }
  EXPECT_EQ(pending_errors(), "");
}

// If the driver captures fewer components than the record has, the draw is not refined, with a message.
TEST_F(TaggedLimits, RecordsThatDoNotFit) {
  GLint components = 0;
  glGetIntegerv(GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS, &components);
  const int more = 9;  // the maximum is 13 attributes
  const GLuint program = link_wide_program(more);
  glUseProgram(program);
  GLint built = GL_FALSE;
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  const bool fits = 10 + 4 * more + 7 + 1 <= components;
  EXPECT_EQ(built == GL_TRUE, fits);
  EXPECT_EQ(refine().size(), fits ? 4U * 64 * 3 : 12U);
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace
}  // namespace glark::pn::test
