// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The smallest program of the extension: a bowl of eight triangles, upside down, that becomes round. The lines of
// draw() are all of it. The rest of the program makes an off-screen context and writes a picture. C99.
//
//   ten_lines OUT.png [DEPTH [wireframe]]     DEPTH 0 leaves it coarse
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

enum { size = 512 };

static void draw(unsigned depth) {
  // [draw]
  glARKinit(5);                                             // patterns for edges of up to 2^5 segments
  glEnable(GL_ARK);                                         // now patterns replace triangles
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);  // and normals bend them
  glDepthTag1i(depth);                                      // the next vertices ask for 2^depth segments on each edge
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glBegin(GL_TRIANGLE_FAN);
  glNormal3f(0, 0, 1);
  glVertex3f(0, 0, 0.9f);
  for (int i = 0; i <= 8; ++i) {
    const float x = cosf(0.785398f * i), y = sinf(0.785398f * i);
    glNormal3f(x, y, 0);
    glVertex3f(0.9f * x, 0.9f * y, 0);
  }
  glEnd();
  // [/draw]
}

// Looks from the side, with a shiny material.
static void prepare(void) {
  static const float left[4] = {-0.5f, 0.6f, 0.8f, 0};
  static const float ground[4] = {0.1f, 0.4f, 0.8f, 1};
  static const float shine[4] = {1, 1, 1, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, left);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, ground);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  glEnable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glOrtho(-1, 1, -0.8, 1.2, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glRotatef(-60, 1, 0, 0);
}

int main(int argc, char** argv) {
  static unsigned char pixels[4 * size * size];
  if (argc < 2) {
    fprintf(stderr, "usage: %s OUT.png [DEPTH [wireframe]]\n", argv[0]);
    return 2;
  }
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, size, size)) return 1;
  if (argc > 3 && strcmp(argv[3], "wireframe") == 0) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  prepare();
  draw(argc > 2 ? (unsigned)atoi(argv[2]) : 4);
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], size, size, 4, pixels, 4 * size);
  OSMesaDestroyContext(context);
  return written ? 0 : 1;
}
