// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/core/support/osmesa_context.h"

#include <cstdio>
#include <cstdlib>

namespace glark::core::test {

OsmesaContext::OsmesaContext(Profile profile, const OsmesaContext* share) : image_(4 * picture_size * picture_size) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            profile == Profile::core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            4,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            5,
                            0,
                            0};
  context_ = OSMesaCreateContextAttribs(attributes, share != nullptr ? share->context_ : nullptr);
  if (context_ == nullptr) {
    std::fputs("no OSMesa context of OpenGL 4.5\n", stderr);
    std::abort();
  }
  make_current();
}

OsmesaContext::~OsmesaContext() {
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  OSMesaDestroyContext(context_);
}

void OsmesaContext::make_current() {
  OSMesaMakeCurrent(context_, image_.data(), GL_UNSIGNED_BYTE, picture_size, picture_size);
}

std::string pending_errors() {
  std::string text;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    char number[16];
    std::snprintf(number, sizeof(number), "0x%04X ", error);
    text += number;
  }
  return text;
}

void refine_uniformly(GLuint level, GLenum refinement) {
  glARKinit(level);
  glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level));
  glEnable(GL_ARK);
}

}  // namespace glark::core::test
