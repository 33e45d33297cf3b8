// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <glark/maps.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <string_view>

#include "glark/clients/common/fnv.h"
#include "glark/clients/maps/output/file_set.h"
#include "glark/clients/maps/output/png.h"

#include <tiny_gltf.h>

namespace glark::maps {
namespace {

constexpr double roughness = 0.8;

class ModelBuilder {
 public:
  // displacement_map: the bytes of its file.
  ModelBuilder(const Baked& baked, std::string displacement_name, std::string_view displacement_map)
      : baked_(baked),
        displacement_name_(std::move(displacement_name)),
        displacement_sum_(common::add_to_fnv(common::fnv_of_nothing, displacement_map)) {
    model_.asset.version = "2.0";
    model_.asset.generator = "glark bake";
    model_.buffers.emplace_back();
  }

  tinygltf::Model build() {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_positions();
    primitive.attributes["NORMAL"] = add_vectors(baked_.normals, 3, TINYGLTF_TYPE_VEC3);
    primitive.attributes["TANGENT"] = add_vectors(baked_.tangents, 4, TINYGLTF_TYPE_VEC4);
    primitive.attributes["TEXCOORD_0"] = add_vectors(baked_.texcoords, 2, TINYGLTF_TYPE_VEC2);
    primitive.indices = add_indices();
    primitive.material = add_material();
    model_.meshes.emplace_back().primitives.push_back(primitive);
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.mesh = 0;
    if (baked_.origin != std::array<double, 3>{}) node.translation.assign(baked_.origin.begin(), baked_.origin.end());
    model_.scenes.emplace_back().nodes = {0};
    model_.defaultScene = 0;
    return std::move(model_);
  }

 private:
  int add_view(std::string_view bytes, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);  // accessors begin at multiples of four
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes.size();
    view.target = target;
    data.insert(data.end(), bytes.begin(), bytes.end());
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  int add_accessor(int view, int type, int component, std::size_t count) {
    tinygltf::Accessor& accessor = model_.accessors.emplace_back();
    accessor.bufferView = view;
    accessor.type = type;
    accessor.componentType = component;
    accessor.count = count;
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int add_vectors(const std::vector<float>& values, std::size_t width, int type) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    return add_accessor(add_view(bytes, TINYGLTF_TARGET_ARRAY_BUFFER), type, TINYGLTF_COMPONENT_TYPE_FLOAT,
                        values.size() / width);
  }

  int add_positions() {
    const int index = add_vectors(baked_.positions, 3, TINYGLTF_TYPE_VEC3);
    std::vector<double> low(3, std::numeric_limits<double>::infinity());
    std::vector<double> high(3, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < baked_.positions.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], static_cast<double>(baked_.positions[i]));
      high[i % 3] = std::max(high[i % 3], static_cast<double>(baked_.positions[i]));
    }
    tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    accessor.minValues = low;  // glTF requires these for positions
    accessor.maxValues = high;
    return index;
  }

  int add_indices() {
    const std::string_view bytes(reinterpret_cast<const char*>(baked_.triangles.data()),
                                 baked_.triangles.size() * sizeof(std::uint32_t));
    return add_accessor(add_view(bytes, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER), TINYGLTF_TYPE_SCALAR,
                        TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, baked_.triangles.size());
  }

  int add_texture(std::string_view png, const char* name) {
    tinygltf::Image& image = model_.images.emplace_back();
    image.bufferView = add_view(png, 0);
    image.mimeType = "image/png";
    image.name = name;
    if (model_.samplers.empty()) {
      tinygltf::Sampler& sampler = model_.samplers.emplace_back();
      sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
      sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
      sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    }
    tinygltf::Texture& texture = model_.textures.emplace_back();
    texture.sampler = 0;
    texture.source = static_cast<int>(model_.images.size()) - 1;
    return static_cast<int>(model_.textures.size()) - 1;
  }

  int add_material() {
    tinygltf::Material& material = model_.materials.emplace_back();
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = roughness;
    material.normalTexture.index =
        add_texture(png_of(std::span(baked_.normal_map), baked_.width, baked_.height), "normals");
    material.pbrMetallicRoughness.baseColorTexture.index = add_texture(png_of_colours(), "colours");
    tinygltf::Value::Object displacement;
    displacement["uri"] = tinygltf::Value(displacement_name_);
    displacement["scale"] = tinygltf::Value(static_cast<double>(baked_.scale));
    displacement["bias"] = tinygltf::Value(static_cast<double>(baked_.bias));
    displacement["fnv1a64"] = tinygltf::Value(fmt::format("{:016x}", displacement_sum_));
    tinygltf::Value::Object extras;
    extras["displacement"] = tinygltf::Value(displacement);
    material.extras = tinygltf::Value(extras);
    return 0;
  }

  // Viewers that are made with VTK, as f3d, show a normal map only beside a colour map.
  std::string png_of_colours() const {
    constexpr std::array<std::uint8_t, 3> white{255, 255, 255};
    return baked_.colour_map.empty() ? png_of(std::span(white), 1, 1)
                                     : png_of(std::span(baked_.colour_map), baked_.width, baked_.height);
  }

  const Baked& baked_;
  std::string displacement_name_;
  std::uint64_t displacement_sum_;
  tinygltf::Model model_;
};

void require_size(const std::filesystem::path& file, const Baked& model) {
  constexpr double most = 4294967295.0 - 65536;  // the format counts bytes in 32 bits
  const double bytes = 4.0 * static_cast<double>(model.positions.size() + model.normals.size() + model.tangents.size() +
                                                 model.texcoords.size() + model.triangles.size()) +
                       static_cast<double>(model.normal_map.size() + model.colour_map.size());
  if (bytes > most)
    throw Error(
        Element::file, 0,
        fmt::format("{} would have more than 4 GiB, which GLB cannot hold; lower the texture memory", file.string()));
}

void write_picture(std::filesystem::path file, const char* ending, const std::vector<std::uint8_t>& map,
                   const Baked& model) {
  FileSet files;
  files.add(file.replace_extension(ending), png_of(std::span(map), model.width, model.height));
  files.commit();
}

}  // namespace

void write_model(const std::filesystem::path& file, const Baked& model) {
  require_size(file, model);
  std::filesystem::path beside = file;
  beside.replace_extension(".displacement.png");
  FileSet files;
  const std::string map = png_of(std::span(model.displacement_map), model.width, model.height);
  files.add(beside, map);
  tinygltf::Model gltf = ModelBuilder(model, beside.filename().string(), map).build();
  std::ostringstream out;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&gltf, out, false, true))
    throw Error(Element::file, 0, fmt::format("{} could not be written by tinygltf", file.string()));
  files.add(file, std::move(out).str());
  files.commit();
}

void write_pictures(const std::filesystem::path& file, const Baked& model) {
  write_picture(file, ".normals.png", model.normal_map, model);
  if (!model.colour_map.empty()) write_picture(file, ".colours.png", model.colour_map, model);
}

void write_object_normals(const std::filesystem::path& file, const Baked& model) {
  write_picture(file, ".object_normals.png", object_normals(model), model);
}

}  // namespace glark::maps
