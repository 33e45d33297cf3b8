// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/maps/mapped_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "glark/clients/common/fnv.h"
#include "glark/tool/view/maps/gltf_values.h"

namespace glark::tool {
namespace {

// An image of the file's buffers stays there until it is decoded. The others are kept as they are.
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

std::optional<tinygltf::Model> parse(const std::string& file) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  char magic[4] = "";
  std::ifstream(file, std::ios::binary).read(magic, sizeof(magic));
  const bool is_binary = std::string_view(magic, sizeof(magic)) == "glTF";
  if (is_binary ? reader.LoadBinaryFromFile(&model, &error, &warning, file)
                : reader.LoadASCIIFromFile(&model, &error, &warning, file))
    return model;
  return std::nullopt;
}

bool has_maps(const tinygltf::Material& material) {
  return material.normalTexture.index >= 0 || material.pbrMetallicRoughness.baseColorTexture.index >= 0 ||
         material.extras.Has("displacement");
}

// `glark bake` writes such a picture if the scan has no colours.
bool is_one_white_texel(const Picture& picture) {
  return picture.texels.size() == 4 &&
         std::all_of(picture.texels.begin(), picture.texels.end(), [](std::uint8_t value) { return value == 255; });
}

class Reader {
 public:
  Reader(const std::string& file, const tinygltf::Model& model) : file_(file), model_(model) {}

  MapsReading read() {
    try {
      reading_.model = mapped_model();
    } catch (const std::exception& error) {
      warn(std::string(error.what()) + "; it is drawn without maps");
    }
    return std::move(reading_);
  }

 private:
  // Throws std::runtime_error if the maps cannot be laid on the mesh.
  std::optional<MappedModel> mapped_model() {
    const tinygltf::Primitive& primitive = only_primitive();
    const tinygltf::Material* material = at(model_.materials, primitive.material);
    if (material == nullptr || !has_maps(*material)) return std::nullopt;
    MappedModel result;
    result.geometry.origin = translation();
    result.geometry.positions = needed(primitive, "POSITION", 3);
    result.geometry.normals = needed(primitive, "NORMAL", 3);
    result.maps.texture_coordinates = needed(primitive, "TEXCOORD_0", 2);
    const std::size_t points = result.geometry.point_count();
    if (result.geometry.normals.size() != 3 * points || result.maps.texture_coordinates.size() != 2 * points)
      throw std::runtime_error("its attributes have different lengths; write it again");
    result.geometry.triangles = indices_of(model_, primitive.indices, points);
    if (result.geometry.triangles.empty() || result.geometry.triangles.size() % 3 != 0)
      throw std::runtime_error("its indices are no triangles of its points; write it again");
    result.maps.file = file_;
    read_pictures(primitive, *material, result.maps, points);
    if (result.maps.empty()) return std::nullopt;
    return result;
  }

  const tinygltf::Primitive& only_primitive() const {
    std::size_t primitives = 0;
    for (const tinygltf::Mesh& mesh : model_.meshes) primitives += mesh.primitives.size();
    if (primitives != 1 || model_.meshes.size() != 1)
      throw std::runtime_error(
          fmt::format("it has maps and {} primitives, and maps need one mesh with one; join them", primitives));
    if (model_.meshes[0].primitives[0].mode != TINYGLTF_MODE_TRIANGLES)
      throw std::runtime_error("its primitive has maps and is no list of triangles; export triangles");
    return model_.meshes[0].primitives[0];
  }

  std::array<double, 3> translation() const {
    std::array<double, 3> origin{};
    std::size_t uses = 0;
    for (const tinygltf::Node& node : model_.nodes) {
      if (!node.matrix.empty() || !node.rotation.empty() || !node.scale.empty() || !node.children.empty())
        throw std::runtime_error("its nodes turn, scale or have children; apply the transforms to the mesh");
      if (node.mesh != 0) continue;
      ++uses;
      if (node.translation.size() == 3) std::copy_n(node.translation.begin(), 3, origin.begin());
    }
    if (uses != 1) throw std::runtime_error(fmt::format("{} nodes show its mesh, and maps need one; join them", uses));
    return origin;
  }

  std::vector<float> needed(const tinygltf::Primitive& primitive, const char* attribute, std::size_t width) const {
    const auto found = primitive.attributes.find(attribute);
    if (found == primitive.attributes.end())
      throw std::runtime_error(fmt::format("it has maps and no {}; export it, or bake again", attribute));
    std::vector<float> values = floats_of(model_, found->second, width);
    if (values.empty())
      throw std::runtime_error(
          fmt::format("its {} is not {} finite floats for each point; export it so, or bake again", attribute, width));
    return values;
  }

  void read_pictures(const tinygltf::Primitive& primitive, const tinygltf::Material& material, Maps& maps,
                     std::size_t points) {
    maps.colours = picture_of(material.pbrMetallicRoughness.baseColorTexture.index, "baseColorTexture");
    if (maps.colours && is_one_white_texel(*maps.colours)) maps.colours.reset();
    if (material.normalTexture.index >= 0) read_normal_map(primitive, material, maps, points);
    if (material.extras.Has("displacement")) read_displacement(material.extras.Get("displacement"), maps);
  }

