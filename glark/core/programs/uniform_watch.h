// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

// From now on, derived.shape_uniforms counts the changes of these uniforms of the derived program.
void watch_uniforms(const gl::Dispatch& gl, std::span<const std::string> names, const Program& program,
                    DerivedProgram& derived);

}  // namespace glark::core
