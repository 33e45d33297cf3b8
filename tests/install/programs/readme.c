// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Runs the README's program off-screen. check_package.py writes its lines to readme_lines.inc.
// Prints the version of the headers and the number of pixels that the program covers.
#include <GL/glark.h>
#include <GL/glark_version.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>

enum { size = 128, depth = 4 };

static unsigned char pixels[4 * size * size];

static void draw(void) {
#include "readme_lines.inc"
}

int main(void) {
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, size, size)) return 1;
  glClear(GL_COLOR_BUFFER_BIT);
  draw();
  glFinish();
  const GLenum error = glGetError();
  int covered = 0;
  for (int i = 0; i < size * size; ++i) covered += pixels[4 * i] != 0;
  printf("%s %d\n", GLARK_VERSION_STRING, covered);
  OSMesaDestroyContext(context);
  return error == GL_NO_ERROR ? 0 : 1;
}
