// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Adaptive refinement: an array gives every vertex of a cube its own depth tag, and an edge gets the mean of its two
// ends. One corner is refined finely, the opposite one not at all. The wireframe shows that patterns of all kinds meet
// without cracks.
//
//   tagged_cube [OUT.png]
#include <GL/gl.h>

#include <array>

#include <GL/glark.h>
#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr unsigned max_level = 5;

struct Cube {
  std::array<float, 24> positions{};        // xyz of corner i: bit k of i is the side on axis k
  std::array<unsigned char, 8> depths{};    // the tag of corner i: max_level at corner 7, less at farther corners
  std::array<unsigned char, 36> indices{};  // 12 triangles, counter-clockwise from outside
};

Cube make_cube() {
  Cube cube;
  for (unsigned corner = 0; corner < 8; ++corner) {
    unsigned sides = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned side = (corner >> axis) & 1U;
      cube.positions[3 * corner + axis] = side != 0 ? 1.0F : -1.0F;
      sides += side;
    }
    cube.depths[corner] = static_cast<unsigned char>(sides * max_level / 3);
  }
  cube.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                  2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return cube;
}

const Cube cube = make_cube();

void begin() {
  glARKinit(max_level);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, cube.positions.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, cube.depths.data());
}

void draw(double) {
  lesson::look(6.5F, -35, 35);
  glColor3f(0.95F, 0.75F, 0.4F);
  lesson::draw_with_edges([] {
    glDrawARPElementsARK(GL_TRIANGLES, static_cast<GLsizei>(cube.indices.size()), GL_UNSIGNED_BYTE,
                         cube.indices.data());
  });
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "tagged_cube", .keys = {}, .begin = begin, .draw = draw, .width = 512, .height = 512});
}
