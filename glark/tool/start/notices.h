// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a user has to know before a program starts: why the preload cannot reach it, or why it cannot run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glark/tool/start/program_file.h"

namespace glark::tool {

// Returns one sentence for each reason why the program would run, but unrefined. `files` is read_command(); `libraries` are
// those that LD_PRELOAD leads to, the first one for programs of the launcher's kind.
std::vector<std::string> start_notices(std::span<const ProgramFile> files, std::span<const ElfFile> libraries);

// Returns the reason why the kernel cannot run the program although its file exists; nothing if it can.
std::optional<std::string> cannot_run(std::span<const ProgramFile> files);

}  // namespace glark::tool
