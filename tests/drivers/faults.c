// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Faults of OpenGL drivers, each shown by a few calls and without glark. Prints the driver, then a line for each fault:
// its name, "yes", "no" or "unknown" (the driver lacks the feature), and what the driver did.
#include "tests/drivers/faults.h"

#include <stdio.h>

#include "tests/clients/scene/egl_display.h"

typedef const GLubyte* (*GetString)(GLenum name);

GLuint program_of(GLenum stage, const char* source, const char* captured) {
  const GLuint shader = glCreateShader(stage);
  const GLuint program = glCreateProgram();
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
  if (captured != NULL) {
    glTransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  }
  glLinkProgram(program);
  glUseProgram(program);
  return program;
}

void add_fragment_shader(GLuint program, const char* source) {
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glLinkProgram(program);
}

void bind_result(void) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof(float) * MOST_CORNERS, NULL, GL_STREAM_READ);
}

Capture capture(void (*draw)(GLenum), GLenum mode) {
  Capture result;
  GLuint query = 0;
  glGenQueries(1, &query);
  bind_result();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_TRIANGLES);
  draw(mode);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &result.triangles);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(result.corners), result.corners);
  glDeleteQueries(1, &query);
  return result;
}

void print_fault(const char* name, unsigned found, unsigned expected, const char* what) {
  printf("%s: %s: %u %s, expected %u\n", name, found == expected ? "no" : "yes", found, what, expected);
}

static void draw_with_an_empty_draw(GLenum mode) {
  const GLint first[] = {0, 4, 4};
  const GLsizei count[] = {4, 0, 4};
  glMultiDrawArrays(mode, first, count, 3);
}

static void draw_with_restart(GLenum mode) {
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  glDrawElements(mode, 9, GL_UNSIGNED_SHORT, NULL);
  glDisable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
}

// OpenGL 4.6 compatibility, 10.1 and 10.3.6: two quads are four triangles.
static void show_polygons(void) {
  static const GLushort indices[] = {0, 1, 2, 3, 0xFFFF, 4, 5, 6, 7};
  static const struct {
    const char* name;
    GLenum mode;
    void (*draw)(GLenum);
  } rows[] = {{"empty_draw_quads", GL_QUADS, draw_with_an_empty_draw},
              {"empty_draw_quad_strip", GL_QUAD_STRIP, draw_with_an_empty_draw},
              {"empty_draw_polygon", GL_POLYGON, draw_with_an_empty_draw},
              {"restart_quads", GL_QUADS, draw_with_restart},
              {"restart_quad_strip", GL_QUAD_STRIP, draw_with_restart},
              {"restart_polygon", GL_POLYGON, draw_with_restart}};
  GLuint buffer = 0;
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nout float number;\n"
             "void main() { number = float(gl_VertexID); gl_Position = vec4(1.0); }\n",
             "number");
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); ++i) {
    print_fault(rows[i].name, capture(rows[i].draw, rows[i].mode).triangles, 4, "triangles of two polygons");
  }
}

static GLuint captured_points = 0;  // a transform feedback object that has captured eight vertices

static void draw_captured(GLenum mode) { glDrawTransformFeedback(mode, captured_points); }

static void draw_captured_after_indirect(GLenum mode) {
  const GLuint no_vertices[] = {0, 1, 0, 0};
  GLuint commands = 0;
  glGenBuffers(1, &commands);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands);
  glBufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(no_vertices), no_vertices, GL_STATIC_DRAW);
  glDrawArraysIndirect(mode, NULL);
  glDrawTransformFeedback(mode, captured_points);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

