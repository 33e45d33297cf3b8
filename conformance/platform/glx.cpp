// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <GL/glx.h>
// After GL/glx.h, for it names types of that.
#include <GL/glxext.h>

#include <stdexcept>

#include "conformance/platform/library.h"
#include "conformance/platform/platform.h"

namespace glark::conformance {
namespace {

struct Glx {
  Library x11{"libX11.so.6"};
  Library library{"libGL.so.1"};
  decltype(&XOpenDisplay) open = nullptr;
  decltype(&XSetErrorHandler) set_error_handler = nullptr;
  decltype(&XSync) sync = nullptr;
  decltype(&XFree) free = nullptr;
  decltype(&glXGetProcAddressARB) address = nullptr;
  decltype(&glXChooseFBConfig) choose = nullptr;
  decltype(&glXCreatePbuffer) create_pbuffer = nullptr;
  decltype(&glXDestroyPbuffer) destroy_pbuffer = nullptr;
  decltype(&glXMakeContextCurrent) make_current = nullptr;
  decltype(&glXDestroyContext) destroy = nullptr;
  decltype(&glXSwapBuffers) swap = nullptr;
  PFNGLXCREATECONTEXTATTRIBSARBPROC create = nullptr;
  Display* display = nullptr;

  Glx() {
    x11.get(open, "XOpenDisplay");
    x11.get(set_error_handler, "XSetErrorHandler");
    x11.get(sync, "XSync");
    x11.get(free, "XFree");
    library.get(address, "glXGetProcAddressARB");
    library.get(choose, "glXChooseFBConfig");
    library.get(create_pbuffer, "glXCreatePbuffer");
    library.get(destroy_pbuffer, "glXDestroyPbuffer");
    library.get(make_current, "glXMakeContextCurrent");
    library.get(destroy, "glXDestroyContext");
    library.get(swap, "glXSwapBuffers");
    create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        address(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    if (create == nullptr) throw std::runtime_error("GLX has no ARB_create_context");
    display = open(nullptr);
    if (display == nullptr) throw std::runtime_error("no X display: set DISPLAY, or run under xvfb-run -a");
  }
};

class GlxContext : public Context {
 public:
  GlxContext(const Glx& glx, GLXContext context, GLXPbuffer surface)
      : glx_(glx), context_(context), surface_(surface) {}
  ~GlxContext() override {
    release_current();
    glx_.destroy_pbuffer(glx_.display, surface_);
    glx_.destroy(glx_.display, context_);
  }

  bool make_current() override { return glx_.make_current(glx_.display, surface_, surface_, context_) == True; }
  void release_current() override { glx_.make_current(glx_.display, None, None, nullptr); }
  void end_frame() override {
    reinterpret_cast<void (*)()>(glx_.address(reinterpret_cast<const GLubyte*>("glFinish")))();
    glx_.swap(glx_.display, surface_);
  }
  GLXContext handle() const { return context_; }

 private:
  const Glx& glx_;
  GLXContext context_;
  GLXPbuffer surface_;
};

int ignore_error(Display*, XErrorEvent*) {
  return 0;
}  // a context that cannot be made is an X error, whose default is to exit

class GlxPlatform : public Platform {
 public:
  void* function(const char* name) override {
    return reinterpret_cast<void*>(glx_.address(reinterpret_cast<const GLubyte*>(name)));
  }

  std::unique_ptr<Context> create_context(Api api, Context* share) override {
    const GLXFBConfig config = choose();
    const int size[] = {GLX_PBUFFER_WIDTH, surface_size, GLX_PBUFFER_HEIGHT, surface_size, None};
    const GLXPbuffer surface = glx_.create_pbuffer(glx_.display, config, size);
    const int profile = api == Api::gl_core ? GLX_CONTEXT_CORE_PROFILE_BIT_ARB
                        : api == Api::gles  ? GLX_CONTEXT_ES_PROFILE_BIT_EXT
                                            : GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
    const int attributes[] = {GLX_CONTEXT_MAJOR_VERSION_ARB,
                              api == Api::gles ? 3 : 4,
                              GLX_CONTEXT_MINOR_VERSION_ARB,
                              api == Api::gles ? 2 : 3,
                              GLX_CONTEXT_PROFILE_MASK_ARB,
                              profile,
                              None};
    const auto handler = glx_.set_error_handler(ignore_error);
    const GLXContext handle = glx_.create(
        glx_.display, config, share != nullptr ? static_cast<GlxContext*>(share)->handle() : nullptr, True, attributes);
    glx_.sync(glx_.display, False);
    glx_.set_error_handler(handler);
    if (handle == nullptr) {
      glx_.destroy_pbuffer(glx_.display, surface);
      throw std::runtime_error("GLX gives no context of " + std::string(name_of(api)));
    }
    auto context = std::make_unique<GlxContext>(glx_, handle, surface);
    if (!context->make_current()) throw std::runtime_error("GLX does not make its context current");
    return context;
  }

 private:
  GLXFBConfig choose() const {
    const int wanted[] = {GLX_DRAWABLE_TYPE,
                          GLX_PBUFFER_BIT,
                          GLX_RENDER_TYPE,
                          GLX_RGBA_BIT,
                          GLX_RED_SIZE,
                          8,
                          GLX_GREEN_SIZE,
                          8,
                          GLX_BLUE_SIZE,
                          8,
                          GLX_ALPHA_SIZE,
                          8,
                          GLX_DEPTH_SIZE,
                          24,
                          GLX_STENCIL_SIZE,
                          8,
                          GLX_DOUBLEBUFFER,
                          False,
                          None};
    int count = 0;
    GLXFBConfig* const configs = glx_.choose(glx_.display, 0, wanted, &count);
    if (configs == nullptr || count == 0)
      throw std::runtime_error("GLX has no configuration with pbuffers, RGBA8, depth 24 and stencil 8");
    const GLXFBConfig config = configs[0];
    glx_.free(configs);
    return config;
  }

  Glx glx_;
};

}  // namespace

std::unique_ptr<Platform> open_glx() { return std::make_unique<GlxPlatform>(); }

}  // namespace glark::conformance
