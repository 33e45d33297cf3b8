// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "glark/clients/geometry/srgb.h"
#include "glark/clients/geometry/write/writers.h"

#include <tiny_gltf.h>

namespace glark::geometry {
namespace {

class Builder {
 public:
  explicit Builder(const Geometry& geometry) : geometry_(geometry) {
    model_.asset.version = "2.0";
    model_.asset.generator = "glark";
    model_.buffers.emplace_back();
  }

  tinygltf::Model build() {
    tinygltf::Primitive primitive;
    const bool mesh = !geometry_.triangles.empty();
    primitive.mode = mesh ? TINYGLTF_MODE_TRIANGLES : TINYGLTF_MODE_POINTS;
    primitive.attributes["POSITION"] = positions();
    if (!geometry_.normals.empty()) primitive.attributes["NORMAL"] = unit_normals();
    if (!geometry_.colours.empty()) primitive.attributes["COLOR_0"] = linear_colours();
    if (!geometry_.texture_coordinates.empty()) primitive.attributes["TEXCOORD_0"] = flipped_texture_coordinates();
    if (mesh) {
      primitive.indices = add(std::span<const std::uint32_t>(geometry_.triangles), 1, TINYGLTF_TYPE_SCALAR,
                              TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
      model_.bufferViews.back().target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    }
    model_.meshes.emplace_back().primitives.push_back(primitive);
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.mesh = 0;
    if (geometry_.origin != std::array<double, 3>{})
      node.translation.assign(geometry_.origin.begin(), geometry_.origin.end());
    model_.scenes.emplace_back().nodes = {0};
    model_.defaultScene = 0;
    return std::move(model_);
  }

 private:
  template <class Value>
  int add(std::span<const Value> values, std::size_t width, int type, int component) {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    const auto* data = reinterpret_cast<const unsigned char*>(values.data());
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = values.size_bytes();
    view.target = TINYGLTF_TARGET_ARRAY_BUFFER;
    bytes.insert(bytes.end(), data, data + values.size_bytes());  // all sizes are multiples of four
    tinygltf::Accessor& accessor = model_.accessors.emplace_back();
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.normalized = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    accessor.type = type;
    accessor.count = values.size() / width;
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int positions() {
    const int index =
        add(std::span<const float>(geometry_.positions), 3, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
    std::vector<double> low(3, std::numeric_limits<double>::infinity());
    std::vector<double> high(3, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < geometry_.positions.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], static_cast<double>(geometry_.positions[i]));
      high[i % 3] = std::max(high[i % 3], static_cast<double>(geometry_.positions[i]));
    }
    model_.accessors[static_cast<std::size_t>(index)].minValues = low;  // glTF requires these for positions
    model_.accessors[static_cast<std::size_t>(index)].maxValues = high;
    return index;
  }

  // glTF requires normals of unit length.
  int unit_normals() {
    std::vector<float> normals = geometry_.normals;
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      const float length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
      for (std::size_t k = 0; k < 3; ++k)
        normals[i + k] = length > 0 ? normals[i + k] / length : (k == 2 ? 1.0F : 0.0F);
    }
    return add(std::span<const float>(normals), 3, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
  }

  // 16 bits: dark colours need more than eight.
  int linear_colours() {
    std::vector<std::uint16_t> colours(geometry_.colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const float part = static_cast<float>(geometry_.colours[i]) / 255;
      colours[i] = static_cast<std::uint16_t>(std::lround(65535 * (i % 4 == 3 ? part : linear_from_srgb(part))));
    }
    return add(std::span<const std::uint16_t>(colours), 4, TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
  }

  // In glTF, t = 0 is the upper edge of the picture.
  int flipped_texture_coordinates() {
    std::vector<float> coordinates = geometry_.texture_coordinates;
    for (std::size_t i = 1; i < coordinates.size(); i += 2) coordinates[i] = 1 - coordinates[i];
    return add(std::span<const float>(coordinates), 2, TINYGLTF_TYPE_VEC2, TINYGLTF_COMPONENT_TYPE_FLOAT);
  }

  const Geometry& geometry_;
  tinygltf::Model model_;
};

}  // namespace

void write_glb(OutputFile& file, const Geometry& geometry, const std::string& name) {
  constexpr double most = 4294967295.0;  // the format counts bytes in 32 bits
  const double bytes = 4.0 * static_cast<double>(geometry.positions.size() + geometry.normals.size() +
                                                 geometry.texture_coordinates.size() + geometry.triangles.size()) +
                       2.0 * static_cast<double>(geometry.colours.size());
  if (bytes > most - 65536) throw Error(name + ": GLB holds at most 4 GiB; write PLY, or simplify first");
  tinygltf::Model model = Builder(geometry).build();
  tinygltf::TinyGLTF writer;
  std::ostringstream out;
  if (!writer.WriteGltfSceneToStream(&model, out, false, true))
    throw Error(name + ": tinygltf could not write GLB; write PLY");
  file.write(std::move(out).str());
}

}  // namespace glark::geometry
