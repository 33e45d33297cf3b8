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

#include "glark/clients/geometry/srgb.h"

namespace glark::geometry {
namespace {

using Colour = std::array<float, 3>;

constexpr Colour white{1, 1, 1};

std::uint8_t to_byte(float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F); }

// The picture of a compressed file: PNG, JPEG and others that stb_image reads. Throws Error.
Image decoded(std::span<const unsigned char> bytes, const std::string& name) {
  tinygltf::Image image;
  std::string error, warning;
  if (!tinygltf::LoadImageData(&image, 0, &error, &warning, 0, 0, bytes.data(), static_cast<int>(bytes.size()),
                               nullptr))
    throw Error(name + " is no picture in a format that is known; convert it to PNG or JPEG");
  const auto step = static_cast<std::size_t>(image.bits / 8);
  const auto components = static_cast<std::size_t>(image.component);
  Image result{static_cast<unsigned>(image.width), static_cast<unsigned>(image.height), {}};
  const std::size_t pixels = std::size_t{result.width} * result.height;
  if (components < 3 || image.image.size() < pixels * components * step)
    throw Error(name + " is a picture without red, green and blue; convert it to PNG or JPEG with colours");
  result.pixels.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result.pixels.push_back(image.image[(i * components + k) * step + step - 1]);  // the high byte comes last
  return result;
}

Image raw(const aiTexture& texture) {
  Image image{texture.mWidth, texture.mHeight, {}};
  for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i)
    image.pixels.insert(image.pixels.end(), {texture.pcData[i].r, texture.pcData[i].g, texture.pcData[i].b});
  return image;
}

Image read_picture(std::string name, const std::filesystem::path& folder) {
  std::replace(name.begin(), name.end(), '\\', '/');  // programs for Windows write such names
  const std::filesystem::path file = folder / name;
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file, error) || !stream)
    throw Error("there is no picture " + file.string() + "; put it there");
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return decoded(bytes, file.string());
}

// Multiplies a picture by a linear colour.
void tint(Image& image, const Colour& colour) {
  if (colour == white) return;
  std::array<std::array<std::uint8_t, 256>, 3> shown{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t value = 0; value < 256; ++value)
      shown[k][value] = to_byte(srgb_from_linear(colour[k] * linear_from_srgb(static_cast<float>(value) / 255)));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = shown[i % 3][image.pixels[i]];
}

class Reader {
 public:
  Reader(const aiScene& scene, std::filesystem::path folder) : scene_(scene), folder_(std::move(folder)) {}

  MaterialImages read() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) read(*scene_.mMaterials[i]);
    if (!result_.has_pictures && !has_colours_)
      return {.images = {}, .of_mesh = {}, .has_pictures = false, .warnings = std::move(result_.warnings)};
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const unsigned material = scene_.mMeshes[i]->mMaterialIndex;
      result_.of_mesh.push_back(material < result_.images.size() ? material : no_image);
    }
    return std::move(result_);
  }

 private:
  void read(const aiMaterial& material) {
    aiColor3D found(1, 1, 1);
    const bool has_colour = material.Get(AI_MATKEY_COLOR_DIFFUSE, found) == aiReturn_SUCCESS;
    const Colour colour = has_colour ? Colour{found.r, found.g, found.b} : white;
    aiString name;
    if (material.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS) {
      try {
        result_.images.push_back(picture(name.C_Str()));
        // In OBJ files, a picture replaces the colour.
        if (is_gltf(material)) tint(result_.images.back(), colour);
        result_.has_pictures = true;
        return;
      } catch (const Error& error) {
        result_.warnings.push_back(std::string(error.what()) + "; its material has one colour instead");
      }
    }
    has_colours_ |= !(colour[0] == colour[1] && colour[1] == colour[2]);
    Image& image = result_.images.emplace_back(Image{1, 1, {}});
    for (const float value : colour)
      image.pixels.push_back(to_byte(is_gltf(material) ? srgb_from_linear(value) : value));
  }

  // Colours of glTF are linear, those of OBJ as they are shown.
  static bool is_gltf(const aiMaterial& material) {
    aiColor4D colour;
    return material.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS;
  }

  Image picture(const char* name) const {
    const aiTexture* const embedded = scene_.GetEmbeddedTexture(name);
    if (embedded == nullptr) return read_picture(name, folder_);
    if (embedded->mHeight > 0) return raw(*embedded);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(embedded->pcData);
    return decoded({bytes, embedded->mWidth}, fmt::format("the texture {}", name));
  }

  const aiScene& scene_;
  std::filesystem::path folder_;
  MaterialImages result_;
  bool has_colours_ = false;
};

}  // namespace

MaterialImages read_material_images(const aiScene& scene, const std::filesystem::path& folder) {
  return Reader(scene, folder).read();
}

}  // namespace glark::geometry
