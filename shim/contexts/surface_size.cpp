// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/surface_size.h"

#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"

namespace glark::shim {
namespace {

Size size_of_glx(const Surface& surface) {
  constexpr int glx_width = 0x801D;
  constexpr int glx_height = 0x801E;
  const auto query = find_function<void (*)(void*, GlxDrawable, int, unsigned*)>("glXQueryDrawable");
  unsigned width = 0;
  unsigned height = 0;
  if (query == nullptr) return {};
  query(surface.display, reinterpret_cast<GlxDrawable>(surface.drawable), glx_width, &width);
  query(surface.display, reinterpret_cast<GlxDrawable>(surface.drawable), glx_height, &height);
  return {static_cast<int>(width), static_cast<int>(height)};
}

Size size_of_egl(const Surface& surface) {
  constexpr EglInt egl_height = 0x3056;
  constexpr EglInt egl_width = 0x3057;
  const auto query = find_function<EglBoolean (*)(void*, void*, EglInt, EglInt*)>("eglQuerySurface");
  EglInt width = 0;
  EglInt height = 0;
  if (query == nullptr) return {};
  query(surface.display, surface.drawable, egl_width, &width);
  query(surface.display, surface.drawable, egl_height, &height);
  return {width, height};
}

}  // namespace

Size surface_size(Provider provider, const Surface& surface, const gl::Dispatch& gl) {
  if (provider == Provider::osmesa) return {surface.width, surface.height};
  if (surface.drawable != nullptr) return provider == Provider::glx ? size_of_glx(surface) : size_of_egl(surface);
  GLint viewport[4] = {};
  gl.GetIntegerv(GL_VIEWPORT, viewport);
  return {viewport[0] + viewport[2], viewport[1] + viewport[3]};
}

}  // namespace glark::shim
