// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/info.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "glark/settings/table.h"

namespace glark::tool {
namespace {

using GetProc = void* (*)(const char* name);

enum class Api { desktop, es };

// Exit statuses of a child; any other status is a crash.
constexpr int can_refine = 0;
constexpr int cannot_refine = 1;
constexpr int no_context = 2;

struct Limit {
  const char* name;
  GLenum value;
  GLint needed;  // 0: the minimum of OpenGL 4.3 and OpenGL ES 3.2 is enough
};
constexpr std::array limits{
    Limit{"GL_MAX_VERTEX_ATTRIBS", GL_MAX_VERTEX_ATTRIBS, 16},
    Limit{"GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS", GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS, 64},
    Limit{"GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS", GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 4},
    Limit{"GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, 128},
    Limit{"GL_MAX_SHADER_STORAGE_BLOCK_SIZE", GL_MAX_SHADER_STORAGE_BLOCK_SIZE, 0},
};

class Report {
 public:
  Report(const char* way, Api api, GetProc get_proc) : way_(way), api_(api) {
    get_string_ = reinterpret_cast<decltype(get_string_)>(get_proc("glGetString"));
    get_integer_ = reinterpret_cast<decltype(get_integer_)>(get_proc("glGetIntegerv"));
  }

  int print() const {
    if (get_string_ == nullptr || get_integer_ == nullptr || get_string_(GL_VERSION) == nullptr) return no_context;
    std::printf("%s\n  vendor     %s\n  renderer   %s\n  version    %s\n", way_, text(GL_VENDOR), text(GL_RENDERER),
                text(GL_VERSION));
    std::vector<std::string> lacks = missing();
    if (lacks.empty()) {
      std::printf("  refinement yes: GL_ARK_adaptive_refinement\n");
    } else {
      std::printf("  refinement no; it lacks");
      for (std::size_t i = 0; i < lacks.size(); ++i) std::printf("%s %s", i == 0 ? "" : ",", lacks[i].c_str());
      std::printf("\n");
    }
    for (const Limit& limit : limits) std::printf("  %s = %d\n", limit.name, integer(limit.value));
    if (lacks.empty()) print_offer();
    return lacks.empty() ? can_refine : cannot_refine;
  }

 private:
  const char* text(GLenum name) const {
    const auto* found = get_string_(name);
    return found == nullptr ? "(unknown)" : reinterpret_cast<const char*>(found);
  }

  GLint integer(GLenum name) const {
    GLint value = 0;
    get_integer_(name, &value);
    return value;
  }

  std::vector<std::string> missing() const {
    const int version = integer(GL_MAJOR_VERSION) * 10 + integer(GL_MINOR_VERSION);
    const int needed = api_ == Api::es ? 32 : 43;
    if (version < needed) return {api_ == Api::es ? "OpenGL ES 3.2" : "OpenGL 4.3"};
    std::vector<std::string> lacks;
    for (const Limit& limit : limits)
      if (integer(limit.value) < limit.needed)
        lacks.push_back(std::string(limit.name) + " of " + std::to_string(limit.needed));
    return lacks;
  }

  // Prints what a program can use here.
  void print_offer() const {
    std::printf("  levels     0 to 11 (2048 segments an edge)\n");
    const std::string refinements(settings::find_setting("refine")->needed);
    std::printf("  refinement of unmodified programs: %s\n", refinements.c_str());
    std::printf(
        "  commands   glARKinit glDepthTag1i glDepthTagPointerARK glDrawARP glDrawARPElementsARK\n"
        "             glARKParameteriARK glARKParameterfARK glRefinementShaderSourceARK glGetRefinementivARK "
        "glGetRefinementInfoLogARK\n");
  }

  const char* way_;
  Api api_;
  const GLubyte* (*get_string_)(GLenum) = nullptr;
  void (*get_integer_)(GLenum, GLint*) = nullptr;
};

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
  return Report(way, Api::desktop, [](const char* name) { return reinterpret_cast<void*>(osmesa_get_proc(name)); })
      .print();
}

int try_egl(const char* way, Api api) {
  void* library = open_first({"libEGL.so.1"});
  if (library == nullptr) return no_context;
  egl_get_proc = symbol<decltype(egl_get_proc)>(library, "eglGetProcAddress");
  if (egl_get_proc == nullptr) return no_context;
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl_get_proc("eglGetPlatformDisplayEXT"));
  const auto initialize = symbol<decltype(&eglInitialize)>(library, "eglInitialize");
  const auto bind_api = symbol<decltype(&eglBindAPI)>(library, "eglBindAPI");
  const auto create = symbol<decltype(&eglCreateContext)>(library, "eglCreateContext");
  const auto make_current = symbol<decltype(&eglMakeCurrent)>(library, "eglMakeCurrent");
  if (!get_display || !initialize || !bind_api || !create || !make_current) return no_context;
  EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) return no_context;
  bind_api(api == Api::es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, api == Api::es ? 3 : 1, EGL_NONE};
  EGLContext context = create(display, nullptr, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT || !make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return no_context;
  return Report(way, api, [](const char* name) { return reinterpret_cast<void*>(egl_get_proc(name)); }).print();
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
      in_child("OSMesa", try_osmesa),
      in_child("EGL without a surface, OpenGL", [](const char* way) { return try_egl(way, Api::desktop); }),
      in_child("EGL without a surface, OpenGL ES", [](const char* way) { return try_egl(way, Api::es); }),
  };
  for (const int result : results)
    if (result == can_refine) return 0;
  return 1;
}

}  // namespace glark::tool
