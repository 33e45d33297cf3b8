// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans and their meshes from PLY files, packed by zstd or not.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glark::bench {

struct Scan {
  std::vector<float> positions, normals;  // [3 * points]; normals may be empty
  std::vector<std::uint32_t> triangles;   // [3 * triangles], may be empty
};

// NAME.ply or NAME.ply.zst of the folder: binary little endian, x y z [nx ny nz] floats first. Throws std::runtime_error saying what is
// missing or wrong. `zstd` has to be installed for packed ones.
Scan read_scan(const std::string& folder, const std::string& name);

// So many samples of a mesh with normals, by area, a little round between its vertices; the same ones every time.
Scan sampled(const Scan& mesh, std::size_t count);

}  // namespace glark::bench
