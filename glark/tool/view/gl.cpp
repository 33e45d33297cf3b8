// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/gl.h"

#include <stdexcept>
#include <string>

namespace glark::tool {

Gl gl;

void Gl::load(Loader loader) {
  const auto get = [&]<typename Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(loader(name));
    if (function == nullptr)
      throw std::runtime_error(std::string("this OpenGL has no ") + name + "; glark info says what it is");
  };
#define GLARK_LOAD(name) get(name, "gl" #name);
  GLARK_VIEW_GL(GLARK_LOAD)
#undef GLARK_LOAD
}

}  // namespace glark::tool
