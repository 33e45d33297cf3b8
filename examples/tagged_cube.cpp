// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Adaptive refinement: an array gives every vertex of a cube its own depth tag, and an edge gets the mean of its two
// ends. One corner is refined finely, the opposite one not at all. The wireframe shows that patterns of all kinds meet
// without cracks.
//
//   tagged_cube OUT.png
#include <GL/gl.h>
#include <GL/osmesa.h>

#include <array>
#include <cstdio>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int size = 512;
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

void look_at_corner() {
  glMatrixMode(GL_PROJECTION);
  glFrustum(-1, 1, -1, 1, 3, 20);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -7);
  glRotatef(35, 1, 0, 0);
  glRotatef(-35, 0, 1, 0);
}

void draw(const Cube& cube) {
  glARKinit(max_level);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, cube.positions.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, cube.depths.data());
  glDrawARPElementsARK(GL_TRIANGLES, static_cast<GLsizei>(cube.indices.size()), GL_UNSIGNED_BYTE, cube.indices.data());
}

// Draws the faces, then their edges over them.
void draw_with_edges(const Cube& cube) {
  glEnable(GL_CULL_FACE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  glColor3f(0.95F, 0.75F, 0.4F);
  draw(cube);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glColor3f(0.1F, 0.1F, 0.3F);
  draw(cube);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * size * size);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size) == GL_FALSE) {
    return 1;
  }
  glEnable(GL_DEPTH_TEST);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  look_at_corner();
  draw_with_edges(make_cube());
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], size, size, 4, pixels.data(), 4 * size);
  OSMesaDestroyContext(context);
  return written != 0 ? 0 : 1;
}
