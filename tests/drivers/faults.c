// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Faults of OpenGL drivers, each shown by a few calls and without glark. Prints the driver, then a line for each fault:
// its name, "yes", "no" or "unknown" (the driver lacks the feature), and what the driver did.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/clients/scene/egl_display.h"

#define MOST_CORNERS 64

typedef const GLubyte* (*GetString)(GLenum name);

typedef struct {
  unsigned triangles;
  float corners[MOST_CORNERS];  // the number of each vertex
} Capture;

static GLuint program_of(GLenum stage, const char* source, const char* captured) {
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

// Adds a fragment shader, and links again.
static void add_fragment_shader(GLuint program, const char* source) {
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glLinkProgram(program);
}

static void bind_result(void) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof(float) * MOST_CORNERS, NULL, GL_STREAM_READ);
}

// The triangles that the driver makes of a draw.
static Capture capture(void (*draw)(GLenum), GLenum mode) {
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

static void print_fault(const char* name, unsigned found, unsigned expected, const char* what) {
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
  print_fault("captured_triangle_fan", capture(draw_captured, GL_TRIANGLE_FAN).triangles, 6, "triangles of a fan");
  print_fault("captured_quads", capture(draw_captured, GL_QUADS).triangles, 4, "triangles of two quads");
  print_fault("captured_quad_strip", capture(draw_captured, GL_QUAD_STRIP).triangles, 6, "triangles of a quad strip");
  print_fault("captured_polygon", capture(draw_captured, GL_POLYGON).triangles, 6, "triangles of a polygon");
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

static void draw_two_triangles(GLenum mode) { glDrawArrays(mode, 0, 6); }

// OpenGL 4.6, 10.3.6: only draws with indices restart.
static void show_restart_without_indices(void) {
  program_of(GL_VERTEX_SHADER,
             "#version 330 compatibility\nout float number;\n"
             "void main() { number = float(gl_VertexID); gl_Position = vec4(1.0); }\n",
             "number");
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(4);
  print_fault("restart_arrays", capture(draw_two_triangles, GL_TRIANGLES).triangles, 2, "triangles of six vertices");
  glDisable(GL_PRIMITIVE_RESTART);
}

static void draw_quad(GLenum mode) { glDrawArrays(mode, 0, 4); }

// OpenGL 4.6 compatibility, 13.4: the last vertex of a quad provokes. Triangles that end with it can show its colour.
static void show_captured_provoking_vertex(void) {
  const Capture quad = capture(draw_quad, GL_QUADS);
  print_fault("captured_provoking", (quad.corners[2] == 3) + (quad.corners[5] == 3), 2,
              "triangles of a quad end with its last vertex");
}

// OpenGL 4.6, 4.2.3: the result of a query goes into a buffer. What is written beside it later must stay.
static void show_data_after_query(void) {
  const GLuint one = 1;
  GLuint words[5] = {0, 0, 0, 0, 0};
  GLuint buffer = 0;
  GLuint query = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  glBufferData(GL_COPY_WRITE_BUFFER, sizeof(words), words, GL_DYNAMIC_COPY);
  glGenQueries(1, &query);
  bind_result();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBuffer(GL_QUERY_BUFFER, buffer);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, (GLuint*)sizeof(GLuint));
  glBindBuffer(GL_QUERY_BUFFER, 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  glBufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, sizeof(one), &one);
  glDrawArraysIndirect(GL_TRIANGLES, NULL);
  glGetBufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, sizeof(words), words);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  print_fault("data_after_query", words[0], 1, "is the word that was written beside the result of a query");
}

// OpenGL 4.6, 13.3.2: a feedback may end while it is paused.
static void show_link_after_feedback(void) {
  GLint program = 0;
  GLuint other = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  other = program_of(GL_VERTEX_SHADER, "#version 330 compatibility\nvoid main() { gl_Position = vec4(1.0); }\n", NULL);
  glUseProgram((GLuint)program);
  bind_result();
  glBeginTransformFeedback(GL_TRIANGLES);
  glPauseTransformFeedback();
  glUseProgram(other);
  glEndTransformFeedback();
  while (glGetError() != GL_NO_ERROR) {
  }
  glLinkProgram(other);
  print_fault("link_after_feedback", glGetError(), 0,
              "is the error of glLinkProgram after a feedback that ended paused");
  // The driver believes in a feedback that goes on; the next one ends it.
  glUseProgram((GLuint)program);
  glBeginTransformFeedback(GL_TRIANGLES);
  glEndTransformFeedback();
}

