// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <GL/glx.h>
// This follows GL/glx.h because it names types of that header.
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
  decltype(&XCreateColormap) create_colormap = nullptr;
  decltype(&XFreeColormap) free_colormap = nullptr;
  decltype(&XCreateWindow) create_window = nullptr;
  decltype(&XDestroyWindow) destroy_window = nullptr;
  decltype(&glXGetProcAddressARB) address = nullptr;
  decltype(&glXChooseFBConfig) choose = nullptr;
  decltype(&glXGetVisualFromFBConfig) visual_of = nullptr;
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
    x11.get(create_colormap, "XCreateColormap");
    x11.get(free_colormap, "XFreeColormap");
    x11.get(create_window, "XCreateWindow");
    x11.get(destroy_window, "XDestroyWindow");
    library.get(address, "glXGetProcAddressARB");
    library.get(choose, "glXChooseFBConfig");
    library.get(visual_of, "glXGetVisualFromFBConfig");
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

// A window that is never mapped. Mesa 22 sends the pixels of pbuffers to the server in a depth that they do not have.
class HiddenWindow {
 public:
  HiddenWindow(const Glx& glx, GLXFBConfig config) : glx_(glx) {
    XVisualInfo* const visual = glx.visual_of(glx.display, config);
    if (visual == nullptr) throw std::runtime_error("GLX has no visual for its configuration");
    const Window root = RootWindow(glx.display, visual->screen);
    colormap_ = glx.create_colormap(glx.display, root, visual->visual, AllocNone);
    XSetWindowAttributes attributes{};
    attributes.colormap = colormap_;
    window_ = glx.create_window(glx.display, root, 0, 0, surface_size, surface_size, 0, visual->depth, InputOutput,
                                visual->visual, CWBorderPixel | CWColormap, &attributes);
    glx.free(visual);
  }
  ~HiddenWindow() {
    glx_.destroy_window(glx_.display, window_);
    glx_.free_colormap(glx_.display, colormap_);
  }
  HiddenWindow(const HiddenWindow&) = delete;
  HiddenWindow& operator=(const HiddenWindow&) = delete;

  Window handle() const { return window_; }

 private:
  const Glx& glx_;
  Colormap colormap_ = None;
  Window window_ = None;
};

class GlxContext : public Context {
 public:
  GlxContext(const Glx& glx, GLXContext context, std::unique_ptr<HiddenWindow> window)
      : glx_(glx), context_(context), window_(std::move(window)) {}
  ~GlxContext() override {
    release_current();
    glx_.destroy(glx_.display, context_);
  }

  bool make_current() override {
    return glx_.make_current(glx_.display, window_->handle(), window_->handle(), context_) == True;
  }
  void release_current() override { glx_.make_current(glx_.display, None, None, nullptr); }
  void end_frame() override {
    reinterpret_cast<void (*)()>(glx_.address(reinterpret_cast<const GLubyte*>("glFinish")))();
    glx_.swap(glx_.display, window_->handle());
  }
  GLXContext handle() const { return context_; }

 private:
  const Glx& glx_;
  GLXContext context_;
  std::unique_ptr<HiddenWindow> window_;
};

int ignore_error(Display*, XErrorEvent*) { return 0; }  // If a context cannot be made, the X library exits by default.

class GlxPlatform : public Platform {
 public:
  void* function(const char* name) override {
    return reinterpret_cast<void*>(glx_.address(reinterpret_cast<const GLubyte*>(name)));
  }

  std::unique_ptr<Context> create_context(Api api, Context* share) override {
    const GLXFBConfig config = choose();
    auto window = std::make_unique<HiddenWindow>(glx_, config);
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
    if (handle == nullptr) throw std::runtime_error("GLX gives no context of " + std::string(name_of(api)));
    auto context = std::make_unique<GlxContext>(glx_, handle, std::move(window));
    if (!context->make_current()) throw std::runtime_error("GLX does not make its context current");
    return context;
  }

 private:
  GLXFBConfig choose() const {
    const int wanted[] = {GLX_DRAWABLE_TYPE,
                          GLX_WINDOW_BIT,
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
      throw std::runtime_error("GLX has no configuration with windows, RGBA8, depth 24 and stencil 8");
    const GLXFBConfig config = configs[0];
    glx_.free(configs);
    return config;
  }

  Glx glx_;
};

}  // namespace

std::unique_ptr<Platform> open_glx() { return std::make_unique<GlxPlatform>(); }

}  // namespace glark::conformance
