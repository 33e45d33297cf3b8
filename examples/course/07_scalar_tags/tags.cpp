// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 7: scalar tags. Three numbers at the vertices of a crease change a curved surface: sharpness, tension, bias.
// The bars in the picture show the numbers; keys move them. The coarse mesh never changes.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/pn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr unsigned sides = 6;
constexpr int depth = 3;
glark::pn::Options sliders{.crease_degrees = 180};  // only the creases that the mesh names
bool wireframe = false;

struct Pawn {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles, creases;
};

struct Ring {
  float radius, height;
  bool sharp;
};
constexpr std::array<Ring, 6> rings = {{{0.75F, -1.0F, true},
                                        {0.75F, -0.7F, true},
                                        {0.3F, -0.3F, false},
                                        {0.28F, 0.25F, true},
                                        {0.55F, 0.6F, false},
                                        {0.3F, 1.0F, false}}};

// Six rings of six vertices, and the two ends of the axis.
Pawn make_pawn() {
  Pawn pawn;
  for (const Ring& ring : rings) {
    for (unsigned i = 0; i < sides; ++i) {
      const float turn = -6.2831853F * static_cast<float>(i) / sides;
      pawn.positions.insert(pawn.positions.end(),
                            {ring.radius * std::cos(turn), ring.height, ring.radius * std::sin(turn)});
    }
  }
  const auto bottom = static_cast<std::uint32_t>(rings.size()) * sides;
  pawn.positions.insert(pawn.positions.end(), {0, rings.front().height, 0, 0, rings.back().height + 0.1F, 0});
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides, last = bottom - sides;
    for (std::uint32_t low = 0; low < last; low += sides)
      pawn.triangles.insert(pawn.triangles.end(), {low + i, low + next, low + sides + next,  //
                                                   low + i, low + sides + next, low + sides + i});
    pawn.triangles.insert(pawn.triangles.end(), {bottom, next, i, bottom + 1, last + i, last + next});
    // [creases]
    for (std::uint32_t ring = 0; ring < rings.size(); ++ring)
      if (rings[ring].sharp) pawn.creases.insert(pawn.creases.end(), {ring * sides + i, ring * sides + next});
    // [/creases]
  }
  return pawn;
}

// [arrays]
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
// [/arrays]

// A bar for each slider, from `low` to `high`. Bars must not be refined.
void draw_slider(int row, float low, float high, float value) {
  const float y = -0.9F + 0.09F * static_cast<float>(row);
  const float at = -0.95F + 0.45F * (value - low) / (high - low);
  glColor3f(0.75F, 0.75F, 0.78F);
  glRectf(-0.95F, y, -0.5F, y + 0.05F);
  glColor3f(0.15F, 0.35F, 0.7F);
  glRectf(at - 0.02F, y - 0.01F, at + 0.02F, y + 0.06F);
}

void draw_sliders() {
  for (const GLenum off : {GL_ARK, GL_LIGHTING, GL_DEPTH_TEST}) glDisable(off);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  draw_slider(2, 0, 1, sliders.sharpness);
  draw_slider(1, -1, 1, sliders.tension);
  draw_slider(0, -1, 1, sliders.bias);
}

// [draw]
void draw(double) {
  const Pawn pawn = make_pawn();
  const glark::pn::TaggedMesh tagged =
      glark::pn::derive_tags({pawn.positions, pawn.triangles, {}, pawn.creases}, sliders);
  glEnable(GL_ARK);
  lesson::look(3.6F, 15, 20);
  lesson::light();
  glColor3f(0.85F, 0.65F, 0.4F);
  if (wireframe) lesson::draw_with_edges([&] { draw_tagged(tagged); });
  if (!wireframe) draw_tagged(tagged);
  draw_sliders();
  lesson::say("sharpness %g, tension %g, bias %g", sliders.sharpness, sliders.tension, sliders.bias);
}
// [/draw]

void begin() {
  glARKinit(depth);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, depth);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY}) glEnableClientState(array);
}

void move(float& slider, float by, float low) { slider = std::clamp(slider + by, low, 1.0F); }

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 7: scalar tags",
                      .keys = {{'s', "less sharpness", [] { move(sliders.sharpness, -0.25F, 0); }},
                               {'S', "more sharpness", [] { move(sliders.sharpness, 0.25F, 0); }},
                               {'t', "less tension", [] { move(sliders.tension, -0.25F, -1); }},
                               {'T', "more tension", [] { move(sliders.tension, 0.25F, -1); }},
                               {'b', "less bias", [] { move(sliders.bias, -0.25F, -1); }},
                               {'B', "more bias", [] { move(sliders.bias, 0.25F, -1); }},
                               {'w', "wireframe", [] { wireframe = !wireframe; }}},
                      .begin = begin,
                      .draw = draw});
}
