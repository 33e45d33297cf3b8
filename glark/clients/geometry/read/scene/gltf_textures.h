// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How the materials of a glTF file use the pictures of their colours. Assimp says this in part only: its transforms turn
// about the centre, and it drops the texture coordinates that a transform chooses.
// Specification: KHR_texture_transform, https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Khronos
#pragma once

#include <string>
#include <vector>

#include "glark/clients/geometry/read/scene/texture_use.h"

struct aiScene;

namespace tinygltf {
class Model;
}

namespace glark::geometry {

// Empty if the materials of the two readers do not correspond.
TextureUses gltf_texture_uses(const tinygltf::Model& model, const aiScene& scene);

// Warns of pictures that only extensions give, such as KHR_texture_basisu.
std::vector<std::string> warnings_of_gltf_textures(const tinygltf::Model& model);

}  // namespace glark::geometry
