// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1 of lesson 7: name the creases. Without creases, the drum becomes a pillow. Its upper rim should be sharp,
// its lower rim should stay round.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/pn.h>

#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

struct Drum {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles, creases;
};

// A hexagonal drum: vertices 0 to 5 below, 6 to 11 above, then the middles of both lids.
Drum make_drum() {
  Drum drum;
  for (const float y : {-0.6F, 0.6F}) {
    for (int i = 0; i < 6; ++i) {
      const float turn = -6.2831853F * static_cast<float>(i) / 6;
      drum.positions.insert(drum.positions.end(), {std::cos(turn), y, std::sin(turn)});
    }
  }
  drum.positions.insert(drum.positions.end(), {0, -0.6F, 0, 0, 0.6F, 0});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    drum.triangles.insert(drum.triangles.end(),
                          {i, next, next + 6, i, next + 6, i + 6, 12, next, i, 13, i + 6, next + 6});
    // TODO: append the two ends of the upper edge that joins corner i to the next corner
  }
  return drum;
}

void draw_tagged(const glark::pn::TaggedMesh& mesh) {
  GLint discontinuity = 0, tags = 0;
  glGetIntegerv(GL_DISCONTINUITY_ATTRIBUTE_ARK, &discontinuity);
  glGetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &tags);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glNormalPointer(GL_FLOAT, 0, mesh.normals.data());
  glVertexAttribPointer(static_cast<GLuint>(discontinuity), 4, GL_FLOAT, GL_FALSE, 0, mesh.discontinuities.data());
  glVertexAttribPointer(static_cast<GLuint>(tags), 3, GL_FLOAT, GL_FALSE, 0, mesh.tags.data());
  glEnableVertexAttribArray(static_cast<GLuint>(discontinuity));
  glEnableVertexAttribArray(static_cast<GLuint>(tags));
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size()), GL_UNSIGNED_INT, mesh.triangles.data());
}

void begin() {
  glARKinit(4);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 4);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY}) glEnableClientState(array);
}

void draw(double) {
  static const Drum drum = make_drum();
  glark::pn::Options options;
  options.crease_degrees = 180;  // only the creases that are named
  lesson::look(3.4F, 15, 20);
  lesson::light();
  glColor3f(0.8F, 0.45F, 0.4F);
  draw_tagged(glark::pn::derive_tags({drum.positions, drum.triangles, {}, drum.creases}, options));
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 7, exercise 1: a drum", .keys = {}, .begin = begin, .draw = draw});
}
