// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads and writes geometry in the format that the file's ending names.
#pragma once

#include <filesystem>
#include <functional>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Fraction of the work that is done, 0 to 1; less than 0 where it cannot be known.
using Progress = std::function<void(double fraction)>;

// PLY, OBJ, STL, XYZ (TXT, ASC, CSV) or PTS, each also compressed by zstd (.zst behind the ending). Throws Error.
Reading read_file(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress = {});

struct WriteOptions {
  bool text = false;  // of PLY
};

// PLY, OBJ, STL, XYZ, PTS or GLB. The file appears complete or not at all. Throws Error.
void write_file(const std::filesystem::path& file, const Geometry& geometry, const WriteOptions& options = {});

// Throws Error where write_file cannot write this: found out before an hour's work.
void check_writable(const std::filesystem::path& file);

}  // namespace glark::geometry