// OpenGL 4.6, 13.3.2: the draw equals DrawArrays with as many vertices as were captured.
static void show_captured_polygons(void) {
  GLuint buffer = 0;
  glGenTransformFeedbacks(1, &captured_points);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, captured_points);
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 8 * sizeof(float), NULL, GL_DYNAMIC_COPY);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, 8);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nlayout(location = 0) in float value; out float number;\n"
             "void main() { number = value; gl_Position = vec4(1.0); }\n",
             "number");
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
  const unsigned fan = capture(draw_captured, GL_TRIANGLE_FAN).triangles;
  print_fault("captured_triangle_fan", fan, 6, "triangles of a fan");
  print_fault("captured_quads", capture(draw_captured, GL_QUADS).triangles, 4, "triangles of two quads");
  print_fault("captured_quad_strip", capture(draw_captured, GL_QUAD_STRIP).triangles, 6, "triangles of a quad strip");
  print_fault("captured_polygon", capture(draw_captured, GL_POLYGON).triangles, 6, "triangles of a polygon");
  print_fault("captured_after_indirect", capture(draw_captured_after_indirect, GL_TRIANGLE_FAN).triangles, fan,
              "triangles of a fan after an indirect draw of 0 vertices");
  glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 2 * sizeof(float), NULL);
  print_fault("captured_stride", capture(draw_captured, GL_TRIANGLE_FAN).triangles, fan,
              "triangles of a fan with an array of another stride");
}

// OpenGL 4.6, 5.1.3: the name of a deleted buffer is free, although a vertex array still holds the buffer.
static void show_name_of_deleted_buffer(void) {
  const float values[] = {1, 2};
  GLuint arrays[2] = {0, 0};
  GLuint buffer = 0;
  float found = 0;
  program_of(GL_VERTEX_SHADER,
             "#version 430\nlayout(location = 0) in float value; out float number;\n"
             "void main() { number = value; gl_Position = vec4(1.0); }\n",
             "number");
  glGenVertexArrays(2, arrays);
  glGenBuffers(1, &buffer);
  for (int i = 0; i < 2; ++i) {
    glBindVertexArray(arrays[0]);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof(float), &values[i], GL_STATIC_DRAW);
    glVertexAttribFormat(0, 1, GL_FLOAT, GL_FALSE, 0);
    glVertexAttribBinding(0, 0);
    glEnableVertexAttribArray(0);
    glBindVertexBuffer(0, buffer, 0, sizeof(float));
    if (i == 0) {
      glBindVertexArray(arrays[1]);
      glBindBuffer(GL_ARRAY_BUFFER, 0);
      glDeleteBuffers(1, &buffer);
    }
  }
  bind_result();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, 1);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(found), &found);
  print_fault("name_of_deleted_buffer", (unsigned)found, 2, "is the value of the new buffer");
}

static int make_current(void) {
  const EGLDisplay display = open_egl_display();
  if (display == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_API)) {
    return 0;
  }
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, NULL);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

static void bind_framebuffer(void) {
  GLuint framebuffer = 0;
  GLuint colours = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &colours);
  glBindRenderbuffer(GL_RENDERBUFFER, colours);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours);
  glViewport(0, 0, 8, 8);  // without a surface, it is empty
}

int make_context(void) {
  GLuint array = 0;
  if (!make_current()) {
    return 0;
  }
  bind_framebuffer();
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  return 1;
}

// A driver without OpenGL has no faults that are shown here. Prints its name.
static int print_es_driver(void) {
  static const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
  const EGLDisplay display = open_egl_display();
  EGLConfig config = NULL;
  EGLint configs = 0;
  if (display == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_ES_API) ||
      !eglChooseConfig(display, NULL, &config, 1, &configs)) {
    return 0;
  }
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  // libOpenGL reaches the drivers of libglvnd only.
  const GetString get_string = (GetString)eglGetProcAddress("glGetString");
  if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    return 0;
  }
  printf("renderer: %s\nversion: %s\n", (const char*)get_string(GL_RENDERER), (const char*)get_string(GL_VERSION));
  return 1;
}

int main(void) {
  GLint major = 0;
  GLint minor = 0;
  find_crashes();
  if (!make_context()) {
    if (print_es_driver()) {
      return 0;
    }
    fputs("faults: EGL gives no context\n", stderr);
    return 1;
  }
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  printf("renderer: %s\nversion: %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
  print_crashes();
  show_polygons();
  if (10 * major + minor >= 43) {
    show_captured_polygons();
    show_name_of_deleted_buffer();
  } else {
    puts("captured_quads: unknown: needs OpenGL 4.0\nname_of_deleted_buffer: unknown: needs OpenGL 4.3");
  }
  show_other_faults(10 * major + minor);
  return 0;
}
