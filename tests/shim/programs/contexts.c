// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Contexts of EGL in the ways that programs make, share, move and leave them: one case by name. Prints what a program
// can see: colours, errors, and every message of debug output. Status 3: not here.
#define GL_GLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static EGLDisplay display;

static void open_display(void) {
  display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL)) exit(3);
  eglBindAPI(EGL_OPENGL_API);
}

static EGLContext create(EGLContext share, EGLint name, EGLint value) {
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, name, value, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, share, attributes);
  if (context == EGL_NO_CONTEXT) exit(3);
  return context;
}

static void use(EGLContext context) {
  eglBindAPI(EGL_OPENGL_API);
  printf("current %d\n", eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
}

static GLuint make_program(const char* vertex) {
  static const char* const fragment =
      "#version 330\nuniform vec3 tint;\nout vec4 color;\nvoid main() { color = vec4(tint, 1); }\n";
  const GLuint program = glCreateProgram();
  const GLenum kinds[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  const char* sources[2] = {vertex, fragment};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = glCreateShader(kinds[i]);
    glShaderSource(shader, 1, &sources[i], NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  return program;
}

static const char plain_vertex[] =
    "#version 330\nin vec2 position;\nvoid main() { gl_Position = vec4(position, 0, 1); }\n";

static GLuint make_buffer(void) {
  static const GLfloat positions[] = {-1, -1, 3, -1, -1, 3};
  GLuint buffer;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
  return buffer;
}

// Contexts do not share these.
static void make_target(void) {
  GLuint framebuffer, storage, array;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage);
  glViewport(0, 0, 16, 16);
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
}

static void draw(GLuint program, GLuint buffer, float green) {
  glClear(GL_COLOR_BUFFER_BIT);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
  glUseProgram(program);
  glUniform3f(glGetUniformLocation(program, "tint"), 1, green, 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFlush();
}

static void print_middle(void) {
  unsigned char pixel[4] = {0};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  printf("color %d %d %d, error %x\n", pixel[0], pixel[1], pixel[2], glGetError());
  fflush(stdout);
}

static void draw_all_new(float green) {
  make_target();
  draw(make_program(plain_vertex), make_buffer(), green);
  print_middle();
}

static void robust(void) {
  open_display();
  use(create(NULL, EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE));
  draw_all_new(0.4f);
  GLint strategy = 0;
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
  printf("strategy %x, reset %x\n", strategy, glGetGraphicsResetStatus());
  use(create(NULL, EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET));
  draw_all_new(0.6f);
  printf("reset %x\n", glGetGraphicsResetStatus());
}

static void no_error(void) {
  open_display();
  use(create(NULL, EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE));
  GLint flags = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  printf("flags %x\n", flags);
  draw_all_new(0.4f);
}

static void on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
                       const void* user) {
  (void)length;
  printf("%s: %x %x %u %x %s\n", (const char*)user, source, type, id, severity, text);
}

static void print_log(void) {
  GLchar text[512];
  GLenum source, type, severity;
  GLuint id;
  while (glGetDebugMessageLog(1, sizeof text, &source, &type, &id, &severity, NULL, text) == 1)
    printf("log: %x %x %u %x %s\n", source, type, id, severity, text);
}

static void draw_and_err(void) {
  const GLuint program = make_program(plain_vertex);
  const GLuint buffer = make_buffer();
  glObjectLabel(GL_PROGRAM, program, -1, "a label");
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 7, -1, "a group");
  draw(program, buffer, 0.4f);
  glUniform1f(glGetUniformLocation(program, "tint"), 1);  // a vec3
  glDrawArrays(GL_TRIANGLES, 0, -1);
  draw(program, buffer, 0.6f);
  glPopDebugGroup();
  glLinkProgram(program);
  draw(program, buffer, 0.4f);
  // It does not link: a message, and no other.
  make_program("#version 330\nvoid main() { nonsense }\n");
  GLchar label[32] = "";
  glGetObjectLabel(GL_PROGRAM, program, sizeof label, NULL, label);
  printf("label %s, error %x\n", label, glGetError());
  glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
  glDrawArrays(GL_TRIANGLES, 0, 3);  // mapped: refused, once
  glUnmapBuffer(GL_ARRAY_BUFFER);
  printf("error %x\n", glGetError());
}

static void debug(void) {
  open_display();
  use(create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE));
  make_target();
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, NULL, GL_TRUE);
  glDebugMessageCallback(on_message, "callback");
  draw_and_err();
  glDebugMessageCallback(NULL, NULL);
  draw_and_err();
  print_log();
  printf("enabled %d\n", glIsEnabled(GL_DEBUG_OUTPUT));
  glDisable(GL_DEBUG_OUTPUT);
  draw_and_err();
  print_log();
  printf("enabled %d\n", glIsEnabled(GL_DEBUG_OUTPUT));
  print_middle();
}

