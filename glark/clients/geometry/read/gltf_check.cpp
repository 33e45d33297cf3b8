// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/gltf_check.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/element_at.h"

#include <tiny_gltf.h>

namespace glark::geometry {
namespace {

// The indices of a primitive. There are none in the file itself if they are compressed or sparse.
class Indices {
 public:
  Indices(const tinygltf::Model& model, const tinygltf::Accessor& accessor) : accessor_(accessor) {
    const tinygltf::BufferView* view = element_at(model.bufferViews, accessor.bufferView);
    const tinygltf::Buffer* buffer = view == nullptr ? nullptr : element_at(model.buffers, view->buffer);
    const int stride = view == nullptr ? -1 : accessor.ByteStride(*view);
    if (buffer == nullptr || stride <= 0 || accessor.sparse.isSparse || accessor.count == 0) return;
    const std::size_t first = view->byteOffset + accessor.byteOffset, size = buffer->data.size();
    const auto step = static_cast<std::size_t>(stride);
    if (first < size && accessor.count - 1 <= (size - first - 1) / step &&
        first + (accessor.count - 1) * step + width() <= size) {
      data_ = buffer->data.data() + first;
      step_ = step;
    }
  }

  // Returns 0 if the indices are not unsigned integers.
  std::size_t width() const {
    switch (accessor_.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return 4;
      default: return 0;
    }
  }

  std::size_t size() const { return data_ == nullptr ? 0 : accessor_.count; }
  std::uint32_t operator[](std::size_t i) const {
    std::uint32_t index = 0;
    std::memcpy(&index, data_ + i * step_, width());  // glTF is little-endian
    return index;
  }

 private:
  const tinygltf::Accessor& accessor_;
  const unsigned char* data_ = nullptr;
  std::size_t step_ = 0;
};

class Check {
 public:
  Check(const std::string& name, const tinygltf::Model& model) : name_(name), model_(model) {}

  void meshes() const {
    for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
      const std::vector<tinygltf::Primitive>& primitives = model_.meshes[m].primitives;
      for (std::size_t p = 0; p < primitives.size(); ++p)
        primitive(primitives[p], fmt::format("{}: glTF mesh {}, primitive {}", name_, m, p));
    }
  }

 private:
  void primitive(const tinygltf::Primitive& primitive, const std::string& place) const {
    const auto position = primitive.attributes.find("POSITION");
    const tinygltf::Accessor* points =
        position == primitive.attributes.end() ? nullptr : element_at(model_.accessors, position->second);
    if (points == nullptr) return;
    for (const auto& [attribute, index] : primitive.attributes)
      if (const tinygltf::Accessor* values = element_at(model_.accessors, index);
          values && values->count != points->count)
        throw Error(fmt::format("{}: {} {} for {} points; the file is damaged, get it again", place, values->count,
                                attribute, points->count));
    const tinygltf::Accessor* accessor = element_at(model_.accessors, primitive.indices);
    const std::size_t corners = accessor == nullptr ? points->count : accessor->count;
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES && corners % 3 != 0)
      throw Error(fmt::format("{}: {} {} are no whole triangles; the file is damaged, get it again", place, corners,
                              accessor == nullptr ? "points" : "indices"));
    if (accessor != nullptr) indices(*accessor, points->count, place);
  }

  void indices(const tinygltf::Accessor& accessor, std::size_t points, const std::string& place) const {
    const Indices indices(model_, accessor);
    if (indices.width() == 0)
      throw Error(place + ": the indices are not unsigned integers; the file is damaged, get it again");
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (indices[i] >= points)
        throw Error(fmt::format("{}: index {} is {}, but there are only {} points; the file is damaged, get it again",
                                place, i, indices[i], points));
  }

  const std::string& name_;
  const tinygltf::Model& model_;
};

bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

}  // namespace

GltfFile read_gltf(const std::string& name, std::span<const char> bytes) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(skip_image, nullptr);
  const auto model = std::make_shared<tinygltf::Model>();
  std::string error, warning;
  const std::string folder = std::filesystem::path(name).parent_path().string();
  const auto size = static_cast<unsigned>(bytes.size());
  const bool is_read =
      bytes.size() <= std::numeric_limits<unsigned>::max() &&
      (is_glb(bytes) ? reader.LoadBinaryFromMemory(model.get(), &error, &warning,
                                                   reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                     : reader.LoadASCIIFromString(model.get(), &error, &warning, bytes.data(), size, folder));
  if (!is_read) return {.model = nullptr, .fault = error.substr(0, error.find('\n'))};
  return {.model = model, .fault = {}};
}

void check_gltf(const std::string& name, const tinygltf::Model& model) { Check(name, model).meshes(); }

bool is_first_gltf(std::span<const char> bytes) {
  if (!is_glb(bytes)) {
    using Json = nlohmann::json;
    const auto only_asset = [](int depth, Json::parse_event_t event, const Json& value) {
      return depth != 1 || event != Json::parse_event_t::key || value == "asset";  // buffers can be large
    };
    const auto text = Json::parse(bytes.begin(), bytes.end(), only_asset, false);
    const Json::json_pointer version("/asset/version");
    return text.is_object() && text.contains(version) && text[version].is_string() &&
           text[version].get_ref<const std::string&>().starts_with("1.");
  }
  std::uint32_t version = 0;
  if (bytes.size() < 8) return false;
  std::memcpy(&version, bytes.data() + 4, sizeof(version));  // glTF is little-endian
  return version == 1;
}

}  // namespace glark::geometry
