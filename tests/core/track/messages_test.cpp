// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What an application that calls the extension is told by its debug output.
#include <string>
#include <vector>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

struct Message {
  GLenum source;
  GLenum type;
  GLuint id;
  std::string text;
};

std::vector<Message>& messages() {
  static std::vector<Message> all;
  return all;
}

void APIENTRY note(GLenum source, GLenum type, GLuint id, GLenum /*severity*/, GLsizei length, const GLchar* text,
                   const void* /*user*/) {
  if (source == GL_DEBUG_SOURCE_THIRD_PARTY)
    messages().push_back({source, type, id, std::string(text, static_cast<std::size_t>(length))});
}

class Messages : public testing::Test {
 protected:
  Messages() {
    messages().clear();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(note, nullptr);
  }
  static std::string last() { return messages().empty() ? "" : messages().back().text; }
  OsmesaContext context_{Profile::compatibility};
};

}  // namespace

TEST_F(Messages, AnErrorNamesFunctionValueAndRemedy) {
  glARKinit(99);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  ASSERT_EQ(messages().size(), 1u);
  EXPECT_EQ(messages()[0].type, static_cast<GLenum>(GL_DEBUG_TYPE_ERROR));
  EXPECT_EQ(last(), "glARKinit: GL_INVALID_VALUE: level 99 exceeds 11, the greatest level; give a lower one");
  glARKinit(2);
  glDepthTag1i(9);
  EXPECT_EQ(last(), "glDepthTag1i: GL_INVALID_VALUE: depth tag 9 exceeds level 2 of glARKinit; raise maxLevel");
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 7);
  EXPECT_EQ(
      last(),
      "glARKParameteriARK: GL_INVALID_VALUE: GL_UNIFORM_DEPTH_LEVEL_ARK cannot be 7; an integer from 0 to 2 is needed");
  EXPECT_EQ(messages().size(), 3u);
  glARKParameterfARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  EXPECT_EQ(last(),
            "glARKParameterfARK: GL_INVALID_ENUM: GL_UNIFORM_DEPTH_LEVEL_ARK cannot be 1; an integer from 0 to 2, by "
            "glARKParameteriARK, is needed");
  glGetError();
}

TEST_F(Messages, WithoutDebugOutputThereIsNone) {
  glDisable(GL_DEBUG_OUTPUT);
  glARKinit(99);
  EXPECT_TRUE(messages().empty());
  glEnable(GL_DEBUG_OUTPUT);
  EXPECT_TRUE(messages().empty());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Messages, BetweenBeginAndEndTheErrorStays) {
  glARKinit(1);
  glBegin(GL_TRIANGLES);
  glARKinit(1);
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_TRUE(messages().empty());
}

TEST_F(Messages, ACurvedDrawWithoutANormalIsToldOnce) {
  glARKinit(1);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  const float corners[] = {0, 0, 1, 0, 0, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ASSERT_EQ(messages().size(), 1u) << last();
  EXPECT_EQ(messages()[0].type, static_cast<GLenum>(GL_DEBUG_TYPE_OTHER));
  EXPECT_NE(last().find("is refined by linear: "), std::string::npos) << last();
  EXPECT_EQ(glIsEnabled(GL_DEBUG_OUTPUT), GL_TRUE);
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(Messages, ADrawThatCannotBeRefinedIsTold) {
  glARKinit(1);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  const char* source = "void refine() { gl_Vertex.x = no_such_name; }";
  glRefinementShaderSourceARK(0, 1, &source, nullptr);
  const float corners[] = {0, 0, 1, 0, 0, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ASSERT_FALSE(messages().empty());
  EXPECT_NE(last().find("refinement shader:1("), std::string::npos) << last();
  EXPECT_NE(last().find("no_such_name"), std::string::npos) << last();
  EXPECT_EQ(last().find("glark_"), std::string::npos) << last();
}

}  // namespace glark::core::test
