// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/simplified.h"

#include <utility>

#include "glark/tool/scan/rgb.h"

namespace glark::tool {

Coarse simplified(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options) {
  const std::vector<std::uint8_t> colours = rgb_of(geometry.colours);
  vstree::Simplified result = vstree::simplify(
      {{geometry.positions, geometry.normals, colours, geometry.texture_coordinates}, geometry.triangles}, options);
  geometry::Geometry coarse;
  coarse.origin = geometry.origin;
  coarse.positions = std::move(result.positions);
  coarse.normals = std::move(result.normals);
  coarse.colours = rgba_of(result.colours);
  coarse.texture_coordinates = std::move(result.texcoords);
  coarse.triangles = std::move(result.triangles);
  return {std::move(coarse), result.method, result.error, {}};
}

}  // namespace glark::tool
