// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/info/info.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "glark/tool/info/attempt.h"

namespace glark::tool {
namespace {

template <class Function>
Function symbol(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

void* open_first(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (void* library = dlopen(name, RTLD_NOW)) return library;
  return nullptr;
}

decltype(&OSMesaGetProcAddress) osmesa_get_proc = nullptr;
decltype(&eglGetProcAddress) egl_get_proc = nullptr;

int try_osmesa(const char* way) {
  void* library = open_first({"libOSMesa.so.8", "libOSMesa.so.6"});
  if (library == nullptr) return no_context;
  const auto create = symbol<decltype(&OSMesaCreateContextExt)>(library, "OSMesaCreateContextExt");
  const auto make_current = symbol<decltype(&OSMesaMakeCurrent)>(library, "OSMesaMakeCurrent");
  osmesa_get_proc = symbol<decltype(osmesa_get_proc)>(library, "OSMesaGetProcAddress");
  if (create == nullptr || make_current == nullptr || osmesa_get_proc == nullptr) return no_context;
  static std::array<unsigned char, 4 * 4 * 4> buffer;
  OSMesaContext context = create(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (context == nullptr || !make_current(context, buffer.data(), GL_UNSIGNED_BYTE, 4, 4)) return no_context;
  return print_context(way, Api::desktop,
                       [](const char* name) { return reinterpret_cast<void*>(osmesa_get_proc(name)); });
}

int try_egl(const char* way, Api api) {
  void* library = open_first({"libEGL.so.1"});
  if (library == nullptr) return no_context;
  egl_get_proc = symbol<decltype(egl_get_proc)>(library, "eglGetProcAddress");
  if (egl_get_proc == nullptr) return no_context;
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl_get_proc("eglGetPlatformDisplayEXT"));
  const auto get_default = symbol<decltype(&eglGetDisplay)>(library, "eglGetDisplay");
  const auto initialize = symbol<decltype(&eglInitialize)>(library, "eglInitialize");
  const auto bind_api = symbol<decltype(&eglBindAPI)>(library, "eglBindAPI");
  const auto create = symbol<decltype(&eglCreateContext)>(library, "eglCreateContext");
  const auto make_current = symbol<decltype(&eglMakeCurrent)>(library, "eglMakeCurrent");
  if (!get_display || !get_default || !initialize || !bind_api || !create || !make_current) return no_context;
  EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) {
    display = get_default(EGL_DEFAULT_DISPLAY);  // drivers that are not Mesa's
    if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) return no_context;
  }
  bind_api(api == Api::es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, api == Api::es ? 3 : 1, EGL_NONE};
  EGLContext context = create(display, nullptr, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT || !make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return no_context;
  return print_context(way, api, [](const char* name) { return reinterpret_cast<void*>(egl_get_proc(name)); });
}

// The child leaves by _exit, because destructors of drivers may crash.
int in_child(const char* way, int (*attempt)(const char* way)) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const int status = attempt(way);
    std::fflush(stdout);
    _exit(status);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0) return no_context;
  if (WIFSIGNALED(status)) std::printf("%s\n  the driver crashed: %s\n", way, strsignal(WTERMSIG(status)));
  const int result = WIFEXITED(status) ? WEXITSTATUS(status) : cannot_refine;
  if (result == no_context) std::printf("%s\n  not available here\n", way);
  return result;
}

}  // namespace

int info() {
  std::printf("glark %s\n\n", GLARK_VERSION);
  const std::array results{
      in_child("GLX", try_glx),
      in_child("OSMesa", try_osmesa),
      in_child("EGL without a surface, OpenGL", [](const char* way) { return try_egl(way, Api::desktop); }),
      in_child("EGL without a surface, OpenGL ES", [](const char* way) { return try_egl(way, Api::es); }),
  };
  for (const int result : results)
    if (result == can_refine) return 0;
  return 1;
}

}  // namespace glark::tool
