// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/native_windows.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"
#include "shim/panel/panel_context.h"

namespace glark::shim {
namespace {

// GL/glx.h
constexpr int glx_fbconfig_id = 0x8013;
constexpr int glx_rgba_type = 0x8014;
constexpr int glx_screen = 0x800C;
constexpr int glx_visual_id = 0x800B;

struct GlxFunctions {
  int (*query_context)(void*, void*, int, int*);
  void** (*configs)(void*, int, int*);
  int (*get_config)(void*, void*, int, int*);
  int (*is_direct)(void*, void*);
  GlxDrawable (*current_read_drawable)();
  int (*free)(void*);

  bool complete() const {
    return query_context != nullptr && configs != nullptr && get_config != nullptr && is_direct != nullptr &&
           current_read_drawable != nullptr && free != nullptr;
  }
};

GlxFunctions find_functions() {
  return {find_function<decltype(GlxFunctions::query_context)>("glXQueryContext"),
          find_function<decltype(GlxFunctions::configs)>("glXGetFBConfigs"),
          find_function<decltype(GlxFunctions::get_config)>("glXGetFBConfigAttrib"),
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

int value_of(const GlxFunctions& glx, void* display, void* config, int name) {
  int value = 0;
  glx.get_config(display, config, name, &value);
  return value;
}

// The configuration of the program's context fits the window for sure. Mesa names none for a context that was made for a
// visual; then it is the one that has this visual.
void* find_config(const GlxFunctions& glx, void* display, void* program) {
  const auto visual = static_cast<int>(glx_visual_of(program));
  const int name = visual != 0 ? glx_visual_id : glx_fbconfig_id;
  int wanted = visual;
  int screen = 0;
  int count = 0;
  if (visual == 0) glx.query_context(display, program, glx_fbconfig_id, &wanted);
  glx.query_context(display, program, glx_screen, &screen);
  void** const configs = glx.configs(display, screen, &count);
  void* found = nullptr;
  for (int i = 0; i < count && found == nullptr; ++i)
    if (value_of(glx, display, configs[i], name) == wanted) found = configs[i];
  if (configs != nullptr) glx.free(configs);
  return found;
}

void* create_like(const GlxFunctions& glx, void* display, void* program) {
  void* const config = find_config(glx, display, program);
  if (config == nullptr) return nullptr;
  return GLARK_REAL(glXCreateNewContext)(display, config, glx_rgba_type, nullptr, glx.is_direct(display, program));
}

}  // namespace

std::unique_ptr<PanelContext> make_glx_panel_context(void* native, const Surface& surface) {
  const GlxFunctions glx = find_functions();
  void* const own = glx.complete() ? create_like(glx, surface.display, native) : nullptr;
  if (own == nullptr) return nullptr;
  return std::make_unique<GlxPanelContext>(glx, native, surface.display, own);
}

}  // namespace glark::shim
