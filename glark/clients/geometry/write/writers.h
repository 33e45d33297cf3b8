// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One writer a format. Each throws Error where the format cannot hold the geometry.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/write/output_file.h"

namespace glark::geometry {

enum class PlyEncoding { binary, text };

// Positions as float, as double where there is an origin.
void write_ply(OutputFile& file, const Geometry& geometry, PlyEncoding encoding);
void write_obj(OutputFile& file, const Geometry& geometry);
// x y z, then colours, then normals.
void write_xyz(OutputFile& file, const Geometry& geometry);
// As XYZ with an intensity of 0, the number of points in the first line.
void write_pts(OutputFile& file, const Geometry& geometry);
// Binary; `name` for messages.
void write_stl(OutputFile& file, const Geometry& geometry, const std::string& name);
// glTF 2.0 in one binary file; the origin is the node's translation.
void write_glb(OutputFile& file, const Geometry& geometry, const std::string& name);

}  // namespace glark::geometry