// The context that drew first is destroyed while current. The other one draws with the shared objects.
static void share(void) {
  open_display();
  const EGLContext first = create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE);
  const EGLContext second = create(first, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE);
  use(first);
  make_target();
  const GLuint program = make_program(plain_vertex);
  const GLuint buffer = make_buffer();
  draw(program, buffer, 0.4f);
  print_middle();
  printf("destroyed %d\n", eglDestroyContext(display, first));
  use(second);
  make_target();
  draw(program, buffer, 0.6f);
  print_middle();
  draw(program, buffer, 0.8f);
  print_middle();
}

// A uniform is set by one context after the other has derived a program.
static void uniform(void) {
  open_display();
  const EGLContext first = create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE);
  const EGLContext second = create(first, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE);
  use(first);
  make_target();
  const GLuint program = make_program(plain_vertex);
  const GLuint buffer = make_buffer();
  glUseProgram(program);
  glFinish();
  use(second);
  make_target();
  draw(program, buffer, 0.4f);
  print_middle();
  use(first);
  glUniform3f(glGetUniformLocation(program, "tint"), 0, 0, 1);
  glFinish();
  use(second);
  draw(make_program(plain_vertex), buffer, 0.2f);  // Mesa looks at the uniforms again only after another program
  glClear(GL_COLOR_BUFFER_BIT);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  print_middle();
}

static EGLContext moved;
static void* draw_moved(void* unused) {
  (void)unused;
  use(moved);
  draw_all_new(0.6f);
  return NULL;  // eglReleaseThread was not called
}

static void move(void) {
  open_display();
  moved = create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE);
  use(moved);
  draw_all_new(0.4f);
  eglReleaseThread();
  pthread_t thread;
  pthread_create(&thread, NULL, draw_moved, NULL);
  pthread_join(thread, NULL);
}

static void terminate(void) {
  for (int i = 0; i < 3; ++i) {
    open_display();
    use(create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE));
    draw_all_new(0.2f * i);
    if (i == 1) eglReleaseThread();
    printf("terminated %d\n", eglTerminate(display));
    if (i == 2) print_middle();  // still current
    if (i != 1) printf("released %d\n", eglReleaseThread());
  }
}

static void wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  printf("child %d %d\n", WIFEXITED(status), WEXITSTATUS(status));
}

// The child of a fork before any GL draws by itself; one of a fork after it leaves, or becomes another program that
// draws.
static void process(char* self) {
  fflush(stdout);
  pid_t child = fork();
  if (child == 0) {
    open_display();
    use(create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE));
    draw_all_new(0.4f);
    exit(5);
  }
  wait_for(child);
  open_display();
  use(create(NULL, EGL_CONTEXT_OPENGL_DEBUG, EGL_FALSE));
  draw_all_new(0.6f);
  if ((child = fork()) == 0) _exit(6);
  wait_for(child);
  fflush(stdout);
  if ((child = fork()) == 0) execl("/bin/sh", "sh", "-c", "exec \"$0\" no_error", self, (char*)NULL);
  wait_for(child);
  draw_all_new(0.8f);
}

int main(int argc, char** argv) {
  static const struct {
    const char* name;
    void (*run)(void);
  } cases[] = {{"robust", robust}, {"no_error", no_error}, {"debug", debug},        {"share", share},
               {"move", move},     {"uniform", uniform},   {"terminate", terminate}};
  const char* name = argc == 2 ? argv[1] : "";
  if (strcmp(name, "process") == 0) return process(argv[0]), 0;
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
    if (strcmp(cases[i].name, name) == 0) return cases[i].run(), 0;
  fprintf(stderr, "usage: contexts CASE\n");
  return 2;
}
