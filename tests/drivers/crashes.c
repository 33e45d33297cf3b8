// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Calls that crash some drivers.
#include <EGL/egl.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/drivers/faults.h"

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

// Draws captured vertices together with an array of integers that the shader reads as floats.
static void draw_captured_integers(void) {
  const GLuint tags[12] = {0};
  GLuint points = 0;
  GLuint buffers[2];
  program_of(GL_VERTEX_SHADER,
             "#version 430\nout float number; void main() { number = float(gl_VertexID); gl_Position = vec4(0.0); }\n",
             "number");
  glGenTransformFeedbacks(1, &points);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, points);
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
  glDrawTransformFeedback(GL_TRIANGLES, points);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glFinish();
}

// Replaces the text of a vertex program (ARB_vertex_program) again and again, and draws with each text.
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

// Draws points in feedback mode (glRenderMode), with a shader that has a conditional expression.
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

// Compiles a list in which a vertex comes before evaluated ones.
static void compile_evaluated_vertices(void) {
  glNewList(1, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  glVertex2f(0, 0);
  for (int i = 0; i < 14; ++i) glEvalCoord1f((float)i / 14);
  glEnd();
  glEndList();
}

static struct {
  const char* name;
  void (*draw)(void);
  unsigned signal;  // that ended it
} crashes[] = {{"capture_and_clip", capture_and_clip, 0},
               {"captured_integers", draw_captured_integers, 0},
               {"program_string_again", draw_replaced_text, 0},
               {"feedback_of_shaders", draw_feedback_of_shader, 0},
               {"evaluated_list", compile_evaluated_vertices, 0}};
enum { crash_count = sizeof(crashes) / sizeof(crashes[0]) };

static unsigned signal_of(void (*draw)(void)) {
  int status = 0;
  const pid_t child = fork();
  if (child == 0) {
    if (make_context()) {
      draw();
    }
    _exit(0);
  }
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? (unsigned)WTERMSIG(status) : 0;
}

void find_crashes(void) {
  for (int i = 0; i < crash_count; ++i) crashes[i].signal = signal_of(crashes[i].draw);
}

void print_crashes(void) {
  for (int i = 0; i < crash_count; ++i)
    print_fault(crashes[i].name, crashes[i].signal, 0, "is the signal that ends a program");
}
