// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <GL/osmesa.h>

#include <vector>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {

bool make_current(Api api) {
  static std::vector<unsigned char> image(4 * 16 * 16);
  static OSMesaContext contexts[2] = {};
  if (api == Api::es) return false;
  OSMesaContext& context = contexts[api == Api::core ? 1 : 0];
  if (context == nullptr) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              api == Api::core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0,
                              0};
    context = OSMesaCreateContextAttribs(attributes, nullptr);
  }
  return context != nullptr && OSMesaMakeCurrent(context, image.data(), GL_UNSIGNED_BYTE, 16, 16);
}

void* get_proc(const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

}  // namespace glark::refine::test
