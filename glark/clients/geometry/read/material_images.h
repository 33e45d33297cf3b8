// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The colours of a scene's materials as pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"

struct aiScene;

namespace glark::geometry {

struct MaterialImages {
  std::vector<Image> images;
  std::vector<std::uint32_t> of_mesh;  // the image of each mesh of the scene
  bool has_pictures = false;           // otherwise all images have one pixel
  std::vector<std::string> warnings;   // pictures that cannot be read
};

// A material without a picture has one of one pixel. Nothing if no material has a picture, and all are grey: many programs
// write such a material for every mesh. folder: where the names of pictures begin.
MaterialImages read_material_images(const aiScene& scene, const std::filesystem::path& folder);

}  // namespace glark::geometry
