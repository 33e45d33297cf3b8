// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// ARB_shading_language_include: a shader may include strings that the application has named. GL returns the source of
// such a shader with its directives, and the strings may change after the shader was compiled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glark/gl/dispatch.h"

namespace glark::core {

// Whether a line may be a directive #include. Cheap, and true for few shaders.
bool may_include(std::string_view source);

// The source with the named strings in the place of its directives. `paths`: those of glCompileShaderIncludeARB, in
// which relative names are looked up in their order. A directive whose string is not found stays: it is in a part that
// is not compiled, or the shader does not compile. So does each directive of a source that asks for its line or file.
// Call within an ErrorScope.
std::string expand_includes(const gl::Dispatch& gl, const std::string& source, const std::vector<std::string>& paths);

}  // namespace glark::core
