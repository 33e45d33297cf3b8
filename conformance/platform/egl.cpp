// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <stdexcept>

#include "conformance/platform/library.h"
#include "conformance/platform/platform.h"

namespace glark::conformance {
namespace {

struct Egl {
  Library library{"libEGL.so.1"};
  decltype(&eglGetProcAddress) address = nullptr;
  decltype(&eglQueryString) query = nullptr;
  decltype(&eglGetDisplay) get_display = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglChooseConfig) choose = nullptr;
  decltype(&eglCreatePbufferSurface) create_pbuffer = nullptr;
  decltype(&eglCreateContext) create = nullptr;
  decltype(&eglDestroyContext) destroy = nullptr;
  decltype(&eglDestroySurface) destroy_surface = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglSwapBuffers) swap = nullptr;
  EGLDisplay display = EGL_NO_DISPLAY;

  Egl() {
    library.get(address, "eglGetProcAddress");
    library.get(query, "eglQueryString");
    library.get(get_display, "eglGetDisplay");
    library.get(initialize, "eglInitialize");
    library.get(bind_api, "eglBindAPI");
    library.get(choose, "eglChooseConfig");
    library.get(create_pbuffer, "eglCreatePbufferSurface");
    library.get(create, "eglCreateContext");
    library.get(destroy, "eglDestroyContext");
    library.get(destroy_surface, "eglDestroySurface");
    library.get(make_current, "eglMakeCurrent");
    library.get(swap, "eglSwapBuffers");
    open_display();
  }

 private:
  // Prefers a display without a window system, which needs no X server.
  void open_display() {
    const char* extensions = query(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions != nullptr && std::strstr(extensions, "EGL_MESA_platform_surfaceless") != nullptr) {
      const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(address("eglGetPlatformDisplayEXT"));
      if (get != nullptr) display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (display != EGL_NO_DISPLAY && initialize(display, nullptr, nullptr) == EGL_TRUE) return;
    display = get_display(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || initialize(display, nullptr, nullptr) != EGL_TRUE)
      throw std::runtime_error("EGL has neither a surfaceless nor a default display");
  }
};

class EglContext : public Context {
 public:
  EglContext(const Egl& egl, EGLContext context, EGLSurface surface, EGLenum api)
      : egl_(egl), context_(context), surface_(surface), api_(api) {}
  ~EglContext() override {
    release_current();
    egl_.destroy_surface(egl_.display, surface_);
    egl_.destroy(egl_.display, context_);
  }

  bool make_current() override {
    return egl_.bind_api(api_) == EGL_TRUE && egl_.make_current(egl_.display, surface_, surface_, context_) == EGL_TRUE;
  }
  void release_current() override {
    egl_.bind_api(api_);
    egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  void end_frame() override {
    reinterpret_cast<void (*)()>(egl_.address("glFinish"))();
    egl_.swap(egl_.display, surface_);
  }
  EGLContext handle() const { return context_; }

 private:
  const Egl& egl_;
  EGLContext context_;
  EGLSurface surface_;
  EGLenum api_;
};

class EglPlatform : public Platform {
 public:
  void* function(const char* name) override { return reinterpret_cast<void*>(egl_.address(name)); }

  std::unique_ptr<Context> create_context(Api api, Context* share) override {
    const EGLenum client = api == Api::gles ? EGL_OPENGL_ES_API : EGL_OPENGL_API;
    if (egl_.bind_api(client) != EGL_TRUE)
      throw std::runtime_error("EGL has no such API: " + std::string(name_of(api)));
    const EGLConfig config = choose(api);
    const EGLint size[] = {EGL_WIDTH, surface_size, EGL_HEIGHT, surface_size, EGL_NONE};
    const EGLSurface surface = egl_.create_pbuffer(egl_.display, config, size);
    if (surface == EGL_NO_SURFACE) throw std::runtime_error("EGL gives no pbuffer");
    const EGLContext handle = create(api, config, share);
    if (handle == EGL_NO_CONTEXT) {
      egl_.destroy_surface(egl_.display, surface);
      throw std::runtime_error("EGL gives no context of " +
                               std::string(api == Api::gles ? "OpenGL ES 3.2" : "OpenGL 4.3, ") +
                               (api == Api::gles ? "" : std::string(name_of(api))));
    }
    auto context = std::make_unique<EglContext>(egl_, handle, surface, client);
    if (!context->make_current()) throw std::runtime_error("EGL does not make its context current");
    return context;
  }

 private:
  EGLConfig choose(Api api) const {
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             api == Api::gles ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             8,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.choose(egl_.display, wanted, &config, 1, &count) != EGL_TRUE || count == 0)
      throw std::runtime_error("EGL has no configuration with pbuffers, RGBA8, depth 24 and stencil 8");
    return config;
  }

  EGLContext create(Api api, EGLConfig config, Context* share) const {
    const EGLint profile =
        api == Api::gl_core ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
    const EGLint of_gl[] = {
        EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK, profile, EGL_NONE};
    const EGLint of_es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
    const EGLContext shared = share != nullptr ? static_cast<EglContext*>(share)->handle() : EGL_NO_CONTEXT;
    return egl_.create(egl_.display, config, shared, api == Api::gles ? of_es : of_gl);
  }

  Egl egl_;
};

}  // namespace

std::unique_ptr<Platform> open_egl() { return std::make_unique<EglPlatform>(); }

}  // namespace glark::conformance
