// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The files that a command reads and writes, and the options for them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/console.h"

namespace glark::tool {

struct Files {
  std::string input;
  std::string format;  // ".ply"; empty: that of the input's name
  std::string output;
  bool skip_invalid = false;
  bool text = false;
  bool json = false;
};

// more_formats: those that this command reads in addition, without a dot.
void describe_input(CLI::App& command, Files& files, const std::vector<std::string>& more_formats = {});
void describe_output(CLI::App& command, Files& files);
void describe_threads(CLI::App& command, unsigned& threads);

// Throws if the output cannot be written. It may be the input. Commands call it before the work.
void check_output(const Files& files);
// Reads a file and shows progress. Warnings go to standard error. with_images, all_points: as in geometry::ReadOptions.
geometry::Geometry load(const std::string& file, const Files& files, bool with_images = false, bool all_points = false);
void store(const geometry::Geometry& geometry, const Files& files);

// Reports the numbers of points and triangles, and the names of the attributes.
Report contents_of(const geometry::Geometry& geometry);

}  // namespace glark::tool