// OpenGL 4.6 compatibility, chapter 22: arrays are client state, also those of a named vertex array.
static void show_client_arrays(void) {
  GLint enabled = 0;
  glEnableVertexAttribArray(7);
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glDisableVertexAttribArray(7);
  glPopClientAttrib();
  glGetVertexAttribiv(7, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
  glDisableVertexAttribArray(7);
  print_fault("client_arrays", (unsigned)enabled, 1, "says whether glPopClientAttrib restores an array");
}

static unsigned red_of_square(float depth_left, float depth_right) {
  GLubyte pixel[4];
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glVertex3f(-1, -1, depth_left);
  glVertex3f(1, -1, depth_right);
  glVertex3f(1, 1, depth_right);
  glVertex3f(-1, 1, depth_left);
  glEnd();
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return pixel[0];
}

// OpenGL 4.6 compatibility, 12.1.3: a scale of 2 divides normals by 2, and gl_NormalScale is 2.
static void show_normal_scale(void) {
  program_of(GL_VERTEX_SHADER,
             "#version 120\nvoid main() { gl_Position = gl_Vertex; gl_FrontColor = vec4(0.25 * gl_NormalScale); }\n",
             NULL);
  glEnable(GL_RESCALE_NORMAL);
  glScalef(2, 2, 2);
  print_fault("normal_scale", (red_of_square(0, 0) + 16) / 32, 4, "is twice the gl_NormalScale of a scale of 2");
  glLoadIdentity();
  glDisable(GL_RESCALE_NORMAL);
}

// OpenGL 4.6 compatibility, 17.4: both are allowed. Where depths change their sign, refinement shows it.
static void show_fog_of_fragments(void) {
  const float black[] = {0, 0, 0, 1};
  glUseProgram(0);
  glColor4f(1, 1, 1, 1);
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogfv(GL_FOG_COLOR, black);
  print_fault("fog_of_fragments", red_of_square(-0.5F, 0.5F) > 160, 0,
              "says whether each fragment takes the absolute depth");
  glDisable(GL_FOG);
}

static int make_context(void) {
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

// Captures with a clip distance that the program does not write, and draws with a program that writes it.
static void capture_and_clip(void) {
  const float corners[] = {-1, -1, 1, -1, 0, 1};
  GLuint buffer = 0;
  GLubyte pixel[4];
  const GLuint clipped =
      program_of(GL_VERTEX_SHADER,
                 "#version 430\nlayout(location = 0) in vec2 position; out float gl_ClipDistance[1];\n"
                 "void main() { gl_Position = vec4(position, 0.0, 1.0); gl_ClipDistance[0] = position.x; }\n",
                 NULL);
  add_fragment_shader(clipped, "#version 430\nout vec4 colour; void main() { colour = vec4(1.0); }\n");
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners, GL_STATIC_DRAW);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
  glEnable(GL_CLIP_DISTANCE0);
  program_of(GL_VERTEX_SHADER,
             "#version 430\nlayout(location = 0) in vec2 position; out vec4 number;\n"
             "void main() { number = vec4(position, 0.0, 1.0); gl_Position = vec4(position, 0.0, 1.0); }\n",
             "number");
  bind_result();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glUseProgram(clipped);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

// Draws captured vertices beside an array of integers, which become floats. Drivers convert such arrays by themselves.
static void draw_captured_integers(void) {
  const GLuint tags[12] = {0};
  GLuint buffers[2];
  program_of(GL_VERTEX_SHADER,
             "#version 430\nout float number; void main() { number = float(gl_VertexID); gl_Position = vec4(0.0); }\n",
             "number");
  glGenTransformFeedbacks(1, &captured_points);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, captured_points);
  glGenBuffers(2, buffers);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[0]);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 12 * sizeof(float), NULL, GL_DYNAMIC_COPY);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, 12);
  glEndTransformFeedback();
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
  glVertexAttribPointer(1, 1, GL_UNSIGNED_INT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(1);
  program_of(GL_VERTEX_SHADER,
             "#version 430\nlayout(location = 0) in float value; layout(location = 1) in float tag; out float number;\n"
             "void main() { number = value + tag; gl_Position = vec4(0.0); }\n",
             "number");
  bind_result();
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawTransformFeedback(GL_TRIANGLES, captured_points);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glFinish();
}

