// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse versions of models from files.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/subject/mesh.h"

namespace glark::bench {

// The folder that --models names; empty without models.
inline std::string models_folder;  // NOLINT: an option of the program

// Returns the names of the PLY files in the folder, without suffix. The files are binary, little endian, with vertices
// x y z and triangles.
std::vector<std::string> model_names();

// Scales a model into the unit sphere and clusters it on a grid, so that it has about `triangles` triangles. Normals
// are means of the faces of a cluster. Throws std::runtime_error for a file that cannot be read.
Mesh load_model(const std::string& name, std::size_t triangles);

}  // namespace glark::bench
