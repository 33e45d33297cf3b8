// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Could a thread with a shared context compile glark's passes? Prints, in milliseconds of processor time, what a compute
// pass costs the first context when it links it, prepares it (an indirect dispatch of no work groups) and uses it: alone,
// and after a thread has linked, prepared and used the same program in a context that shares objects.
// With names of files, prints instead what each of these passes costs (passes.py). docs/explanation/compiling.md has the
// results. Run it with MESA_SHADER_CACHE_DISABLE=true.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tests/clients/scene/egl_display.h"

static const char pass[] =
    "#version 430\n"
    "layout(local_size_x = 64) in;\n"
    "layout(std430, binding = 0) buffer Words { uint words[]; };\n"
    "shared uint sums[64];\n"
    "void main() {\n"
    "  uint self = gl_LocalInvocationID.x;\n"
    "  uint sum = %uu;\n"  // another program each time
    "  for (uint i = 0u; i < words[0]; ++i) {\n"
    "    sum = sum * 31u + words[(self + i) & 63u];\n"
    "    if (sum > 1000u) words[self] = atomicAdd(words[(sum ^ self) & 63u], i);\n"
    "  }\n"
    "  sums[self] = sum;\n"
    "  barrier();\n"
    "  for (uint i = 0u; i < words[1]; ++i) words[i & 63u] += sums[(i + self) & 63u];\n"
    "}\n";

static EGLDisplay display;
static EGLContext first, second;
static GLuint program;

static double milliseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static EGLContext make_context(EGLContext share) {
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, share, wanted);
}

static void bind_buffers(void) {
  const GLuint words[64] = {0};
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
  glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof(words), words, GL_STATIC_DRAW);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers[1]);
  glBufferData(GL_DISPATCH_INDIRECT_BUFFER, sizeof(words), words, GL_STATIC_DRAW);
}

static void link_pass(void) {
  static unsigned number = 7;
  char source[sizeof(pass) + 16];
  snprintf(source, sizeof(source), pass, ++number);
  const char* const text = source;
  program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
}

// Returns the time of the dispatch alone.
static double prepare(void) {
  const double begin = milliseconds();
  glUseProgram(program);
  glDispatchComputeIndirect(0);
  glFinish();
  return milliseconds() - begin;
}

static double use(void) {
  const double begin = milliseconds();
  glUseProgram(program);
  glDispatchCompute(1, 1, 1);
  glFinish();
  return milliseconds() - begin;
}

static void measure_file(const char* name) {
  static char source[1 << 18];
  FILE* const file = fopen(name, "r");
  if (file == NULL) exit(1);
  source[fread(source, 1, sizeof(source) - 1, file)] = '\0';
  fclose(file);
  const char* const text = source;
  const double begin = milliseconds();
  program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) exit(1);
  prepare();
  printf("%s %.1f\n", name, milliseconds() - begin);
}

static void* compile_in_thread(void* unused) {
  (void)unused;
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, second)) exit(1);
  bind_buffers();
  link_pass();
  prepare();
  use();
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return NULL;
}

int main(int count, char** files) {
  display = open_egl_display();
  if (display == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_API)) return 77;
  first = make_context(EGL_NO_CONTEXT);
  second = make_context(first);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, first)) return 77;
  printf("%s, %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
  bind_buffers();
  link_pass();  // what the driver does once
  use();
  for (int i = 1; i < count; ++i) measure_file(files[i]);
  for (int round = 0; round < 3 && count == 1; ++round) {
    const double begin = milliseconds();
    link_pass();
    const double linked = milliseconds() - begin;
    const double prepared = prepare();
    printf("alone:          link %6.1f  prepare %6.1f  use %6.1f\n", linked, prepared, use());
    pthread_t thread;
    pthread_create(&thread, NULL, compile_in_thread, NULL);
    pthread_join(thread, NULL);
    const double prepared_after = prepare();
    printf("after a thread: link %6.1f  prepare %6.1f  use %6.1f\n", 0.0, prepared_after, use());
  }
  return 0;
}
