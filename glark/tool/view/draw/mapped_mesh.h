// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws a mesh with its maps: a normal map and colours in a fragment shader, and a displacement map by OpenGL itself
// (GL_DISPLACEMENT_UNIT_ARK).
#pragma once

#include <cstdint>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/view/draw/draw_settings.h"
#include "glark/tool/view/maps/mapped_model.h"

namespace glark::tool {

class MappedMesh {
 public:
  // An OpenGL context must be current during the object's lifetime. Maps that OpenGL cannot hold are left out, with a
  // warning. Throws std::runtime_error if the shaders do not build.
  MappedMesh(const geometry::Geometry& geometry, const Maps& maps);
  ~MappedMesh();
  MappedMesh(const MappedMesh&) = delete;
  MappedMesh& operator=(const MappedMesh&) = delete;

  // The most that these maps can show.
  MapsShown most() const;
  // How far the displaced surface is from the mesh, at most.
  float greatest_displacement() const;
  // Draws with the current matrices and lights. Returns the number of refined triangles. `shown` must not be plain.
  std::size_t draw(MapsShown shown, const DrawSettings& settings) const;

 private:
  void upload(const geometry::Geometry& geometry, const Maps& maps);
  void bind() const;
  void unbind() const;
  void displace(const DrawSettings& settings) const;

  std::uint32_t program_ = 0;
  std::uint32_t points_ = 0, triangles_ = 0;               // buffers
  std::uint32_t colours_ = 0, normals_ = 0, heights_ = 0;  // textures; 0: none
  float scale_ = 1, bias_ = 0;
  std::size_t point_count_ = 0, index_count_ = 0;
};

}  // namespace glark::tool
