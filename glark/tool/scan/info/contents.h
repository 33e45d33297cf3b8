// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The contents of a file that is read a part at a time, because it is too large for the memory.
#pragma once

#include <cstdint>
#include <filesystem>

#include "glark/tool/scan/files.h"

namespace glark::tool {

struct Memory {
  std::uint64_t bytes = std::uint64_t{256} << 20;
  bool is_given = false;  // by an option
};

// The file's path; that of standard input for "-".
std::filesystem::path path_of(const Files& files);

// Returns whether the input is to be read in parts: it does not fit into the memory, or its format is only read so. The
// size of a pipe is unknown; it is read in parts if the memory is given. Throws if the memory is given, the input does not
// fit, and its format is only read as a whole.
bool must_read_in_parts(const Files& files, const Memory& memory);

// Reports what can be known without keeping the points. Warnings go to standard error.
Report contents_in_parts(const Files& files);

}  // namespace glark::tool
