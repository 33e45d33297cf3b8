// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/adopt.h"

#include "shim/contexts/contexts.h"
#include "shim/contexts/thread.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"

namespace glark::shim {
namespace {

bool adopt_glx() {
  const auto get_context = find_function<void* (*)()>("glXGetCurrentContext");
  const auto get_display = find_function<void* (*)()>("glXGetCurrentDisplay");
  const auto get_drawable = find_function<GlxDrawable (*)()>("glXGetCurrentDrawable");
  if (get_context == nullptr || get_display == nullptr || get_drawable == nullptr) return false;
  void* context = get_context();
  if (context != nullptr)
    make_current_done(Provider::glx, context, {get_display(), reinterpret_cast<void*>(get_drawable())});
  return context != nullptr;
}

bool adopt_egl() {
  constexpr EglInt egl_draw = 0x3059;
  const auto get_context = find_function<void* (*)()>("eglGetCurrentContext");
  const auto get_display = find_function<void* (*)()>("eglGetCurrentDisplay");
  const auto get_surface = find_function<void* (*)(EglInt)>("eglGetCurrentSurface");
  if (get_context == nullptr || get_display == nullptr || get_surface == nullptr) return false;
  void* context = get_context();
  if (context != nullptr) make_current_done(Provider::egl, context, {get_display(), get_surface(egl_draw)});
  return context != nullptr;
}

bool adopt_osmesa() {
  const auto get_context = find_function<void* (*)()>("OSMesaGetCurrentContext");
  const auto get_colors = find_function<GLboolean (*)(void*, GLint*, GLint*, GLint*, void**)>("OSMesaGetColorBuffer");
  if (get_context == nullptr) return false;
  void* context = get_context();
  if (context == nullptr) return false;
  Surface surface;
  GLint format = 0;
  void* buffer = nullptr;
  if (get_colors != nullptr) get_colors(context, &surface.width, &surface.height, &format, &buffer);
  make_current_done(Provider::osmesa, context, surface);
  return true;
}

}  // namespace

bool adopt_current_context() {
  Thread& t = thread();
  if (t.gl != &first_call) return t.context != nullptr;
  t.gl = &dispatch_without_context();
  static_cast<void>(adopt_glx() || adopt_egl() || adopt_osmesa());
  return t.context != nullptr;
}

}  // namespace glark::shim
