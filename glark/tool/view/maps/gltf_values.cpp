// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/maps/gltf_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace glark::tool {
namespace {

// The elements of an accessor in its buffer, `size` bytes each.
struct Elements {
  const unsigned char* first = nullptr;
  std::size_t count = 0, step = 0;
};

Elements elements_of(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t size) {
  const tinygltf::BufferView* view = at(model.bufferViews, accessor.bufferView);
  const std::span<const unsigned char> bytes = bytes_of(model, accessor.bufferView);
  if (view == nullptr || accessor.sparse.isSparse || accessor.count == 0) return {};
  const int stride = accessor.ByteStride(*view);
  if (stride < static_cast<int>(size) || accessor.byteOffset > bytes.size()) return {};
  const std::span<const unsigned char> own = bytes.subspan(accessor.byteOffset);
  const auto step = static_cast<std::size_t>(stride);
  if (own.size() < size || accessor.count - 1 > (own.size() - size) / step) return {};
  return {own.data(), accessor.count, step};
}

std::size_t width_of_index(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return 4;
    default: return 0;
  }
}

}  // namespace

std::vector<float> floats_of(const tinygltf::Model& model, int accessor, std::size_t width) {
  const tinygltf::Accessor* source = at(model.accessors, accessor);
  if (source == nullptr || source->componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source->type)) != static_cast<int>(width))
    return {};
  const Elements elements = elements_of(model, *source, width * sizeof(float));
  std::vector<float> values(width * elements.count);
  for (std::size_t i = 0; i < elements.count; ++i)  // glTF is little-endian
    std::memcpy(&values[width * i], elements.first + i * elements.step, width * sizeof(float));
  if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); })) return {};
  return values;
}

std::vector<std::uint32_t> indices_of(const tinygltf::Model& model, int accessor, std::size_t points) {
  const tinygltf::Accessor* source = at(model.accessors, accessor);
  const std::size_t width = source == nullptr ? 0 : width_of_index(source->componentType);
  if (width == 0 || source->type != TINYGLTF_TYPE_SCALAR) return {};
  const Elements elements = elements_of(model, *source, width);
  std::vector<std::uint32_t> indices(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) std::memcpy(&indices[i], elements.first + i * elements.step, width);
  if (!std::all_of(indices.begin(), indices.end(), [=](std::uint32_t index) { return index < points; })) return {};
  return indices;
}

std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view) {
  const tinygltf::BufferView* source = at(model.bufferViews, view);
  const tinygltf::Buffer* buffer = source == nullptr ? nullptr : at(model.buffers, source->buffer);
  if (buffer == nullptr || source->byteOffset > buffer->data.size() ||
      source->byteLength > buffer->data.size() - source->byteOffset)
    return {};
  return {buffer->data.data() + source->byteOffset, source->byteLength};
}

}  // namespace glark::tool
