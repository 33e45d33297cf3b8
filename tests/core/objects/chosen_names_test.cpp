// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Names of buffers and of display lists. A compatibility context lets a program choose them: the program must not get one of
// our objects. glGenBuffers and glGenLists give the names that they give without glark.
#include <array>
#include <vector>

#include "tests/core/support/modes.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

constexpr GLuint last_chosen_name = 300;
constexpr std::array<GLfloat, 12> two_triangles{-0.9F, -0.9F, 0.9F, -0.9F, 0.9F,  0.9F,
                                                -0.9F, -0.9F, 0.9F, 0.9F,  -0.9F, 0.9F};

class ChosenNames : public testing::Test {
 protected:
  ChosenNames() {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, sizeof(two_triangles), two_triangles.data(), GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColor4f(1, 0.5F, 0.25F, 1);
  }

  static void draw() { glDrawArrays(GL_TRIANGLES, 0, 6); }

  // Draws with more than one pattern, so that the triangles are captured, sorted and kept.
  Picture draw_repeatedly() {
    refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK);
    Picture picture;
    for (int i = 0; i < 8; ++i) picture = picture_of(draw);
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
    glARKParameteriARK(GL_EDGE_PIXELS_ARK, 5);
    for (int i = 0; i < 8; ++i) picture = picture_of(draw);
    return picture;
  }

  OsmesaContext context_{Profile::compatibility};
};

TEST_F(ChosenNames, AreFree) {
  draw_repeatedly();
  for (GLuint name = 2; name <= last_chosen_name; ++name) EXPECT_EQ(glIsBuffer(name), GL_FALSE) << name;
  std::array<GLuint, 3> names{};
  glGenBuffers(3, names.data());
  EXPECT_LT(names[2], 10U) << "as without refinement";
  EXPECT_EQ(pending_errors(), "");
}

// Names that glGenBuffers gave are no buffers until they are bound.
TEST_F(ChosenNames, MayBeBoundLate) {
  std::array<GLuint, 100> names{};
  draw_repeatedly();
  glGenBuffers(100, names.data());
  const Picture plain = draw_repeatedly();
  for (const GLuint name : names) {
    EXPECT_EQ(glIsBuffer(name), GL_FALSE) << name;
    glBindBuffer(GL_UNIFORM_BUFFER, name);
    GLint size = -1;
    glGetBufferParameteriv(GL_UNIFORM_BUFFER, GL_BUFFER_SIZE, &size);
    EXPECT_EQ(size, 0) << "the buffer of another owner";
  }
  EXPECT_EQ(differing_pixels(plain, draw_repeatedly()), 0);
}

TEST_F(ChosenNames, KeepTheirContentsAndThePicture) {
  const Picture plain = picture_of(draw);
  draw_repeatedly();
  for (GLuint name = 2; name <= last_chosen_name; ++name) {
    glBindBuffer(GL_ARRAY_BUFFER, name);
    const std::vector<GLuint> contents(256, name);
    glBufferData(GL_ARRAY_BUFFER, 1024, contents.data(), GL_STATIC_DRAW);
  }
  EXPECT_LE(differing_pixels(plain, draw_repeatedly()), tolerated_pixels);
  for (GLuint name = 2; name <= last_chosen_name; ++name) {
    glBindBuffer(GL_ARRAY_BUFFER, name);
    std::array<GLuint, 256> contents{};
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(contents), contents.data());
    EXPECT_EQ(contents[0], name);
    EXPECT_EQ(contents[255], name);
  }
  EXPECT_EQ(pending_errors(), "");
}

// The program has made buffers with the names that glark would take.
TEST_F(ChosenNames, MayBeLarge) {
  constexpr GLuint first = 0xFFFFFFFE - 199;
  std::array<GLfloat, 4> contents{1, 2, 3, 4};
  for (GLuint name = first; name < first + 200; ++name) {
    glBindBuffer(GL_UNIFORM_BUFFER, name);
    glBufferData(GL_UNIFORM_BUFFER, sizeof(contents), contents.data(), GL_STATIC_DRAW);
  }
  const Picture plain = picture_of(draw);
  EXPECT_LE(differing_pixels(plain, draw_repeatedly()), tolerated_pixels);
  for (GLuint name = first; name < first + 200; ++name) {
    glBindBuffer(GL_UNIFORM_BUFFER, name);
    GLint size = 0;
    glGetBufferParameteriv(GL_UNIFORM_BUFFER, GL_BUFFER_SIZE, &size);
    EXPECT_EQ(size, static_cast<GLint>(sizeof(contents)));
  }
  EXPECT_EQ(pending_errors(), "");
}

// Another share group in the same process.
TEST_F(ChosenNames, AreFreeInALaterContext) {
  draw_repeatedly();
  OsmesaContext later{Profile::compatibility};
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, sizeof(two_triangles), two_triangles.data(), GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  draw_repeatedly();
  GLuint name = 0;
  glGenBuffers(1, &name);
  EXPECT_EQ(name, 2U);
}

// In Mesa 22.3, a vertex array that holds a deleted buffer still reads it after glBindVertexBuffer with a new buffer of that
// name.
TEST_F(ChosenNames, OfOursAreNotGivenAgain) {
  constexpr GLuint largest = 0xFFFFFFFE;
  constexpr GLuint most_names = 400;
  draw_repeatedly();
  glARKinit(5);
  draw_repeatedly();
  std::vector<GLuint> free;  // above the least name of ours
  std::vector<GLuint> freed;
  for (GLuint name = largest; name > largest - most_names; --name) {
    if (glIsBuffer(name) == GL_FALSE) {
      free.push_back(name);
    } else {
      freed = free;
    }
  }
  EXPECT_FALSE(freed.empty());
  glARKinit(6);
  draw_repeatedly();
  for (const GLuint name : freed) EXPECT_EQ(glIsBuffer(name), GL_FALSE) << name;
}

// glark makes several lists of its own of each list that draws.
TEST_F(ChosenNames, ListsHaveTheNamesThatTheyHaveWithoutRefinement) {
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (GLuint expected = 1; expected < 6; ++expected) {
    const GLuint name = glGenLists(1);
    EXPECT_EQ(name, expected);
    glNewList(name, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    for (const GLfloat x : {-1.0F, 0.0F, 1.0F}) glVertex2f(x, x * x);
    glEnd();
    glEndList();
    glCallList(name);
  }
  EXPECT_EQ(glGenLists(3), 6U);
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace
}  // namespace glark::core::test
