// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/scene/gltf_textures.h"

#include <fmt/format.h>

#include <assimp/material.h>
#include <assimp/scene.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

#include "glark/clients/geometry/read/element_at.h"

namespace glark::geometry {
namespace {

// The numbers of the materials in the order in which Assimp meets them: the children of a node come before its mesh.
class MaterialOrder {
 public:
  explicit MaterialOrder(const tinygltf::Model& model) : model_(model) {
    if (const tinygltf::Scene* scene = element_at(model.scenes, std::max(0, model.defaultScene)))
      for (const int node : scene->nodes) visit(node);
  }

  const std::vector<int>& materials() const { return materials_; }

 private:
  void visit(int index) {
    const tinygltf::Node* const node = element_at(model_.nodes, index);
    if (node == nullptr || !seen_nodes_.insert(index).second) return;
    for (const int child : node->children) visit(child);
    if (const tinygltf::Mesh* mesh = element_at(model_.meshes, node->mesh))
      for (const tinygltf::Primitive& primitive : mesh->primitives)
        if (element_at(model_.materials, primitive.material) && seen_materials_.insert(primitive.material).second)
          materials_.push_back(primitive.material);
  }

  const tinygltf::Model& model_;
  std::set<int> seen_nodes_, seen_materials_;
  std::vector<int> materials_;
};

// The textureInfo of a material's colour.
struct ColourTexture {
  int index = -1, set = 0;
  const tinygltf::Value* transform = nullptr;
};

const tinygltf::Value* member(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

std::optional<ColourTexture> diffuse_texture(const tinygltf::Material& material) {
  const tinygltf::Value* const extension = member(material.extensions, "KHR_materials_pbrSpecularGlossiness");
  if (extension == nullptr || !extension->Has("diffuseTexture")) return {};
  const tinygltf::Value& info = extension->Get("diffuseTexture");
  if (!info.IsObject() || !info.Get("index").IsNumber()) return {};
  ColourTexture texture{.index = info.Get("index").GetNumberAsInt()};
  if (info.Get("texCoord").IsNumber()) texture.set = info.Get("texCoord").GetNumberAsInt();
  const tinygltf::Value& extensions = info.Get("extensions");
  if (extensions.IsObject() && extensions.Get("KHR_texture_transform").IsObject())
    texture.transform = &extensions.Get("KHR_texture_transform");
  return texture;
}

ColourTexture colour_texture(const tinygltf::Material& material) {
  if (const auto texture = diffuse_texture(material)) return *texture;
  const tinygltf::TextureInfo& info = material.pbrMetallicRoughness.baseColorTexture;
  return {.index = info.index,
          .set = std::max(0, info.texCoord),
          .transform = member(info.extensions, "KHR_texture_transform")};
}

std::array<double, 2> pair_of(const tinygltf::Value& object, const char* name, double otherwise) {
  const tinygltf::Value& value = object.Get(name);
  if (!value.IsArray() || value.ArrayLen() != 2 || !value.Get(0).IsNumber() || !value.Get(1).IsNumber())
    return {otherwise, otherwise};
  return {value.Get(0).GetNumberAsDouble(), value.Get(1).GetNumberAsDouble()};
}

// In glTF, the upper left pixel is at 0 0, so t is 1 - v.
void add_transform(const tinygltf::Value& transform, TextureUse& use) {
  const auto [offset_u, offset_v] = pair_of(transform, "offset", 0);
  const auto [scale_u, scale_v] = pair_of(transform, "scale", 1);
  const tinygltf::Value& rotation = transform.Get("rotation");
  const double angle = rotation.IsNumber() ? rotation.GetNumberAsDouble() : 0;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  // u' = cosine scale_u u + sine scale_v v + offset_u, v' = -sine scale_u u + cosine scale_v v + offset_v
  use.transform = {{{cosine * scale_u, -sine * scale_v, sine * scale_v + offset_u},
                    {sine * scale_u, cosine * scale_v, 1 - cosine * scale_v - offset_v}}};
  const tinygltf::Value& set = transform.Get("texCoord");
  if (set.IsNumber()) use.set = static_cast<unsigned>(std::max(0, set.GetNumberAsInt()));
}

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

TextureUse use_of(const tinygltf::Model& model, const tinygltf::Material& material) {
  const ColourTexture info = colour_texture(material);
  TextureUse use{.set = static_cast<unsigned>(std::max(0, info.set))};
  if (info.transform != nullptr) add_transform(*info.transform, use);
  const tinygltf::Texture* const texture = element_at(model.textures, info.index);
  if (const tinygltf::Sampler* sampler = texture == nullptr ? nullptr : element_at(model.samplers, texture->sampler)) {
    use.wrap_s = wrap_of(sampler->wrapS);
    use.wrap_t = wrap_of(sampler->wrapT);
  }
  return use;
}

// Assimp adds a material for meshes without one at the end.
bool correspond(const tinygltf::Model& model, const std::vector<int>& order, const aiScene& scene) {
  if (order.size() > scene.mNumMaterials) return false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    aiString name;
    scene.mMaterials[i]->Get(AI_MATKEY_NAME, name);
    if (model.materials[static_cast<std::size_t>(order[i])].name != name.C_Str()) return false;
  }
  return true;
}

}  // namespace

TextureUses gltf_texture_uses(const tinygltf::Model& model, const aiScene& scene) {
  const MaterialOrder order(model);
  TextureUses uses;
  if (!correspond(model, order.materials(), scene)) return uses;
  for (std::size_t i = 0; i < order.materials().size(); ++i)
    uses[static_cast<unsigned>(i)] = use_of(model, model.materials[static_cast<std::size_t>(order.materials()[i])]);
  return uses;
}

std::vector<std::string> warnings_of_gltf_textures(const tinygltf::Model& model) {
  std::set<std::string> extensions;
  const MaterialOrder order(model);
  for (const int material : order.materials()) {
    const int index = colour_texture(model.materials[static_cast<std::size_t>(material)]).index;
    const tinygltf::Texture* const texture = element_at(model.textures, index);
    if (texture == nullptr || texture->source >= 0) continue;
    for (const auto& [name, value] : texture->extensions) extensions.insert(name);
  }
  std::vector<std::string> warnings;
  for (const std::string& name : extensions)
    warnings.push_back(
        fmt::format("pictures of the extension {} are not read; write them as PNG or JPEG without it", name));
  return warnings;
}

}  // namespace glark::geometry
