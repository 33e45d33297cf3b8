// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The arguments and the report of a sampling, by one process or by several.
#pragma once

#include <glark/stream.h>

#include <CLI/CLI.hpp>
#include <string>

#include "glark/tool/scan/console.h"

namespace glark::tool {

struct SampleCommand {
  std::string input, output, format;
  stream::SampleOptions options;
  bool text = false, json = false;
};

// Adds all arguments but --resume and those of a refinement. `sample` must live as long as the command.
void describe(CLI::App& command, SampleCommand& sample);

// Warns of what the samples lack. Returns the lines to print.
Report report_of(const SampleCommand& sample, const stream::SampleReport& report, double seconds);

// Not every format has normals, which a sampling always has.
void warn_without_normals(const std::string& output);

}  // namespace glark::tool
