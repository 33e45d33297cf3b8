// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <string>

namespace glark::tool {

// Reads box:X,Y,Z,X,Y,Z (two corners), sphere:X,Y,Z,R or channel:NAME. Throws std::runtime_error for anything else.
stream::Region parse_region(const std::string& text);

}  // namespace glark::tool
