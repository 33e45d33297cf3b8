// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A fixed-function scene: a lit sphere from client arrays beside a lit cube and a fan. A client defines GL(name) before
// it includes this file. GL(name) stands for the function glname, however the client found it. functions.h lists these
// functions.
#pragma once

#include "tests/clients/scene/picture.h"
#include "tests/clients/scene/sphere.h"

static void scene_setup(void) {
  const GLfloat light[4] = {2, 3, 4, 0};
  GL(Viewport)(0, 0, picture_size, picture_size);
  GL(ClearColor)(0.1f, 0.2f, 0.3f, 1);
  GL(Enable)(GL_DEPTH_TEST);
  GL(Enable)(GL_CULL_FACE);
  GL(Enable)(GL_LIGHTING);
  GL(Enable)(GL_LIGHT0);
  GL(Enable)(GL_COLOR_MATERIAL);
  GL(ColorMaterial)(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  GL(MatrixMode)(GL_PROJECTION);
  GL(LoadIdentity)();
  GL(Frustum)(-1, 1, -1, 1, 2, 10);
  GL(MatrixMode)(GL_MODELVIEW);
  GL(LoadIdentity)();
  GL(Lightfv)(GL_LIGHT0, GL_POSITION, light);
  GL(Translatef)(0, 0, -5);
  GL(Rotatef)(25, 1, 0.5f, 0);
}

static inline void scene_begin_frame(void) { GL(Clear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }

static inline void scene_sphere(void) {
  static GLfloat positions[3 * sphere_corners];
  static GLushort indices[sphere_indices];
  make_sphere(positions, indices);
  GL(EnableClientState)(GL_VERTEX_ARRAY);
  GL(EnableClientState)(GL_NORMAL_ARRAY);
  GL(VertexPointer)(3, GL_FLOAT, 0, positions);
  GL(NormalPointer)(GL_FLOAT, 0, positions);
  GL(PushMatrix)();
  GL(Translatef)(-0.7f, 0.4f, 0);
  GL(Color3f)(0.9f, 0.6f, 0.2f);
  GL(DrawElements)(GL_TRIANGLES, sphere_indices, GL_UNSIGNED_SHORT, indices);
  GL(Translatef)(1.9f, -1.2f, 0.4f);
  GL(Color3f)(0.4f, 0.8f, 0.5f);
  GL(DrawArrays)(GL_TRIANGLE_FAN, 3 * (sphere_sectors + 1), sphere_sectors + 1);
  GL(PopMatrix)();
  GL(DisableClientState)(GL_VERTEX_ARRAY);
  GL(DisableClientState)(GL_NORMAL_ARRAY);
}

static inline void scene_cube(void) {
  // Each row has two vectors along a face. The third axis is their product.
  static const float faces[6][2][3] = {{{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 0, 1}},
                                       {{0, 0, 1}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 0}}, {{1, 0, 0}, {0, 0, 1}}};
  static const float signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const float half = 0.5f;
  GL(PushMatrix)();
  GL(Translatef)(0.9f, 0.9f, -0.5f);
  GL(Color3f)(0.3f, 0.5f, 0.9f);
  GL(Begin)(GL_QUADS);
  for (int face = 0; face < 6; ++face) {
    const float* u = faces[face][0];
    const float* v = faces[face][1];
    const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    GL(Normal3f)(n[0], n[1], n[2]);
    for (int i = 0; i < 4; ++i) {
      const float a = signs[i][0];
      const float b = signs[i][1];
      GL(Vertex3f)
      (half * (n[0] + a * u[0] + b * v[0]), half * (n[1] + a * u[1] + b * v[1]), half * (n[2] + a * u[2] + b * v[2]));
    }
  }
  GL(End)();
  GL(PopMatrix)();
}

static inline void scene_draw(void) {
  scene_begin_frame();
  scene_sphere();
  scene_cube();
}

// Reads the last frame back, before the buffers are swapped.
static inline void scene_read(unsigned char pixels[4 * picture_size * picture_size]) {
  GL(Finish)();
  GL(PixelStorei)(GL_PACK_ALIGNMENT, 1);
  GL(ReadPixels)(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  require(GL(GetError)() == GL_NO_ERROR, "the scene raised a GL error");
}
