// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace glark::shim {

// From now on, writes original and derived shaders to this folder (GLARK_DUMP_SHADERS).
void install_shader_dump(const std::string& folder);

}  // namespace glark::shim