// A program of ARB_vertex_program gets another text, and draws each.
static void draw_replaced_text(void) {
  static const char* const texts[] = {
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, vertex.color;\nEND\n",
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nADD result.color, vertex.color, vertex.color;\nEND\n"};
  const PFNGLGENPROGRAMSARBPROC generate = (PFNGLGENPROGRAMSARBPROC)eglGetProcAddress("glGenProgramsARB");
  const PFNGLBINDPROGRAMARBPROC bind = (PFNGLBINDPROGRAMARBPROC)eglGetProcAddress("glBindProgramARB");
  const PFNGLPROGRAMSTRINGARBPROC set_text = (PFNGLPROGRAMSTRINGARBPROC)eglGetProcAddress("glProgramStringARB");
  GLuint program = 0;
  generate(1, &program);
  bind(GL_VERTEX_PROGRAM_ARB, program);
  glEnable(GL_VERTEX_PROGRAM_ARB);
  for (int i = 0; i < 8; ++i) {
    set_text(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, (GLsizei)strlen(texts[i % 2]), texts[i % 2]);
    glRectf(-1, -1, 1, 1);
    glFinish();
  }
}

// GL_FEEDBACK with a shader that chooses between two values.
static void draw_feedback_of_shader(void) {
  static float values[1000];
  program_of(GL_VERTEX_SHADER,
             "#version 120\n"
             "void main() { gl_Position = gl_Vertex;\n"
             "  gl_FrontColor = vec4(gl_Color.y == 0.0 ? 1.0 : pow(max(gl_Color.x, 0.0), gl_Color.y)); }\n",
             NULL);
  glFeedbackBuffer(1000, GL_4D_COLOR_TEXTURE, values);
  glRenderMode(GL_FEEDBACK);
  glBegin(GL_POINTS);
  for (int i = 0; i < 9; ++i) glVertex2f(0.1F * (float)i, 0.1F);
  glEnd();
  glRenderMode(GL_RENDER);
}

// Runs `draw` in a process of its own. Call before there is a context.
static unsigned signal_of(void (*draw)(void)) {
  int status = 0;
  const pid_t child = fork();
  if (child == 0) {
    GLuint array = 0;
    if (make_context()) {
      bind_framebuffer();
      glGenVertexArrays(1, &array);
      glBindVertexArray(array);
      draw();
    }
    _exit(0);
  }
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? (unsigned)WTERMSIG(status) : 0;
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
  const unsigned clip_signal = signal_of(capture_and_clip);
  const unsigned integer_signal = signal_of(draw_captured_integers);
  const unsigned text_signal = signal_of(draw_replaced_text);
  const unsigned feedback_signal = signal_of(draw_feedback_of_shader);
  GLint major = 0;
  GLint minor = 0;
  GLuint array = 0;
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
  print_fault("capture_and_clip", clip_signal, 0, "is the signal that ends a program");
  print_fault("captured_integers", integer_signal, 0, "is the signal that ends a program");
  print_fault("program_string_again", text_signal, 0, "is the signal that ends a program");
  print_fault("feedback_of_shaders", feedback_signal, 0, "is the signal that ends a program");
  bind_framebuffer();
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  show_polygons();
  show_restart_without_indices();
  show_captured_provoking_vertex();
  show_client_arrays();
  if (10 * major + minor >= 43) {
    show_captured_polygons();
    show_name_of_deleted_buffer();
    show_link_after_feedback();
  } else {
    puts("captured_quads: unknown: needs OpenGL 4.0\nname_of_deleted_buffer: unknown: needs OpenGL 4.3");
  }
  if (10 * major + minor >= 44) {
    show_data_after_query();
  }
  show_normal_scale();
  show_fog_of_fragments();
  return 0;
}
