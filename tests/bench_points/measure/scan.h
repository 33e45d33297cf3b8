// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans and their meshes from PLY files, also compressed by zstd.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glark::bench {

struct Scan {
  std::vector<float> positions, normals;  // [3 * points]; normals may be empty
  std::vector<std::uint32_t> triangles;   // [3 * triangles], may be empty
};

// Reads NAME.ply or NAME.ply.zst from the folder. The file must be binary little endian, with x y z [nx ny nz] as its
// first floats. Throws std::runtime_error with the missing or wrong part. Compressed files need the program zstd.
Scan read_scan(const std::string& folder, const std::string& name);

// Samples a mesh with normals at `count` points, evenly by area. The surface between the vertices is slightly rounded.
// The samples are the same every time.
Scan sampled(const Scan& mesh, std::size_t count);

}  // namespace glark::bench
