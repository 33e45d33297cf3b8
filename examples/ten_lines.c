// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The smallest program of the extension: a coarse bowl, refined by the ten lines of draw(). The rest of the program
// makes an off-screen context and writes a picture.
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

enum { size = 512, corners = 8 };

static void draw(unsigned depth) {
  glARKinit(5);         // patterns for edges of up to 2^5 segments
  glEnable(GL_ARK);     // now patterns replace triangles
  glDepthTag1i(depth);  // the next vertices ask for 2^depth segments on each edge
  glBegin(GL_TRIANGLE_FAN);
  glNormal3f(0, 0, 1);
  glVertex3f(0, 0, 0);
  for (int i = 0; i <= corners; ++i) {
    const double turn = 2 * 3.14159265358979 * i / corners;
    glNormal3f((float)cos(turn), (float)sin(turn), 0.3f);
    glVertex3f(0.9f * (float)cos(turn), 0.9f * (float)sin(turn), -0.6f);
  }
  glEnd();
}

// A small light is close to the surface. With lighting per vertex, a coarse bowl misses its highlight.
static void light(void) {
  static const float position[4] = {0.3f, 0.3f, 0.6f, 1};
  static const float ground[4] = {0.1f, 0.4f, 0.8f, 1};
  static const float shine[4] = {1, 1, 1, 1};
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, ground);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
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
  light();
  draw(argc > 2 ? (unsigned)atoi(argv[2]) : 4);
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], size, size, 4, pixels, 4 * size);
  OSMesaDestroyContext(context);
  return written ? 0 : 1;
}
