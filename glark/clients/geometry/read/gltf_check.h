// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds faults of glTF files that Assimp passes over in silence: it drops triangles whose indices are not points.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tinygltf {
class Model;
}

namespace glark::geometry {

struct GltfFile {
  std::shared_ptr<const tinygltf::Model> model;  // without pictures; null if it cannot be read
  std::string fault;                             // why
};

GltfFile read_gltf(const std::string& name, std::span<const char> bytes);

// Throws Error if an index of a mesh is no point, if the indices are no whole triangles, or if the attributes have
// different lengths.
void check_gltf(const std::string& name, const tinygltf::Model& model);

// Returns whether the bytes are a GLB file, which is binary.
inline bool is_glb(std::span<const char> bytes) {
  return std::string_view(bytes.data(), bytes.size()).starts_with("glTF");
}

// Returns whether the bytes are a file of glTF 1.0, as text or GLB.
bool is_first_gltf(std::span<const char> bytes);

}  // namespace glark::geometry
