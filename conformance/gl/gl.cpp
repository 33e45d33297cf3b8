// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/gl/gl.h"

#include "conformance/gl/observer.h"

namespace glark::conformance {
namespace {

GLADapiproc address(void* source, const char* name) {
  return reinterpret_cast<GLADapiproc>(static_cast<FunctionSource*>(source)->function(name));
}

}  // namespace

GladGLContext gl;
Observer* observer = nullptr;

void load_functions(FunctionSource& source, bool is_gles) {
  gl = {};
  (is_gles ? gladLoadGLES2ContextUserPtr : gladLoadGLContextUserPtr)(&gl, address, &source);
  if (observer != nullptr) observer->loaded(gl);
}

}  // namespace glark::conformance
