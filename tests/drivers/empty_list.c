// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A fault of OpenGL drivers that shows by GLX only: glCallList refuses an empty list during transform feedback. Prints
// what the driver does, without glark.
#define GL_GLEXT_PROTOTYPES
#include <GL/glx.h>

#include <stdio.h>

#include "tests/drivers/faults.h"

static int make_window_current(void) {
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, None};
  Display* const display = XOpenDisplay(NULL);
  XVisualInfo* const visual = display != NULL ? glXChooseVisual(display, DefaultScreen(display), wanted) : NULL;
  if (visual == NULL) {
    return 0;
  }
  const Window root = RootWindow(display, visual->screen);
  XSetWindowAttributes attributes = {.colormap = XCreateColormap(display, root, visual->visual, AllocNone)};
  const Window window = XCreateWindow(display, root, 0, 0, 64, 64, 0, visual->depth, InputOutput, visual->visual,
                                      CWBorderPixel | CWColormap, &attributes);
  XMapWindow(display, window);
  return glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
}

static void draw_triangle(void) {
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) glVertex2i(i & 1, i >> 1);
  glEnd();
}

// A program that captures its positions into a buffer.
static void capture_positions(void) {
  const char* const source = "#version 120\nvoid main() { gl_Position = gl_Vertex; }\n";
  const char* const captured = "gl_Position";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const GLuint program = glCreateProgram();
  GLuint buffer = 0;
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glTransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  glUseProgram(program);
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 4096, NULL, GL_DYNAMIC_COPY);
}

static GLuint compile(void (*draw)(void)) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw();
  glEndList();
  return list;
}

static void draw_nothing(void) {}

static void draw_point(void) {
  glBegin(GL_POINTS);
  glVertex2i(0, 0);
  glEnd();
}

// Draws a triangle during transform feedback, and calls a list. Returns the error of the call.
static GLenum error_of_call(GLuint list) {
  glBeginTransformFeedback(GL_TRIANGLES);
  draw_triangle();
  while (glGetError() != GL_NO_ERROR) {
  }
  glCallList(list);
  const GLenum error = glGetError();
  glEndTransformFeedback();
  return error;
}

int main(void) {
  if (!make_window_current()) {
    fputs("empty_list: GLX gives no context\n", stderr);
    return 77;
  }
  printf("renderer: %s\nversion: %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
  capture_positions();
  // OpenGL 4.6 compatibility, 13.3.2: only a draw in another mode is an error. Such a draw comes first, because an empty
  // list that is called before any other succeeds.
  error_of_call(compile(draw_point));
  const unsigned error = error_of_call(compile(draw_nothing));
  printf("empty_list: %s: %u is the error of glCallList of an empty list during transform feedback, expected 0\n",
         error == 0 ? "no" : "yes", error);
  return 0;
}
