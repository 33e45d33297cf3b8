// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_GEOMORPH_ARK with vertex stages that are derived in different ways: fixed function, and programs with a geometry
// shader. Also under a budget, which moves measured depths from frame to frame, and the state.
#include <cmath>

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

struct Change {
  int largest = 0;  // between two tags of the path
  int whole = 0;    // from its first to its last
};

// A triangle whose silhouette is curved, at tags from 1 to 3 in steps of a 64th.
template <typename Draw>
Change change_along_tags(bool morphs, Draw&& draw) {
  glARKParameteriARK(GL_GEOMORPH_ARK, morphs ? GL_TRUE : GL_FALSE);
  Change change;
  Picture first;
  Picture before;
  for (int step = 0; step <= 128; ++step) {
    const Picture now = picture_of([&] { draw(1 + static_cast<GLfloat>(step) / 64); });
    if (step == 0) first = now;
    if (step > 0) change.largest = std::max(change.largest, differing_pixels(before, now));
    change.whole = std::max(change.whole, differing_pixels(first, now));
    before = now;
  }
  EXPECT_EQ(pending_errors(), "");
  return change;
}

template <typename Draw>
void expect_no_pops(Draw&& draw) {
  const Change morphed = change_along_tags(true, draw);
  const Change plain = change_along_tags(false, draw);
  EXPECT_GT(morphed.whole, 100) << "the path shows nothing";
  EXPECT_LT(morphed.largest, morphed.whole / 8);
  EXPECT_GT(plain.largest, plain.whole / 4) << "the control does not pop";
}

constexpr GLfloat positions[] = {-0.6F, -0.5F, 0, 0.6F, -0.5F, 0, 0, 0.6F, 0};
constexpr GLfloat normals[] = {-0.8F, -0.7F, 0.5F, 0.8F, -0.7F, 0.5F, 0, 0.9F, 0.5F};

void start(GLuint pool_level) {
  glViewport(0, 0, picture_size, picture_size);
  glARKinit(pool_level);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glEnable(GL_ARK);
}

GLuint tag_attribute() {
  GLint attribute = 0;
  glGetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  return static_cast<GLuint>(attribute);
}

// Draws in white; a light makes the normals inputs of the vertex stage.
void shine() {
  constexpr GLfloat white[] = {1, 1, 1, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, white);
}

TEST(GeomorphPrograms, FixedFunction) {
  const OsmesaContext context(Profile::compatibility);
  start(4);
  shine();
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, positions);
  glNormalPointer(GL_FLOAT, 0, normals);
  const GLuint attribute = tag_attribute();
  expect_no_pops([attribute](GLfloat tag) {
    glVertexAttrib1f(attribute, tag);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  });
}

TEST(GeomorphPrograms, FixedFunctionFromBeginToEnd) {
  const OsmesaContext context(Profile::compatibility);
  start(4);
  shine();
  const GLuint attribute = tag_attribute();
  expect_no_pops([attribute](GLfloat tag) {
    glBegin(GL_TRIANGLES);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      glVertexAttrib1f(attribute, tag);
      glNormal3fv(normals + 3 * corner);
      glVertex3fv(positions + 3 * corner);
    }
    glEnd();
  });
}

// The geometry shader sees the moved vertices: it draws every refined triangle twice.
TEST(GeomorphPrograms, GeometryShader) {
  const OsmesaContext context(Profile::core);
  start(4);
  glUseProgram(link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; out float bend;\n"
                 "void main() { gl_Position = vec4(position, 1.0); bend = 0.1 * normal.x; }\n",
       .fragment = "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .attributes = {"position", "normal"},
       .geometry = "#version 450 core\nlayout(triangles) in; layout(triangle_strip, max_vertices = 6) out;\n"
                   "in float bend[];\nvoid main() { for (int copy = 0; copy < 2; ++copy) {\n"
                   "  for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position * vec4(0.9, 0.5, 1.0, 1.0)\n"
                   "      + vec4(bend[i], float(copy) - 0.5, 0.0, 0.0); EmitVertex(); }\n  EndPrimitive(); } }\n"}));
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>(std::begin(positions), std::end(positions)));
  float_attribute(0, 3);
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>(std::begin(normals), std::end(normals)));
  float_attribute(1, 3);
  const GLuint attribute = tag_attribute();
  expect_no_pops([attribute](GLfloat tag) {
    glVertexAttrib1f(attribute, tag);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  });
}

