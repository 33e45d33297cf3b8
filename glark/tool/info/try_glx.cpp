// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GLX needs an X server, which many machines lack. So libX11 and libGL are opened here, and not linked.
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

#include "glark/tool/info/attempt.h"

namespace glark::tool {
namespace {

struct Functions {
  decltype(&XOpenDisplay) open_display = nullptr;
  decltype(&glXChooseFBConfig) choose_config = nullptr;
  decltype(&glXCreateNewContext) create_context = nullptr;
  decltype(&glXCreatePbuffer) create_pbuffer = nullptr;
  decltype(&glXMakeContextCurrent) make_current = nullptr;
};

decltype(&glXGetProcAddressARB) get_proc = nullptr;

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = library == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

bool find_functions(Functions& f) {
  void* x11 = dlopen("libX11.so.6", RTLD_NOW);
  void* gl = dlopen("libGL.so.1", RTLD_NOW);
  return find(x11, "XOpenDisplay", f.open_display) && find(gl, "glXChooseFBConfig", f.choose_config) &&
         find(gl, "glXCreateNewContext", f.create_context) && find(gl, "glXCreatePbuffer", f.create_pbuffer) &&
         find(gl, "glXMakeContextCurrent", f.make_current) && find(gl, "glXGetProcAddressARB", get_proc);
}

int absent(const char* way, const char* why) {
  std::printf("%s\n  not available here: %s\n", way, why);
  return cannot_refine;
}

}  // namespace

int try_glx(const char* way) {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') return absent(way, "DISPLAY is not set, so there is no X server");
  Functions f;
  if (!find_functions(f)) return absent(way, "libX11.so.6 or libGL.so.1 is not installed");
  Display* display = f.open_display(nullptr);
  if (display == nullptr) return absent(way, "the X server that DISPLAY names does not answer");
  const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT, None};
  int count = 0;
  GLXFBConfig* configs = f.choose_config(display, DefaultScreen(display), wanted, &count);
  if (configs == nullptr || count == 0) return absent(way, "the X server offers no GLX with RGBA colours");
  const int size[] = {GLX_PBUFFER_WIDTH, 4, GLX_PBUFFER_HEIGHT, 4, None};
  GLXContext context = f.create_context(display, configs[0], GLX_RGBA_TYPE, nullptr, True);
  const GLXPbuffer surface = f.create_pbuffer(display, configs[0], size);
  if (context == nullptr || !f.make_current(display, surface, surface, context))
    return absent(way, "the X server refuses a context");
  return print_context(way, Api::desktop, [](const char* function) {
    return reinterpret_cast<void*>(get_proc(reinterpret_cast<const GLubyte*>(function)));
  });
}

}  // namespace glark::tool
