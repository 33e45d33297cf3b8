// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The file that a command reads, the one that it writes, and the options that say how.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/console.h"

namespace glark::tool {

struct Files {
  std::string input;
  std::string output;
  bool skip_invalid = false;
  bool text = false;
  bool json = false;
};

void describe_input(CLI::App& command, Files& files);
void describe_output(CLI::App& command, Files& files);
void describe_threads(CLI::App& command, unsigned& threads);

// Throws where the output cannot be written: before the work.
void check_output(const Files& files);
// With progress; warnings go to standard error.
geometry::Geometry load(const std::string& file, const Files& files);
void store(const geometry::Geometry& geometry, const Files& files);

// Numbers of points and triangles, names of the attributes.
Report contents_of(const geometry::Geometry& geometry);

}  // namespace glark::tool
