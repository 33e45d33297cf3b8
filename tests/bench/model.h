// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Models from files, made coarse.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/mesh.h"

namespace glark::bench {

// Where --models says that they are; empty: nowhere.
inline std::string models_folder;  // NOLINT: an option of the program

// The PLY files (binary, little endian, with vertices x y z and triangles) of the folder, by name without suffix.
std::vector<std::string> model_names();

// Scaled into the unit sphere, and clustered on a grid as coarse as gives about so many triangles; normals are the means of those of
// the faces that went into a vertex. Throws std::runtime_error for a file that cannot be read.
Mesh load_model(const std::string& name, std::size_t triangles);

}  // namespace glark::bench
