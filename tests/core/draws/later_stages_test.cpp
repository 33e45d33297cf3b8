// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Stages after the vertex stage: geometry shaders, and framebuffers with integers. Also records of many lengths.
#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

const std::string inputs = "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color;\n";

class LaterStages : public testing::TestWithParam<Profile> {
 protected:
  LaterStages() {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    make_buffer(GL_ARRAY_BUFFER, mode_shapes()[1].vertices);
    point_generic_arrays(nullptr);
  }
  static void draw() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }
  OsmesaContext context_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(All, LaterStages, testing::Values(Profile::compatibility, Profile::core), profile_name);

// A geometry shader sees the value of a `flat` output at every vertex, so the value may differ within a triangle.
TEST_P(LaterStages, GeometryShaderReadsFlatOutputsOfEveryVertex) {
  glUseProgram(link_program(
      {.vertex = inputs + "flat out vec2 place; out vec3 tint;\nvoid main() { place = position; tint = color; }\n",
       .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n",
       .geometry = "#version 430\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
                   "flat in vec2 place[3]; in vec3 tint[3]; out vec3 c;\n"
                   "void main() { for (int i = 0; i < 3; ++i) { gl_Position = vec4(place[i], 0.0, 1.0); c = tint[i]; "
                   "EmitVertex(); } }\n"}));
  expect_same_scene({4, GL_LINEAR_OUTPUTS_ARK}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

// A triangle is culled if all its corners are outside. Refined triangles at one outside corner are not culled.
TEST_P(LaterStages, CullDistances) {
  glUseProgram(link_program(
      {.vertex =
           "#version 450\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color;\nout vec3 c;\n"
           "out float gl_CullDistance[1];\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); c = color;\n"
           "gl_CullDistance[0] = position.x; }\n",
       .fragment = "#version 450\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"}));
  expect_same_scene({4, GL_LINEAR_OUTPUTS_ARK}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

TEST_P(LaterStages, IntegerFramebuffer) {
  GLuint texture = 0;
  GLuint framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32UI, 8, 8);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glViewport(0, 0, 8, 8);
  glUseProgram(link_program({.vertex = inputs + "void main() { gl_Position = vec4(position * 4.0, 0.0, 1.0); }\n",
                             .fragment = "#version 430\nout uvec4 result;\nvoid main() { result = uvec4(7u); }\n"}));
  for (const bool adaptive : {false, true}) {
    refine_uniformly(2);
    if (adaptive) {
      glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
      glDepthTag1i(2);
    }
    const GLuint none[4] = {};
    GLuint seen[4] = {};
    glClearBufferuiv(GL_COLOR, 0, none);
    draw();
    glReadPixels(4, 4, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, seen);
    EXPECT_EQ(seen[0], 7U) << (adaptive ? "adaptive" : "uniform");
    EXPECT_EQ(pending_errors(), "");
  }
}

// The capture buffer grows by half, from any size: its ranges must stay bindable.
TEST(LaterStagesImmediate, RecordsOfEveryLengthInOneContext) {
  const OsmesaContext context(Profile::compatibility);
  for (const int units : {0, 1, 2, 3, 5, 7}) {
    for (const bool lit : {false, true}) {
      lit ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING);
      for (GLenum unit = 0; unit < static_cast<GLenum>(units); ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glEnable(GL_TEXTURE_2D);
      }
      glActiveTexture(GL_TEXTURE0);
      refine_uniformly(1);
      picture_of([] {
        glBegin(GL_TRIANGLES);
        glVertex2f(-1, -1);
        glVertex2f(1, -1);
        glVertex2f(0, 1);
        glEnd();
      });
      EXPECT_EQ(generated_primitives, 4U) << units << " units";
      EXPECT_EQ(pending_errors(), "") << units << " units";
    }
  }
}

}  // namespace
}  // namespace glark::core::test
