// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK under displacement on the screen: closed meshes from 26 directions at levels 1 to 7, counted as in
// welded_pictures_test.cpp.
#include "tests/core/support/meshes/mapped_mesh.h"
#include "tests/core/support/meshes/views.h"

namespace glark::core::test {
namespace {

class DisplacedPictures : public DisplacedEdges {
 protected:
  DisplacedPictures() {
    scene_program_ = link_program(
        {.vertex =
             "#version 450 core\nin vec3 position; in vec3 normal; in vec2 texcoord; uniform mat4 view; out vec3 n;\n"
             "void main() { gl_Position = view * vec4(position, 1.0); n = normal * (1.0 + texcoord.x); }\n",
         .fragment = "#version 450 core\nin vec3 n; out vec4 color;\nvoid main() {\n"
                     "  color = vec4(gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0), n.x > 99.0 ? 1.0 : 0.0, 0.0) / "
                     "255.0; }\n",
         .attributes = {"position", "normal", "weights", "triangle", "texcoord"}});
    glUseProgram(scene_program_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glClearColor(0, 0, 0, 0);
  }
  int open_pixels(const MappedMesh& mapped, unsigned level) const {
    MappedMesh tagged = mapped;
    tagged.mesh = mapped.mesh.tagged_at_random(level, level);
    upload(tagged);
    int open = 0;
    for (const Vector& direction : directions()) {
      set_view(scene_program_, view_along(direction));
      glClear(GL_COLOR_BUFFER_BIT);
      glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(tagged.coordinates.size()));
      open += test::open_pixels(read_picture());
    }
    return open;
  }
  void expect_closed(const MappedMesh& mapped) const {
    for (unsigned level = 1; level <= deepest; ++level) {
      EXPECT_EQ(open_pixels(mapped, level), 0) << "level " << level;
    }
    EXPECT_EQ(pending_errors(), "");
  }
  GLuint scene_program_ = 0;
};

TEST_F(DisplacedPictures, Cube) {
  for (const GLenum refinement : refinements) {
    set_refinement(refinement);
    expect_closed(mapped_cube());
  }
}

TEST_F(DisplacedPictures, Globe) {
  set_refinement(GL_CURVED_PN_ARK);
  expect_closed(globe());
}

TEST_F(DisplacedPictures, SeamsEverywhere) {
  set_refinement(GL_CURVED_PN_ARK);
  expect_closed(mapped_at_random(seams_everywhere(icosahedron(), 0.4F, 12), 5));
}

// A program pipeline has no storage block for the border words of displacement. The edges of the curved triangles are
// still welded.
TEST_F(DisplacedPictures, PipelinesWeldTheirCurvedEdges) {
  const char* const vertex =
      "#version 450 core\nlayout(location = 0) in vec3 position; layout(location = 1) in vec3 normal;\n"
      "layout(location = 4) in vec2 texcoord; uniform mat4 view; layout(location = 0) out vec3 n;\n"
      "out gl_PerVertex { vec4 gl_Position; };\n"
      "void main() { gl_Position = view * vec4(position, 1.0); n = normal * (1.0 + texcoord.x); }\n";
  const char* const fragment =
      "#version 450 core\nlayout(location = 0) in vec3 n; out vec4 color;\nvoid main() {\n"
      "  color = vec4(gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0), n.x > 99.0 ? 1.0 : 0.0, 0.0) / 255.0; }\n";
  const GLuint first = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &vertex);
  GLuint pipeline = 0;
  glGenProgramPipelines(1, &pipeline);
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, first);
  glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &fragment));
  glProgramUniformMatrix4fv(first, glGetUniformLocation(first, "view"), 1, GL_FALSE,
                            view_along({0.3F, 0.4F, 1}).data());
  glUseProgram(0);
  glBindProgramPipeline(pipeline);
  set_refinement(GL_CURVED_PN_ARK);
  MappedMesh mapped = mapped_at_random(seams_everywhere(icosahedron(), 0.4F, 12), 5);
  mapped.mesh = mapped.mesh.tagged_at_random(4, 4);
  upload(mapped);
  const auto holes = [&] {
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mapped.coordinates.size()));
    return test::open_pixels(read_picture());
  };
  EXPECT_GT(holes(), 0) << "it is displaced, and parts";
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0);
  EXPECT_EQ(holes(), 0);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(holes(), 0);
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(DisplacedPictures, CracksShowWithoutWeld) {
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  set_refinement(GL_LINEAR_INPUTS_ARK);
  EXPECT_GT(open_pixels(mapped_cube(), 5), 500);
  EXPECT_GT(open_pixels(globe(), 5), 50);
}

}  // namespace
}  // namespace glark::core::test
