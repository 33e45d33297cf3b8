// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK on the screen: closed meshes from 26 directions at levels 1 to 7. The plan: front and back faces are
// counted in every pixel, without a depth test. In a closed mesh, both counts are equal. A pixel of the background that
// shows through a crack counts one more of one kind.
#include "tests/core/support/meshes/models.h"
#include "tests/core/support/meshes/views.h"

namespace glark::core::test {
namespace {

constexpr unsigned deepest = 7;

class WeldedPictures : public testing::Test {
 protected:
  WeldedPictures() {
    glARKinit(deepest);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    program_ =
        link_program({.vertex = "#version 450 core\nin vec3 position; in vec3 normal; uniform mat4 view; out vec3 n;\n"
                                "void main() { gl_Position = view * vec4(position, 1.0); n = normal; }\n",
                      .fragment = "#version 450 core\nin vec3 n; out vec4 color;\nvoid main() {\n"
                                  "  color = vec4(gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0), n.x > 9.0 ? 1.0 : "
                                  "0.0, 0.0) / 255.0; }\n",
                      .attributes = {"position", "normal", "weights", "triangle"}});
    glUseProgram(program_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glClearColor(0, 0, 0, 0);
  }
  // Counts the open pixels of the picture from this direction.
  int open_pixels(const SplitMesh& mesh, const Vector& direction) {
    set_view(program_, view_along(direction));
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.vertices.size()));
    return test::open_pixels(read_picture());
  }
  int open_pixels(const SplitMesh& mesh, unsigned level) {
    const SplitMesh tagged = mesh.tagged_at_random(level, level);
    upload(tagged.vertices);
    int open = 0;
    for (const Vector& direction : directions()) open += open_pixels(tagged, direction);
    return open;
  }
  void expect_closed(const SplitMesh& mesh) {
    for (unsigned level = 1; level <= deepest; ++level) {
      EXPECT_EQ(open_pixels(mesh, level), 0) << "level " << level;
    }
    EXPECT_EQ(pending_errors(), "");
  }
  OsmesaContext context_{Profile::core};
  GLuint program_ = 0;
};

TEST_F(WeldedPictures, Cube) { expect_closed(flat_shaded(cube())); }

TEST_F(WeldedPictures, Gears) {
  expect_closed(gear(8, 0.4F, false));
  expect_closed(gear(4, 0, true));
}

TEST_F(WeldedPictures, SeamsEverywhere) { expect_closed(seams_everywhere(icosahedron(), 0.4F, 12)); }

TEST_F(WeldedPictures, TwoCubesOnOneEdge) {
  Mesh mesh = cube();
  for (const auto& position : cube().positions) {
    mesh.positions.push_back({position[0] / 2 + 1.5F, position[1], position[2] + 2});
  }
  for (const auto& [a, b, c] : cube().triangles) mesh.triangles.push_back({a + 8, b + 8, c + 8});
  for (auto& position : mesh.positions) {
    for (GLfloat& value : position) value /= 2;
  }
  expect_closed(seams_everywhere(mesh, 0.3F, 13));
}

TEST_F(WeldedPictures, CracksShowWithoutWeld) {
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(open_pixels(gear(4, 0, true), 5), 500);
  EXPECT_GT(open_pixels(seams_everywhere(icosahedron(), 0.4F, 12), 5), 500);
}

class WeldModels : public WeldedPictures, public testing::WithParamInterface<const char*> {};

TEST_P(WeldModels, AreClosedFrom26Directions) {
  const auto mesh = coarse_model(GetParam(), 12);
  if (!mesh) GTEST_SKIP() << GetParam() << " is not in " GLARK_MODELS ", or zstd is missing";
  if (!is_closed(*mesh)) GTEST_SKIP() << GetParam() << " has holes of its own";
  expect_closed(creased(*mesh, 0.7F));
}

INSTANTIATE_TEST_SUITE_P(All, WeldModels, testing::Values("armadillo", "bunny", "horse", "igea", "nefertiti"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace glark::core::test
