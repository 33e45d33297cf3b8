// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/contexts.h"
#include "shim/contexts/thread.h"
#include "shim/names/real_functions.h"

using namespace glark::shim;

namespace {

void* osmesa_created(void* context, void* share) {
  context_created(Provider::osmesa, context, share);
  return context;
}

}  // namespace

GLARK_EXPORT OSMesaProc OSMesaGetProcAddress(const char* name) {
  return reinterpret_cast<OSMesaProc>(
      wrapper_or(name, reinterpret_cast<void*>(GLARK_REAL(OSMesaGetProcAddress)(name))));
}

GLARK_EXPORT void* OSMesaCreateContext(GLenum format, void* share) {
  return osmesa_created(GLARK_REAL(OSMesaCreateContext)(format, share), share);
}

GLARK_EXPORT void* OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accumulation_bits,
                                          void* share) {
  return osmesa_created(GLARK_REAL(OSMesaCreateContextExt)(format, depth_bits, stencil_bits, accumulation_bits, share),
                        share);
}

GLARK_EXPORT void* OSMesaCreateContextAttribs(const int* attributes, void* share) {
  return osmesa_created(GLARK_REAL(OSMesaCreateContextAttribs)(attributes, share), share);
}

// Mesa destroys a context even while it is current. So free our objects first, then treat the context as released.
GLARK_EXPORT void OSMesaDestroyContext(void* context) {
  context_destroyed(Provider::osmesa, context);
  if (context != nullptr && context == current_native() && current_provider() == Provider::osmesa) {
    make_current_begins(Provider::osmesa, nullptr);
    make_current_done(Provider::osmesa, nullptr, {});
  }
  GLARK_REAL(OSMesaDestroyContext)(context);
}

GLARK_EXPORT GLboolean OSMesaMakeCurrent(void* context, void* buffer, GLenum type, GLsizei width, GLsizei height) {
  make_current_begins(Provider::osmesa, context);
  const GLboolean succeeded = GLARK_REAL(OSMesaMakeCurrent)(context, buffer, type, width, height);
  if (succeeded) make_current_done(Provider::osmesa, context, {.width = width, .height = height});
  return succeeded;
}
