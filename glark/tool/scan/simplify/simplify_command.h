// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The arguments and the work of a simplification, by one process or by several.
#pragma once

#include <glark/vstree.h>

#include <CLI/CLI.hpp>
#include <string>

#include "glark/tool/scan/console.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/info/contents.h"

namespace glark::tool {

struct SimplifyCommand {
  Files files;
  std::string reference;
  vstree::SimplifyOptions options;
  Memory memory;  // larger files are read in parts
  bool is_fast = false;
};

// What is simplified, and what the file has.
struct SimplifyInput {
  geometry::Geometry geometry;
  Report contents;
  bool is_whole = true;
};

// Adds all arguments but --measure, which keeps the whole file in memory. `simplify` must live as long as the command.
void describe(CLI::App& command, SimplifyCommand& simplify);
// Chooses the method if no option names it. Called when the arguments were read.
void set_method(const CLI::App& command, SimplifyCommand& simplify);

// Reads the whole file.
SimplifyInput read_whole(const SimplifyCommand& command);
// Simplifies, and writes the output. reading: runs since the input began to be read. Returns the lines to print. Throws if
// nothing is left: then nothing is written.
Report simplify(const SimplifyCommand& command, const SimplifyInput& input, const Progress& reading);

}  // namespace glark::tool
