// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The option --memory of commands that read a whole file if it fits, and in parts if not.
#pragma once

#include <CLI/CLI.hpp>

#include "glark/tool/scan/info/contents.h"

namespace glark::tool {

void describe_memory(CLI::App& command, Memory& memory);

// The given memory, or three quarters of the machine's.
Memory memory_for(const Memory& given);

}  // namespace glark::tool
