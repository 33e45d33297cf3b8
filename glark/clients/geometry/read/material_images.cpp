// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/material_images.h"

#include <fmt/format.h>

#include <assimp/material.h>
#include <assimp/scene.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>

#include "glark/clients/geometry/read/scene/uri_files.h"
#include "glark/clients/geometry/srgb.h"

namespace glark::geometry {
namespace {

using Colour = std::array<float, 3>;

constexpr Colour white{1, 1, 1}, black{0, 0, 0};

std::uint8_t to_byte(float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F); }

struct Picture {
  Image image;
  bool is_opaque = true;
};

// The picture of a compressed file: PNG, JPEG and others that stb_image reads. Throws Error.
Picture decoded(std::span<const unsigned char> bytes, const std::string& name) {
  tinygltf::Image image;
  std::string error, warning;
  if (!tinygltf::LoadImageData(&image, 0, &error, &warning, 0, 0, bytes.data(), static_cast<int>(bytes.size()),
                               nullptr))
    throw Error(name + " is no picture in a format that is known; convert it to PNG or JPEG");
  const auto step = static_cast<std::size_t>(image.bits / 8);
  const auto components = static_cast<std::size_t>(image.component);
  Picture result{.image = {static_cast<unsigned>(image.width), static_cast<unsigned>(image.height), {}}};
  const std::size_t pixels = std::size_t{result.image.width} * result.image.height;
  if (components < 3 || image.image.size() < pixels * components * step)
    throw Error(name + " is a picture without red, green and blue; convert it to PNG or JPEG with colours");
  const auto value = [&](std::size_t pixel, std::size_t component) {
    return image.image[(pixel * components + component) * step + step - 1];  // the high byte comes last
  };
  result.image.pixels.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result.image.pixels.push_back(value(i, k));
    result.is_opaque = result.is_opaque && (components < 4 || value(i, 3) == 255);
  }
  return result;
}

Picture raw(const aiTexture& texture) {
  Picture result{.image = {texture.mWidth, texture.mHeight, {}}};
  std::vector<std::uint8_t>& pixels = result.image.pixels;
  for (std::size_t i = 0; i < std::size_t{texture.mWidth} * texture.mHeight; ++i) {
    const aiTexel& texel = texture.pcData[i];
    pixels.insert(pixels.end(), {texel.r, texel.g, texel.b});
    result.is_opaque = result.is_opaque && texel.a == 255;
  }
  return result;
}

std::filesystem::path file_of(std::string name, const MaterialSource& source) {
  std::replace(name.begin(), name.end(), '\\', '/');  // programs for Windows write such names
  return source.is_gltf ? file_of_uri(source.folder, name) : source.folder / name;
}

Picture read_picture(const std::string& name, const MaterialSource& source) {
  if (name.find("://") != std::string::npos)
    throw Error("the picture " + name + " is not on this machine; put it beside the file and name it there");
  const std::filesystem::path file = file_of(name, source);
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file, error) || !stream)
    throw Error("there is no picture " + file.string() + "; put it there");
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return decoded(bytes, file.string());
}

// Multiplies a picture by a colour. is_linear: the colour is, and the product is that of linear colours.
void tint(Image& image, const Colour& colour, bool is_linear) {
  if (colour == white) return;
  std::array<std::array<std::uint8_t, 256>, 3> shown{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 256; ++i) {
      const float value = static_cast<float>(i) / 255;
      shown[k][i] = to_byte(is_linear ? srgb_from_linear(colour[k] * linear_from_srgb(value)) : colour[k] * value);
    }
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = shown[i % 3][image.pixels[i]];
}

Wrap wrap_of(const aiMaterial& material, const char* key) {
  int mode = aiTextureMapMode_Wrap;
  material.Get(key, aiTextureType_DIFFUSE, 0, mode);
  if (mode == aiTextureMapMode_Mirror) return Wrap::mirror;
  return mode == aiTextureMapMode_Wrap ? Wrap::repeat : Wrap::clamp;
}

class Reader {
 public:
  Reader(const aiScene& scene, const MaterialSource& source) : scene_(scene), source_(source) {}