double area_of(const std::vector<RefinedVertex>& vertices) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = double{vertices[i + 1].position[k]} - double{vertices[i].position[k]};
      v[k] = double{vertices[i + 2].position[k]} - double{vertices[i].position[k]};
    }
    area += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

class GeomorphBudget : public testing::Test {
 protected:
  static constexpr GLint budget = 1200;
  GeomorphBudget() {
    glViewport(0, 0, picture_size, picture_size);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    const GLuint program = link_measured_program();
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "bend"), 0.2F);
    set_view(program, perspective(5));
    const Mesh mesh = icosahedron();
    for (const auto& triangle : mesh.triangles) {
      for (const std::size_t k : triangle) vertices_.push_back({mesh.positions[k], mesh.positions[k], {}, 0, 0});
    }
    upload(vertices_);
    glDisable(GL_DEPTH_TAG_ARRAY_ARK);
    measure_depths(6, 2, 0, budget);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  }
  std::vector<RefinedVertex> draw_once() const {
    return capture_refined(100000, [this] { glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size())); });
  }
  std::vector<CurvedVertex> vertices_;

 private:
  OsmesaContext context_{Profile::core};
};

// Frames that draw the mesh three times instead of once exceed the budget. Measures how the surface moves until they do
// not.
TEST_F(GeomorphBudget, DepthsGlideWhenTheLoadChanges) {
  for (const bool morphs : {true, false}) {
    glARKParameteriARK(GL_GEOMORPH_ARK, morphs ? GL_TRUE : GL_FALSE);
    const auto frame = [this](int copies) {
      std::vector<RefinedVertex> refined;
      for (int i = 0; i < copies; ++i) refined = draw_once();
      glFinish();  // ends the frame where there is no window
      return refined;
    };
    for (int settling = 0; settling < 40; ++settling) frame(1);
    double before = area_of(frame(1));
    const double first = before;
    double largest = 0;
    std::size_t triangles = 0;
    for (int i = 0; i < 40; ++i) {
      const std::vector<RefinedVertex> refined = frame(3);
      triangles = refined.size() / 3;
      const double now = area_of(refined);
      largest = std::max(largest, std::abs(now - before));
      before = now;
    }
    EXPECT_LE(3 * triangles, std::size_t{budget});
    EXPECT_GE(3 * triangles, std::size_t{budget / 4});
    if (morphs) {
      EXPECT_LT(largest, 0.25 * std::abs(before - first));
    } else {
      EXPECT_GT(largest, 0.5 * std::abs(before - first)) << "the control does not pop";
    }
  }
}

// Far beyond the budget, keeping the budget is more important than smooth changes.
TEST_F(GeomorphBudget, AGreatExcessIsNotWaitedFor) {
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 200);
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  EXPECT_GT(draw_once().size() / 3, 16U * 200U);
  glFinish();
  EXPECT_LE(draw_once().size() / 3, 4U * 200U);
}

TEST(GeomorphState, IsOffAndIsRead) {
  const OsmesaContext context(Profile::core);
  glARKinit(3);
  GLint value = -1;
  glGetIntegerv(GL_GEOMORPH_ARK, &value);
  EXPECT_EQ(value, GL_FALSE);
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  glGetIntegerv(GL_GEOMORPH_ARK, &value);
  EXPECT_EQ(value, GL_TRUE);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glARKParameteriARK(GL_GEOMORPH_ARK, 2);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
}

}  // namespace
}  // namespace glark::core::test
