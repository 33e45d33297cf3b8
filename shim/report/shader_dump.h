// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace glark::shim {

// From now on shaders are written to this folder (GLARK_DUMP_SHADERS), original and derived ones side by side.
void install_shader_dump(const std::string& folder);

}  // namespace glark::shim
