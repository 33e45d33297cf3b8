// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One function for each format. It throws Error if the format cannot hold the geometry.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/write/output_file.h"

namespace glark::geometry {

enum class PlyEncoding { binary, text };

// Positions are floats, or doubles if there is an origin.
void write_ply(OutputFile& file, const Geometry& geometry, PlyEncoding encoding);
void write_obj(OutputFile& file, const Geometry& geometry);
// Writes lines of x y z, then colours, then normals.
void write_xyz(OutputFile& file, const Geometry& geometry);
// Writes lines as XYZ, with an intensity of 0. The first line is the number of points.
void write_pts(OutputFile& file, const Geometry& geometry);
// Binary STL. Messages name the file `name`.
void write_stl(OutputFile& file, const Geometry& geometry, const std::string& name);
// Binary glTF 2.0. The origin becomes the translation of the node.
void write_glb(OutputFile& file, const Geometry& geometry, const std::string& name);

}  // namespace glark::geometry
