// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Six threads draw at once. Each has its own contexts and draws into a tile of the picture. The contexts of even
// threads share with a first context. Threads exchange shared programs and buffers: several threads draw with them, and
// other threads than their makers delete them.
// Contexts end in every way: destroyed while current or not, destroyed by another thread while current, or never
// destroyed.
// Built twice: with WITH_OSMESA for OSMesa; without it for EGL without a surface.
#define GL_GLEXT_PROTOTYPES 1
#include <pthread.h>
#if WITH_OSMESA
#include <GL/osmesa.h>
#else
#include <GL/gl.h>

#include "tests/clients/scene/egl_display.h"
#endif
#include <GL/glext.h>

#include <string.h>

#include "tests/clients/scene/picture.h"
#include "tests/clients/scene/sphere.h"

enum { thread_count = 6, tile_size = 64, tiles_across = picture_size / tile_size };

static const char vertex_source[] =
    "#version 150\n"
    "in vec3 position;\n"
    "uniform vec3 base;\n"
    "out vec3 shade;\n"
    "void main() {\n"
    "  shade = base * (0.2 + 0.8 * max(dot(position, vec3(0.37, 0.56, 0.74)), 0.0));\n"
    "  gl_Position = vec4(0.9 * position, 1.0);\n"
    "}\n";
static const char fragment_source[] =
    "#version 150\n"
    "in vec3 shade;\n"
    "out vec4 color;\n"
    "void main() { color = vec4(shade, 1.0); }\n";

typedef void* Context;

#if WITH_OSMESA
static _Thread_local unsigned char window[4 * 16 * 16];
static void start(void) {}
static Context create(Context share) { return OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, share); }
static void make_current(Context context) {
  require(OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, 16, 16), "OSMesaMakeCurrent failed");
}
static void release_current(void) { OSMesaMakeCurrent(NULL, NULL, 0, 0, 0); }
static void destroy(Context context) { OSMesaDestroyContext(context); }
#else
static EGLDisplay display;
static void start(void) {
  display = open_egl_display();
  require(display != EGL_NO_DISPLAY && eglBindAPI(EGL_OPENGL_API), "no EGL display");
}
static Context create(Context share) {
  static const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  eglBindAPI(EGL_OPENGL_API);  // each thread has its own binding
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, share, attributes);
}
static void make_current(Context context) {
  eglBindAPI(EGL_OPENGL_API);
  require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context), "eglMakeCurrent failed");
}
static void release_current(void) { eglReleaseThread(); }
static void destroy(Context context) { eglDestroyContext(display, context); }
#endif

