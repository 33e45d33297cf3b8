// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/contexts.h"
#include "shim/contexts/native_windows.h"
#include "shim/contexts/thread.h"
#include "shim/frames/frame.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"

using namespace glark::shim;

namespace {

// OpenVG contexts are EGL contexts too.
bool is_gl(void* display, void* context) {
  constexpr EglInt egl_context_client_type = 0x3097;
  constexpr EglInt egl_openvg_api = 0x30A1;
  const auto query = find_function<EglBoolean (*)(void*, void*, EglInt, EglInt*)>("eglQueryContext");
  EglInt type = 0;
  if (context == nullptr || query == nullptr) return true;
  query(display, context, egl_context_client_type, &type);
  return type != egl_openvg_api;
}

void* opened(unsigned platform, void* native, void* display) {
  note_egl_display(platform, native, display);
  return display;
}

void* made(void* display, void* native, bool indirect, void* surface) {
  note_egl_window(display, native, indirect, surface);
  return surface;
}

void end_frame_of(void* surface) {
  if (current_native() != nullptr && current_surface().drawable == surface) frame_ended();
}

}  // namespace

GLARK_EXPORT EglProc eglGetProcAddress(const char* name) {
  return reinterpret_cast<EglProc>(wrapper_or(name, reinterpret_cast<void*>(GLARK_REAL(eglGetProcAddress)(name))));
}

GLARK_EXPORT void* eglGetDisplay(void* native) { return opened(0, native, GLARK_REAL(eglGetDisplay)(native)); }

GLARK_EXPORT void* eglGetPlatformDisplay(unsigned platform, void* native, const std::intptr_t* attributes) {
  return opened(platform, native, GLARK_REAL(eglGetPlatformDisplay)(platform, native, attributes));
}

GLARK_EXPORT void* eglGetPlatformDisplayEXT(unsigned platform, void* native, const EglInt* attributes) {
  return opened(platform, native, GLARK_REAL(eglGetPlatformDisplayEXT)(platform, native, attributes));
}

GLARK_EXPORT void* eglCreateWindowSurface(void* display, void* config, void* native, const EglInt* attributes) {
  return made(display, native, false, GLARK_REAL(eglCreateWindowSurface)(display, config, native, attributes));
}

GLARK_EXPORT void* eglCreatePlatformWindowSurface(void* display, void* config, void* native,
                                                  const std::intptr_t* attributes) {
  return made(display, native, true, GLARK_REAL(eglCreatePlatformWindowSurface)(display, config, native, attributes));
}

GLARK_EXPORT void* eglCreatePlatformWindowSurfaceEXT(void* display, void* config, void* native,
                                                     const EglInt* attributes) {
  return made(display, native, true,
              GLARK_REAL(eglCreatePlatformWindowSurfaceEXT)(display, config, native, attributes));
}

GLARK_EXPORT void* eglCreateContext(void* display, void* config, void* share, const EglInt* attributes) {
  void* context = GLARK_REAL(eglCreateContext)(display, config, share, attributes);
  context_created(Provider::egl, context, share);
  return context;
}

GLARK_EXPORT EglBoolean eglDestroyContext(void* display, void* context) {
  context_destroyed(Provider::egl, context);  // first, because another thread may get its address
  return GLARK_REAL(eglDestroyContext)(display, context);
}

GLARK_EXPORT EglBoolean eglMakeCurrent(void* display, void* draw, void* read, void* context) {
  make_current_begins(Provider::egl, context);
  const EglBoolean succeeded = GLARK_REAL(eglMakeCurrent)(display, draw, read, context);
  if (succeeded && (context == current_native() || is_gl(display, context)))
    make_current_done(Provider::egl, context, {display, draw});
  return succeeded;
}

GLARK_EXPORT EglBoolean eglReleaseThread() {
  make_current_begins(Provider::egl, nullptr);
  const EglBoolean succeeded = GLARK_REAL(eglReleaseThread)();
  if (succeeded) make_current_done(Provider::egl, nullptr, {});
  return succeeded;
}

GLARK_EXPORT EglBoolean eglSwapBuffers(void* display, void* surface) {
  end_frame_of(surface);
  return GLARK_REAL(eglSwapBuffers)(display, surface);
}

GLARK_EXPORT EglBoolean eglSwapBuffersWithDamageKHR(void* display, void* surface, const EglInt* rectangles,
                                                    EglInt count) {
  end_frame_of(surface);
  return GLARK_REAL(eglSwapBuffersWithDamageKHR)(display, surface, rectangles, count);
}

GLARK_EXPORT EglBoolean eglSwapBuffersWithDamageEXT(void* display, void* surface, const EglInt* rectangles,
                                                    EglInt count) {
  end_frame_of(surface);
  return GLARK_REAL(eglSwapBuffersWithDamageEXT)(display, surface, rectangles, count);
}
