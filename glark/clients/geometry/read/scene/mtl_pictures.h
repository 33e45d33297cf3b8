// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pictures of colours that the material files of an OBJ file name, with the options before the names. Assimp drops
// offsets and scales, and takes a wrong name if there are fewer numbers than it skips.
// Specification: Wavefront, MTL material format, version 4.2, 1995, "Options for texture map statements"
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "glark/clients/geometry/read/scene/texture_use.h"

struct aiScene;

namespace glark::geometry {

// folder: where the names of files begin.
TextureUses mtl_texture_uses(std::string_view obj, const std::filesystem::path& folder, const aiScene& scene);

}  // namespace glark::geometry
