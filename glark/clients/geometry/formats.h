// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads and writes files. The ending of the name gives the format.
#pragma once

#include <filesystem>
#include <functional>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Receives the finished fraction of the work, 0 to 1. A negative value means that the fraction is unknown.
using Progress = std::function<void(double fraction)>;

// Reads PLY, OBJ, STL, OFF, glTF (GLB), PCD, XYZ (TXT, ASC, CSV) or PTS, or one of these compressed by zstd (with a second ending .zst).
// Throws Error.
Reading read_file(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress = {});

// Whether summarise_file() reads this file.
bool can_summarise(const std::filesystem::path& file, const ReadOptions& options);

// Reads PLY, PCD, XYZ or PTS a part at a time, with the errors and warnings of read_file(), and keeps no points. It takes a
// few MiB for any file. Throws Error.
Summary summarise_file(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress = {});

struct WriteOptions {
  bool text = false;  // writes PLY as text
};

// Writes PLY, OBJ, STL, XYZ, PTS or GLB. The writing is atomic. Throws Error.
void write_file(const std::filesystem::path& file, const Geometry& geometry, const WriteOptions& options = {});

// Throws Error if write_file() cannot write this file. Commands call it before a long computation.
void check_writable(const std::filesystem::path& file);

}  // namespace glark::geometry
