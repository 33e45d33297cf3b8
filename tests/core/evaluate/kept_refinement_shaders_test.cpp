// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's refinement shader places kept refined vertices. After each change of what it reads, the picture is
// another one.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/core/evaluate/kept_pictures.h"

namespace glark::core::test {
namespace {

constexpr int seen_pixels = 40;

class KeptRefinementShaders : public KeptScene {
 protected:
  KeptRefinementShaders() {
    program_ = link_program(
        {.vertex = "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec3 "
                   "c;\nuniform float shared_part; uniform float brightness;\n"
                   "void main() { gl_Position = vec4(position + vec2(0.0, 0.001 * shared_part), 0.0, 1.0);\n"
                   "  c = color * brightness; }\n",
         .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
    glUseProgram(program_);
    set("brightness", 1);
    refine_uniformly(3, GL_LINEAR_INPUTS_ARK);
  }
  void set_shader(const std::string& source) const {
    const char* const text = source.c_str();
    glRefinementShaderSourceARK(program_, 1, &text, nullptr);
    GLint built = GL_FALSE;
    glGetRefinementivARK(program_, GL_REFINEMENT_STATUS_ARK, &built);
    EXPECT_EQ(built, GL_TRUE) << source;
  }
  GLint location(const char* name) const { return glGetUniformLocation(program_, name); }
  void set(const char* name, GLfloat value) const { glUniform1f(location(name), value); }
  Picture settled() const { return expect_same_picture(draw_arrays); }
  void expect_seen(const std::function<void()>& change) const {
    const Picture before = settled();
    change();
    EXPECT_GT(differing_pixels(before, settled()), seen_pixels);
  }
};

INSTANTIATE_TEST_SUITE_P(All, KeptRefinementShaders, testing::Values(Profile::compatibility, Profile::core),
                         profile_name);

TEST_P(KeptRefinementShaders, ItsOwnUniform) {
  set_shader("uniform float bend; void refine() { position.y += bend * ark_barycentric.x * ark_barycentric.y; }");
  set("bend", 0.5F);
  expect_seen([this] { set("bend", -1); });
  expect_seen([this] { glProgramUniform1f(program_, location("bend"), 0.1F); });
}

TEST_P(KeptRefinementShaders, AUniformThatIsAskedForLate) {
  set_shader("uniform float a[2]; void refine() { position += vec2(a[0], a[1]) * ark_barycentric.x; }");
  settled();
  expect_seen([this] { set("a[1]", 0.4F); });
  const GLfloat both[] = {-0.3F, 0.1F};
  expect_seen([&] { glUniform1fv(location("a"), 2, both); });
}

TEST_P(KeptRefinementShaders, AUniformOfTheVertexStage) {
  set_shader("uniform float shared_part; void refine() { position.x += shared_part * ark_barycentric.y; }");
  set("shared_part", 0);
  expect_seen([this] { set("shared_part", 0.4F); });
}

// A uniform of the vertex stage alone does not place the vertices.
TEST_P(KeptRefinementShaders, AnotherUniform) {
  set_shader("uniform float bend; void refine() { position.y += bend * ark_barycentric.x; }");
  set("bend", 0.3F);
  expect_seen([this] { set("brightness", 0.4F); });
}

TEST_P(KeptRefinementShaders, CornersAndFunctions) {
  set_shader(
      "float middle(vec2 a, vec2 b) { return 0.5 * (a.x + b.y); }\n"
      "void refine() { position.x += 0.2 * middle(ark_corner_position[0], ark_corner_position[2]);\n"
      "  color = color.yzx; }");
  settled();
}

TEST_P(KeptRefinementShaders, AnotherShader) {
  set_shader("void refine() { position *= 0.8; }");
  expect_seen([this] { set_shader("void refine() { position *= 0.5; }"); });
  expect_seen([this] { set_shader(""); });
}

TEST_P(KeptRefinementShaders, ATextureOfIt) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const auto fill = [](GLfloat value) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, &value);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  };
  fill(0.5F);
  set_shader("uniform sampler2D map; void refine() { position *= textureLod(map, vec2(0.5), 0.0).x; }");
  expect_seen([&] { fill(0.9F); });
}

TEST_P(KeptRefinementShaders, ABlockOfIt) {
  set_shader("layout(std140) uniform Shape { float size; }; void refine() { position *= size; }");
  make_buffer(GL_UNIFORM_BUFFER, std::vector<GLfloat>{0.9F, 0, 0, 0});
  GLint buffer = 0;
  glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &buffer);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, static_cast<GLuint>(buffer));
  expect_seen([] {
    const GLfloat smaller = 0.4F;
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(smaller), &smaller);
  });
}

}  // namespace
}  // namespace glark::core::test
