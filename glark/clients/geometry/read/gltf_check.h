// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds faults of glTF files that Assimp passes over in silence: it drops triangles whose indices are not points.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace glark::geometry {

// Throws Error if an index of a mesh is no point, if the indices are no whole triangles, or if the attributes have
// different lengths. Returns a warning if the file cannot be checked, or an empty text.
std::string check_gltf(const std::string& name, std::span<const char> bytes);

// Returns whether the bytes are a GLB file, which is binary.
inline bool is_glb(std::span<const char> bytes) {
  return std::string_view(bytes.data(), bytes.size()).starts_with("glTF");
}

}  // namespace glark::geometry