static GLuint make_program(void) {
  const GLuint program = glCreateProgram();
  const GLenum kinds[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  const char* sources[2] = {vertex_source, fragment_source};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = glCreateShader(kinds[i]);
    glShaderSource(shader, 1, &sources[i], NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glBindAttribLocation(program, 0, "position");
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  require(linked, "a program did not link");
  glUseProgram(program);
  glUniform3f(glGetUniformLocation(program, "base"), 0.9f, 0.6f, 0.2f);
  glUseProgram(0);
  return program;
}

static void make_buffers(GLuint buffers[2]) {
  static const GLsizeiptr position_bytes = 3 * sphere_corners * sizeof(GLfloat);
  GLfloat positions[3 * sphere_corners];
  GLushort indices[sphere_indices];
  make_sphere(positions, indices);
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, position_bytes, positions, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void make_tile(void) {
  GLuint framebuffer;
  GLuint storage[2];
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(2, storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[0]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, tile_size, tile_size);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, tile_size, tile_size);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);
  GLuint array;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glViewport(0, 0, tile_size, tile_size);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void draw(GLuint program, const GLuint buffers[2]) {
  glUseProgram(program);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawElements(GL_TRIANGLES, sphere_indices, GL_UNSIGNED_SHORT, NULL);
  glUseProgram(0);
}

// The objects that the first context made for all contexts that share with it.
static Context first;
static GLuint common_program, common_buffers[2];
static int frames;
static unsigned char picture[4 * picture_size * picture_size];

// A program that one thread of the share group finishes. Another thread takes it over, draws with it, and deletes it.
static pthread_mutex_t exchange_mutex = PTHREAD_MUTEX_INITIALIZER;
static GLuint exchange_program;

static GLuint exchange(GLuint program) {
  pthread_mutex_lock(&exchange_mutex);
  const GLuint other = exchange_program;
  exchange_program = program;
  pthread_mutex_unlock(&exchange_mutex);
  return other;
}

static void draw_frames(int shared) {
  make_tile();
  for (int frame = 0; frame < frames; ++frame) {
    const GLuint program = make_program();
    GLuint buffers[2];
    make_buffers(buffers);
    draw(program, buffers);
    draw(program, buffers);
    glFinish();
    GLuint foreign = program;
    if (shared) {
      draw(common_program, common_buffers);
      glFinish();
      foreign = exchange(program);
      if (foreign != 0) draw(foreign, common_buffers);
    }
    glFinish();
    if (foreign != 0) glDeleteProgram(foreign);
    glDeleteBuffers(2, buffers);
  }
}

static void read_tile(int index) {
  unsigned char tile[4 * tile_size * tile_size];
  glReadPixels(0, 0, tile_size, tile_size, GL_RGBA, GL_UNSIGNED_BYTE, tile);
  require(glGetError() == GL_NO_ERROR, "a thread raised a GL error");
  unsigned char* corner =
      picture + 4 * (index / tiles_across * tile_size * picture_size + index % tiles_across * tile_size);
  for (int y = 0; y < tile_size; ++y) memcpy(corner + 4 * y * picture_size, tile + 4 * y * tile_size, 4 * tile_size);
}

struct Thread {
  int index;
  pthread_t thread;
  pthread_barrier_t drawn, destroyed;  // for the contexts that the main thread destroys while they are current
  Context context;
};

static int destroyed_by_main(int index) { return index >= 4 && !WITH_OSMESA; }

static void* run(void* argument) {
  struct Thread* self = argument;
  const int shared = self->index % 2 == 0;
  self->context = create(shared ? first : NULL);
  make_current(self->context);
  draw_frames(shared);
  if (destroyed_by_main(self->index)) {
    pthread_barrier_wait(&self->drawn);
    pthread_barrier_wait(&self->destroyed);
    glFinish();  // the context is current, so it still exists
  }
  read_tile(self->index);
  switch (self->index) {
    case 0:
      release_current();
      destroy(self->context);
      break;
    case 1:
      destroy(self->context);
      release_current();
      break;
    case 2: release_current(); break;  // the context is never destroyed
    case 3: break;                     // the context is never released: the thread ends with it
    default: release_current();
  }
  return NULL;
}

int main(int argc, char** argv) {
  static struct Thread threads[thread_count];
  frames = frame_count(argc, argv);
  start();
  first = create(NULL);
  require(first != NULL, "no context");
  make_current(first);
  common_program = make_program();
  make_buffers(common_buffers);
  glFinish();
  for (int i = 0; i < thread_count; ++i) {
    threads[i].index = i;
    pthread_barrier_init(&threads[i].drawn, NULL, 2);
    pthread_barrier_init(&threads[i].destroyed, NULL, 2);
    require(pthread_create(&threads[i].thread, NULL, run, &threads[i]) == 0, "no thread");
  }
  for (int i = 0; i < thread_count; ++i) {
    if (!destroyed_by_main(i)) continue;
    pthread_barrier_wait(&threads[i].drawn);
    destroy(threads[i].context);
    pthread_barrier_wait(&threads[i].destroyed);
  }
  for (int i = 0; i < thread_count; ++i) pthread_join(threads[i].thread, NULL);
  make_tile();
  draw(common_program, common_buffers);
  read_tile(thread_count);
  return write_picture(argv[2], picture);  // `first` is current at exit, and never destroyed
}
