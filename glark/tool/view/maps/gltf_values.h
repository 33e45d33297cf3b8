// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The numbers and the bytes of a glTF model, none from outside of its buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tiny_gltf.h>

namespace glark::tool {

// Returns the element of this index, or null if there is none.
template <class Value>
const Value* at(const std::vector<Value>& values, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < values.size() ? &values[static_cast<std::size_t>(index)]
                                                                       : nullptr;
}

// Returns `width` floats for each element of an accessor, or nothing if the accessor has another type, is sparse, has
// values that are not finite, or reaches outside of its buffer.
std::vector<float> floats_of(const tinygltf::Model& model, int accessor, std::size_t width);

// Returns the indices of an accessor, or nothing if they are not unsigned integers below `points`, or as above.
std::vector<std::uint32_t> indices_of(const tinygltf::Model& model, int accessor, std::size_t points);

// Returns the bytes of a view, or nothing if it reaches outside of its buffer.
std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view);

}  // namespace glark::tool
