// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar-tagged PN triangles: one coarse mesh of 72 triangles, a turned spindle with four rings that should be sharp.
// From the left, the picture shows:
// - the coarse mesh;
// - curved PN triangles, which round the rings off;
// - the spindle with the tags that glark/pn.h derives from the hard edges;
// - the spindle with another bias;
// - the spindle with another tension.
// Between these, only numbers at the vertices change.
//
//   scalar_tags [OUT.png]
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <GL/glark.h>
#include <glark/pn.h>
#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int level = 4;
constexpr unsigned sides = 6;

// The coarse mesh has rings of vertices with these radii and heights, and the two ends of the axis.
struct Ring {
  float radius, z;
};
constexpr std::array<Ring, 6> rings = {
    {{0.35F, -1.0F}, {0.55F, -0.75F}, {0.3F, -0.3F}, {0.3F, 0.3F}, {0.55F, 0.75F}, {0.35F, 1.0F}}};
constexpr std::array<unsigned, 4> sharp_rings = {0, 1, 4, 5};

struct Spindle {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> creases;  // pairs of vertices
};

Spindle make_spindle() {
  Spindle spindle;
  for (const Ring& ring : rings) {
    for (unsigned i = 0; i < sides; ++i) {
      const double turn = 2 * M_PI * i / sides;
      spindle.positions.insert(spindle.positions.end(), {ring.radius * static_cast<float>(std::cos(turn)),
                                                         ring.radius * static_cast<float>(std::sin(turn)), ring.z});
    }
  }
  const std::uint32_t bottom = rings.size() * sides;
  spindle.positions.insert(spindle.positions.end(), {0, 0, rings.front().z, 0, 0, rings.back().z});
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
      const std::uint32_t low = ring * sides;
      const std::uint32_t high = low + sides;
      spindle.triangles.insert(spindle.triangles.end(),
                               {low + i, low + next, high + next, low + i, high + next, high + i});
    }
    const std::uint32_t last = bottom - sides;
    spindle.triangles.insert(spindle.triangles.end(), {bottom, next, i, bottom + 1, last + i, last + next});
    for (const unsigned ring : sharp_rings)
      spindle.creases.insert(spindle.creases.end(), {ring * sides + i, ring * sides + next});
  }
  return spindle;
}

// The program sets positions and normals as usual. The tags are in the two attributes of the extension.
void draw(const glark::pn::TaggedMesh& mesh) {
  GLint discontinuity = 0;
  GLint tags = 0;
  glGetIntegerv(GL_DISCONTINUITY_ATTRIBUTE_ARK, &discontinuity);
  glGetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &tags);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glEnableClientState(GL_NORMAL_ARRAY);
  glNormalPointer(GL_FLOAT, 0, mesh.normals.data());
  glEnableVertexAttribArray(static_cast<GLuint>(discontinuity));
  glVertexAttribPointer(static_cast<GLuint>(discontinuity), 4, GL_FLOAT, GL_FALSE, 0, mesh.discontinuities.data());
  glEnableVertexAttribArray(static_cast<GLuint>(tags));
  glVertexAttribPointer(static_cast<GLuint>(tags), 3, GL_FLOAT, GL_FALSE, 0, mesh.tags.data());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size()), GL_UNSIGNED_INT, mesh.triangles.data());
}

void place(int column) {
  lesson::use_part(column, 5);
  lesson::look(3.9F, 0, 25);
  glRotatef(-90, 1, 0, 0);
}

void draw_all(double) {
  const Spindle spindle = make_spindle();
  const glark::pn::Mesh mesh{spindle.positions, spindle.triangles, {}, spindle.creases};
  glark::pn::Options only_named;
  only_named.crease_degrees = 180;
  glark::pn::Options biased = only_named;
  biased.bias = -1;
  glark::pn::Options tense = only_named;
  tense.tension = 1;

  const glark::pn::TaggedMesh smooth =
      derive_tags({spindle.positions, spindle.triangles}, only_named);  // nothing is sharp
  glDisable(GL_ARK);
  place(0);
  draw(smooth);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  place(1);
  draw(smooth);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  int column = 2;
  for (const glark::pn::Options& options : {only_named, biased, tense}) {
    place(column++);
    draw(derive_tags(mesh, options));
  }
}

void begin() {
  glARKinit(level);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
  lesson::light();
  glColor3f(0.8F, 0.55F, 0.3F);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(
      argc, argv, {.title = "scalar_tags", .keys = {}, .begin = begin, .draw = draw_all, .width = 1200, .height = 480});
}
