// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/uniform_watch.h"

namespace glark::core {

void watch_uniforms(const gl::Dispatch& gl, std::span<const std::string> names, const Program& program,
                    DerivedProgram& derived) {
  const std::lock_guard lock(program.mutex);
  if (derived.shape_uniforms == nullptr) {
    derived.shape_uniforms = std::make_unique<ShapeUniforms>();
  }
  for (const std::string& name : names) {
    const GLint location = gl.GetUniformLocation(derived.name, name.c_str());
    for (std::size_t own = 0; own < derived.location_of.size(); ++own) {
      if (location >= 0 && derived.location_of[own] == location) {
        derived.shape_uniforms->locations.insert(static_cast<GLint>(own));
      }
    }
  }
}

}  // namespace glark::core
