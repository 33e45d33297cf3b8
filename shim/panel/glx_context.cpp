// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"
#include "shim/panel/panel_context.h"

namespace glark::shim {
namespace {

// GL/glx.h
constexpr int glx_fbconfig_id = 0x8013;
constexpr int glx_rgba_type = 0x8014;
constexpr int glx_screen = 0x800C;

struct GlxFunctions {
  int (*query_context)(void*, void*, int, int*);
  void** (*choose_config)(void*, int, const int*, int*);
  int (*is_direct)(void*, void*);
  GlxDrawable (*current_read_drawable)();
  int (*free)(void*);

  bool complete() const {
    return query_context != nullptr && choose_config != nullptr && is_direct != nullptr &&
           current_read_drawable != nullptr && free != nullptr;
  }
};

GlxFunctions find_functions() {
  return {find_function<decltype(GlxFunctions::query_context)>("glXQueryContext"),
          find_function<decltype(GlxFunctions::choose_config)>("glXChooseFBConfig"),
          find_function<decltype(GlxFunctions::is_direct)>("glXIsDirect"),
          find_function<decltype(GlxFunctions::current_read_drawable)>("glXGetCurrentReadDrawable"),
          reinterpret_cast<decltype(GlxFunctions::free)>(symbol_of_loaded("libX11.so", "XFree"))};
}

class GlxPanelContext final : public PanelContext {
 public:
  GlxPanelContext(const GlxFunctions& glx, void* program, void* display, void* own)
      : glx_(glx), program_(program), display_(display), own_(own) {}

  bool enter(const Surface& surface) override {
    draw_ = reinterpret_cast<GlxDrawable>(surface.drawable);
    read_ = glx_.current_read_drawable();
    return GLARK_REAL(glXMakeContextCurrent)(display_, draw_, draw_, own_) != 0;
  }
  void leave() override { GLARK_REAL(glXMakeContextCurrent)(display_, draw_, read_, program_); }

 private:
  GlxFunctions glx_;
  void* program_;
  void* display_;
  void* own_;
  GlxDrawable draw_ = 0;
  GlxDrawable read_ = 0;
};

// The configuration of the program's context fits the window for sure.
void* create_like(const GlxFunctions& glx, void* display, void* program) {
  int id = 0;
  int screen = 0;
  glx.query_context(display, program, glx_fbconfig_id, &id);
  glx.query_context(display, program, glx_screen, &screen);
  const int wanted[] = {glx_fbconfig_id, id, 0};
  int count = 0;
  void** const configs = id != 0 ? glx.choose_config(display, screen, wanted, &count) : nullptr;
  if (configs == nullptr) return nullptr;
  void* own = nullptr;
  if (count > 0)
    own = GLARK_REAL(glXCreateNewContext)(display, configs[0], glx_rgba_type, nullptr, glx.is_direct(display, program));
  glx.free(configs);
  return own;
}

}  // namespace

std::unique_ptr<PanelContext> make_glx_panel_context(void* native, const Surface& surface) {
  const GlxFunctions glx = find_functions();
  void* const own = glx.complete() ? create_like(glx, surface.display, native) : nullptr;
  if (own == nullptr) return nullptr;
  return std::make_unique<GlxPanelContext>(glx, native, surface.display, own);
}

}  // namespace glark::shim
