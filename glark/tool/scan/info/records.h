// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// What a file of records has. An STL file has a point for each corner of its triangles.
struct Records {
  geometry::Summary summary;
  std::vector<std::string> other_channels;  // besides the colours
};

// Reads a LAS file, a binary STL file or triples of floats a part at a time.
Records count_records(const std::filesystem::path& file, const std::string& format, bool skip_invalid);

}  // namespace glark::tool
