// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The colours of a scene's materials as pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/scene/texture_use.h"

struct aiScene;

namespace glark::geometry {

struct MaterialImages {
  std::vector<Image> images;
  std::vector<std::uint32_t> of_mesh;  // the image of each mesh of the scene, or no_image: the colours of its vertices
  std::vector<std::string> warnings;   // pictures that cannot be read, and alpha
};

struct MaterialSource {
  std::filesystem::path folder;  // where the names of pictures begin
  // Colours of glTF are linear, those of OBJ as they are shown. The names of pictures are URIs in glTF.
  bool is_gltf = false;
  bool has_vertex_colours = false;  // any mesh has
  TextureUses uses = {};
};

// A material without a picture has one of one pixel, or no_image where an OBJ file has colours of vertices. Nothing if no
// material has a picture, and all are grey: many programs write such a material for every mesh. In glTF, greys multiply
// colours of vertices, so they count.
MaterialImages read_material_images(const aiScene& scene, const MaterialSource& source);

// How the material uses its picture: as the source says, or else as Assimp does.
TextureUse use_of_material(const aiScene& scene, unsigned material, const TextureUses& uses);

}  // namespace glark::geometry