  MaterialImages read() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) read(i);
    if (has_alpha_) result_.warnings.emplace_back("its materials are not opaque; the result has no alpha");
    if (!has_pictures_ && !has_colours_) return {.images = {}, .of_mesh = {}, .warnings = std::move(result_.warnings)};
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const unsigned material = scene_.mMeshes[i]->mMaterialIndex;
      const bool exists = material < result_.images.size();
      const bool takes_vertices = exists && !source_.is_gltf && source_.has_vertex_colours && !is_picture_[material];
      result_.of_mesh.push_back(exists && !takes_vertices ? material : no_image);
    }
    return std::move(result_);
  }

 private:
  void read(unsigned index) {
    const aiMaterial& material = *scene_.mMaterials[index];
    const TextureUse use = use_of_material(scene_, index, source_.uses);
    aiColor3D found(1, 1, 1);
    const bool has_colour = material.Get(AI_MATKEY_COLOR_DIFFUSE, found) == aiReturn_SUCCESS;
    const Colour colour = has_colour ? Colour{found.r, found.g, found.b} : white;
    bool is_opaque = has_opacity(material);
    std::optional<Picture> picture = picture_of(material, use);
    is_picture_.push_back(picture.has_value());
    has_pictures_ |= picture.has_value();
    if (picture) {
      // Many programs write black for a material with a picture.
      if (source_.is_gltf || (colour != black && use.has_colour)) tint(picture->image, colour, source_.is_gltf);
      is_opaque = is_opaque && picture->is_opaque;
    } else {
      has_colours_ |= !(colour[0] == colour[1] && colour[1] == colour[2]) ||
                      (source_.is_gltf && source_.has_vertex_colours && colour != white);
      picture.emplace(Picture{.image = {1, 1, {}}});
      for (const float value : colour)
        picture->image.pixels.push_back(to_byte(source_.is_gltf ? srgb_from_linear(value) : value));
    }
    has_alpha_ |= !is_opaque && uses_alpha(material) && is_used(index);
    picture->image.wrap_s = use.wrap_s;
    picture->image.wrap_t = use.wrap_t;
    result_.images.push_back(std::move(picture->image));
  }

  // The picture of the material's colour, if it has one that can be read.
  std::optional<Picture> picture_of(const aiMaterial& material, const TextureUse& use) {
    aiString name;
    if (material.GetTexture(aiTextureType_DIFFUSE, 0, &name) != aiReturn_SUCCESS && use.file.empty()) return {};
    try {
      return picture(use.file.empty() ? name.C_Str() : use.file);
    } catch (const Error& error) {
      result_.warnings.push_back(std::string(error.what()) + "; its material has one colour instead");
    }
    return {};
  }

  Picture picture(const std::string& name) const {
    const aiTexture* const embedded = scene_.GetEmbeddedTexture(name.c_str());
    if (embedded == nullptr) return read_picture(name, source_);
    if (embedded->mHeight > 0) return raw(*embedded);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(embedded->pcData);
    return decoded({bytes, embedded->mWidth}, fmt::format("the texture {}", name));
  }

  static bool has_opacity(const aiMaterial& material) {
    float opacity = 1;
    material.Get(AI_MATKEY_OPACITY, opacity);
    return opacity >= 1 && material.GetTextureCount(aiTextureType_OPACITY) == 0;
  }

  // The alpha of an opaque material of glTF is ignored (2.0, section 3.9.4).
  bool uses_alpha(const aiMaterial& material) const {
    aiString mode;
    if (!source_.is_gltf) return true;
    material.Get("$mat.gltf.alphaMode", 0, 0, mode);
    return mode.length > 0 && std::string(mode.C_Str()) != "OPAQUE";
  }

  bool is_used(unsigned material) const {
    return std::any_of(scene_.mMeshes, scene_.mMeshes + scene_.mNumMeshes,
                       [material](const aiMesh* mesh) { return mesh->mMaterialIndex == material; });
  }

  const aiScene& scene_;
  const MaterialSource& source_;
  MaterialImages result_;
  std::vector<bool> is_picture_;  // of each material
  bool has_pictures_ = false, has_colours_ = false, has_alpha_ = false;
};

}  // namespace

TextureUse use_of_material(const aiScene& scene, unsigned material, const TextureUses& uses) {
  const auto found = uses.find(material);
  if (found != uses.end()) return found->second;
  TextureUse use;
  if (material >= scene.mNumMaterials) return use;
  int set = 0;
  scene.mMaterials[material]->Get(AI_MATKEY_UVWSRC_DIFFUSE(0), set);
  use.set = static_cast<unsigned>(std::max(0, set));
  use.wrap_s = wrap_of(*scene.mMaterials[material], _AI_MATKEY_MAPPINGMODE_U_BASE);
  use.wrap_t = wrap_of(*scene.mMaterials[material], _AI_MATKEY_MAPPINGMODE_V_BASE);
  return use;
}

MaterialImages read_material_images(const aiScene& scene, const MaterialSource& source) {
  return Reader(scene, source).read();
}

}  // namespace glark::geometry
