// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <GL/osmesa.h>

#include <stdexcept>
#include <vector>

#include "conformance/platform/library.h"
#include "conformance/platform/platform.h"

namespace glark::conformance {
namespace {

struct Osmesa {
  Library library{"libOSMesa.so.8"};
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) address = nullptr;

  Osmesa() {
    library.get(create, "OSMesaCreateContextAttribs");
    library.get(destroy, "OSMesaDestroyContext");
    library.get(make_current, "OSMesaMakeCurrent");
    library.get(address, "OSMesaGetProcAddress");
  }
};

class OsmesaContext : public Context {
 public:
  OsmesaContext(const Osmesa& osmesa, OSMesaContext context)
      : osmesa_(osmesa), context_(context), image_(std::size_t{4} * surface_size * surface_size) {}
  ~OsmesaContext() override {
    release_current();
    osmesa_.destroy(context_);
  }

  bool make_current() override {
    return osmesa_.make_current(context_, image_.data(), GL_UNSIGNED_BYTE, surface_size, surface_size) != 0;
  }
  void release_current() override { osmesa_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  void end_frame() override { reinterpret_cast<void (*)()>(osmesa_.address("glFinish"))(); }
  OSMesaContext handle() const { return context_; }

 private:
  const Osmesa& osmesa_;
  OSMesaContext context_;
  std::vector<GLubyte> image_;
};

class OsmesaPlatform : public Platform {
 public:
  void* function(const char* name) override { return reinterpret_cast<void*>(osmesa_.address(name)); }

  std::unique_ptr<Context> create_context(Api api, Context* share) override {
    if (api == Api::gles) throw std::runtime_error("OSMesa has no OpenGL ES: --platform egl has it");
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              api == Api::gl_core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    OSMesaContext handle =
        osmesa_.create(attributes, share != nullptr ? static_cast<OsmesaContext*>(share)->handle() : nullptr);
    if (handle == nullptr) throw std::runtime_error("OSMesa gives no context of OpenGL 4.3");
    auto context = std::make_unique<OsmesaContext>(osmesa_, handle);
    if (!context->make_current()) throw std::runtime_error("OSMesa does not make its context current");
    return context;
  }

 private:
  Osmesa osmesa_;
};

}  // namespace

std::unique_ptr<Platform> open_osmesa() { return std::make_unique<OsmesaPlatform>(); }

}  // namespace glark::conformance
