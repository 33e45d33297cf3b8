// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws one red triangle with functions that the program has found in its own way. Prints the result.
#pragma once
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

struct Functions {
  void (*clear)(GLbitfield);
  void (*draw_arrays)(GLenum, GLint, GLsizei);
  void (*vertex_pointer)(GLint, GLenum, GLsizei, const void*);
  void (*enable_client_state)(GLenum);
  void (*color)(GLfloat, GLfloat, GLfloat);
  void (*finish)(void);
  const GLubyte* (*get_string)(GLenum);
  GLenum (*get_error)(void);
  OSMesaContext (*create)(GLenum, GLint, GLint, GLint, OSMesaContext);
  GLboolean (*make_current)(OSMesaContext, void*, GLenum, GLsizei, GLsizei);
  void (*destroy)(OSMesaContext);
};

static int is_ours(void* function) {
  Dl_info info;
  return dladdr(function, &info) && strstr(info.dli_fname, "libGLARK.so") != NULL;
}

static int draw(const struct Functions* gl) {
  static unsigned char pixels[16 * 16 * 4];
  static const GLfloat positions[] = {-1, -1, 3, -1, -1, 3};
  OSMesaContext context = gl->create(OSMESA_RGBA, 24, 8, 0, NULL);
  if (context == NULL || !gl->make_current(context, pixels, GL_UNSIGNED_BYTE, 16, 16)) return 3;
  gl->clear(GL_COLOR_BUFFER_BIT);
  gl->color(1, 0, 0);
  gl->vertex_pointer(2, GL_FLOAT, 0, positions);
  gl->enable_client_state(GL_VERTEX_ARRAY);
  gl->draw_arrays(GL_TRIANGLES, 0, 3);
  gl->finish();
  const unsigned char* middle = &pixels[(8 * 16 + 8) * 4];
  printf("color %d %d %d\n", middle[0], middle[1], middle[2]);
  printf("error %x\n", gl->get_error());
  printf("extension %s\n",
         strstr((const char*)gl->get_string(GL_EXTENSIONS), "GL_ARK_adaptive_refinement") ? "yes" : "no");
  gl->destroy(context);
  return 0;
}
