// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/gl.h"

#include <fmt/format.h>

#include <stdexcept>

namespace glark::tool {

GladGLContext gl;

void load_gl(GLADloadfunc loader) {
  const int version = gladLoadGLContext(&gl, loader);
  if (gl.VERSION_3_0 == 0) {
    throw std::runtime_error(fmt::format("this OpenGL is version {}.{}, and glark view needs 3.0; see glark info",
                                         GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
  }
}

void need_patterns(int level) {
  GLint pool_level = -1;
  gl.GetIntegerv(GL_POOL_LEVEL_ARK, &pool_level);
  if (pool_level != level) gl.ARKinit(static_cast<GLuint>(level));
}

}  // namespace glark::tool
