// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/linker/dynamic_linker.h"
#include "shim/names/real_functions.h"
#include "shim/panel/panel_context.h"

namespace glark::shim {
namespace {

// EGL/egl.h
constexpr EglInt egl_config_id = 0x3028;
constexpr EglInt egl_none = 0x3038;
constexpr EglInt egl_read = 0x305A;
constexpr EglInt egl_client_type = 0x3097;
constexpr EglInt egl_client_version = 0x3098;
constexpr EglInt egl_opengl_es_api = 0x30A0;

struct EglFunctions {
  EglBoolean (*query_context)(void*, void*, EglInt, EglInt*);
  EglBoolean (*query_surface)(void*, void*, EglInt, EglInt*);
  EglBoolean (*choose_config)(void*, const EglInt*, void**, EglInt, EglInt*);
  EglBoolean (*bind_api)(unsigned);
  unsigned (*query_api)();
  void* (*current_surface)(EglInt);

  bool complete() const {
    return query_context != nullptr && query_surface != nullptr && choose_config != nullptr && bind_api != nullptr &&
           query_api != nullptr && current_surface != nullptr;
  }
};

EglFunctions find_functions() {
  return {find_function<decltype(EglFunctions::query_context)>("eglQueryContext"),
          find_function<decltype(EglFunctions::query_surface)>("eglQuerySurface"),
          find_function<decltype(EglFunctions::choose_config)>("eglChooseConfig"),
          find_function<decltype(EglFunctions::bind_api)>("eglBindAPI"),
          find_function<decltype(EglFunctions::query_api)>("eglQueryAPI"),
          find_function<decltype(EglFunctions::current_surface)>("eglGetCurrentSurface")};
}

class EglPanelContext final : public PanelContext {
 public:
  EglPanelContext(const EglFunctions& egl, void* program, void* display, void* own)
      : egl_(egl), program_(program), display_(display), own_(own) {}

  bool enter(const Surface& surface) override {
    draw_ = surface.drawable;
    read_ = egl_.current_surface(egl_read);
    return GLARK_REAL(eglMakeCurrent)(display_, draw_, draw_, own_) != 0;
  }
  void leave() override { GLARK_REAL(eglMakeCurrent)(display_, draw_, read_, program_); }

 private:
  EglFunctions egl_;
  void* program_;
  void* display_;
  void* own_;
  void* draw_ = nullptr;
  void* read_ = nullptr;
};

// The configuration of the program's context, or of its surface if the context has none.
void* find_config(const EglFunctions& egl, void* native, const Surface& surface) {
  EglInt id = 0;
  if (egl.query_context(surface.display, native, egl_config_id, &id) == 0 || id == 0)
    egl.query_surface(surface.display, surface.drawable, egl_config_id, &id);
  const EglInt wanted[] = {egl_config_id, id, egl_none};
  void* config = nullptr;
  EglInt count = 0;
  return egl.choose_config(surface.display, wanted, &config, 1, &count) != 0 && count == 1 ? config : nullptr;
}

void* create_like(const EglFunctions& egl, void* native, const Surface& surface) {
  void* const config = find_config(egl, native, surface);
  EglInt api = 0;
  if (config == nullptr || egl.query_context(surface.display, native, egl_client_type, &api) == 0) return nullptr;
  const unsigned before = egl.query_api();
  egl.bind_api(static_cast<unsigned>(api));
  const EglInt es[] = {egl_client_version, 2, egl_none};
  const EglInt desktop[] = {egl_none};
  void* const own =
      GLARK_REAL(eglCreateContext)(surface.display, config, nullptr, api == egl_opengl_es_api ? es : desktop);
  egl.bind_api(before);
  return own;
}

}  // namespace

std::unique_ptr<PanelContext> make_egl_panel_context(void* native, const Surface& surface) {
  const EglFunctions egl = find_functions();
  void* const own = egl.complete() ? create_like(egl, native, surface) : nullptr;
  if (own == nullptr) return nullptr;
  return std::make_unique<EglPanelContext>(egl, native, surface.display, own);
}

std::unique_ptr<PanelContext> make_panel_context(Provider provider, void* native, const Surface& surface) {
  if (surface.drawable == nullptr) return nullptr;
  if (provider == Provider::glx) return make_glx_panel_context(native, surface);
  return provider == Provider::egl ? make_egl_panel_context(native, surface) : nullptr;
}

}  // namespace glark::shim