  void read_normal_map(const tinygltf::Primitive& primitive, const tinygltf::Material& material, Maps& maps,
                       std::size_t points) {
    maps.normals = picture_of(material.normalTexture.index, "normalTexture");
    const auto found = primitive.attributes.find("TANGENT");
    if (found != primitive.attributes.end()) maps.tangents = floats_of(model_, found->second, 4);
    if (maps.tangents.size() == 4 * points) return;
    warn(std::string("normalTexture: it needs a TANGENT of four finite floats for each point, and the mesh has ") +
         (found == primitive.attributes.end() ? "none" : "others") +
         "; the normal map is left out, export tangents or bake again");
    maps.tangents.clear();
    normals_size_ = maps.normals ? std::optional(std::pair(maps.normals->width, maps.normals->height)) : std::nullopt;
    maps.normals.reset();
  }

  std::optional<Picture> picture_of(int texture_index, const char* name) {
    if (texture_index < 0) return std::nullopt;
    const tinygltf::Texture* texture = at(model_.textures, texture_index);
    const tinygltf::Image* image = texture == nullptr ? nullptr : at(model_.images, texture->source);
    try {
      if (image == nullptr) throw std::runtime_error(fmt::format("there is no image for texture {}", texture_index));
      return decode_picture(image->bufferView >= 0 ? bytes_of(model_, image->bufferView)
                                                   : std::span<const unsigned char>(image->image));
    } catch (const std::runtime_error& error) {
      warn(fmt::format("{}: {}; the texture is left out, write it as PNG or JPEG", name, error.what()));
      return std::nullopt;
    }
  }

  void read_displacement(const tinygltf::Value& extras, Maps& maps) {
    try {
      maps.displacement = displacement_of(extras, maps);
    } catch (const std::runtime_error& error) {
      warn(fmt::format("{}; the displacement is left out", error.what()));
    }
  }

  Displacement displacement_of(const tinygltf::Value& extras, const Maps& maps) const {
    if (!extras.IsObject() || !extras.Has("uri") || !extras.Get("uri").IsString())
      throw std::runtime_error("extras.displacement: uri is no text; write the name of the PNG file");
    Displacement displacement;
    displacement.scale = number_of(extras, "scale");
    displacement.bias = number_of(extras, "bias");
    const std::string& uri = extras.Get("uri").Get<std::string>();
    try {
      const std::vector<unsigned char> bytes = bytes_beside(uri);
      require_own(extras, bytes);
      displacement.heights = decode_heights(bytes);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(
          fmt::format("{}: {}; put the file that glark bake wrote beside the model", uri, error.what()));
    }
    const Heights& heights = displacement.heights;
    auto size = normals_size_;
    if (maps.normals) size = {maps.normals->width, maps.normals->height};
    if (size && *size != std::pair(heights.width, heights.height))
      throw std::runtime_error(
          fmt::format("{}: it has {} x {} texels and the normal map {} x {}, so it belongs to another model; bake both "
                      "together",
                      uri, heights.width, heights.height, size->first, size->second));
    return displacement;
  }

  // Models of earlier versions have no checksum.
  static void require_own(const tinygltf::Value& extras, std::span<const unsigned char> bytes) {
    if (!extras.Has("fnv1a64") || !extras.Get("fnv1a64").IsString()) return;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string sum = fmt::format("{:016x}", common::add_to_fnv(common::fnv_of_nothing, text));
    if (extras.Get("fnv1a64").Get<std::string>() != sum)
      throw std::runtime_error("it is not the file that was baked with this model");
  }

  static float number_of(const tinygltf::Value& extras, const char* name) {
    const bool is_number = extras.Has(name) && extras.Get(name).IsNumber();
    const auto number = is_number ? static_cast<float>(extras.Get(name).GetNumberAsDouble()) : 0.0F;
    if (!is_number || !std::isfinite(number))
      throw std::runtime_error(
          fmt::format("extras.displacement: {} is no number that a float can hold; write a length", name));
    return number;
  }

  std::vector<unsigned char> bytes_beside(const std::string& uri) const {
    const std::filesystem::path path = std::filesystem::path(file_).parent_path() / uri;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
      throw std::runtime_error(error || !std::filesystem::exists(path, error) ? "there is no such file"
                                                                              : "it is no regular file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw std::runtime_error("it cannot be read");
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  void warn(const std::string& text) { reading_.warnings.push_back(file_ + ": " + text); }

  const std::string& file_;
  const tinygltf::Model& model_;
  MapsReading reading_;
  std::optional<std::pair<int, int>> normals_size_;  // of a normal map that is left out
};

}  // namespace

MapsReading read_maps(const std::string& file) {
  const std::optional<tinygltf::Model> model = parse(file);
  if (!model || std::none_of(model->materials.begin(), model->materials.end(), has_maps)) return {};
  return Reader(file, *model).read();
}

}  // namespace glark::tool
