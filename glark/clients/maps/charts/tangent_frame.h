// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The tangent space of a normal map, as shaders of glTF (2.0, section 3.7.2.1) and MikkTSpace make it.
#pragma once

#include <algorithm>
#include <cmath>

#include "glark/clients/common/vector.h"

namespace glark::maps {

using Vector = common::Vector3f;

struct TangentFrame {
  Vector tangent, bitangent, normal;  // of unit length; the tangent need not be perpendicular to the normal

  // From interpolated normals and tangents, of any length.
  static TangentFrame of(Vector normal, Vector tangent) {
    const Vector n = common::unit(normal), t = common::unit(tangent);
    return {t, common::unit(common::cross(n, t)), n};
  }
  Vector to_world(Vector local) const { return tangent * local.x + bitangent * local.y + normal * local.z; }
  Vector to_local(Vector n) const {
    const float skew = common::dot(normal, tangent);
    const float along_normal = common::dot(n, normal), along_tangent = common::dot(n, tangent);
    const float determinant = std::max(1 - skew * skew, 1e-6F);
    return {(along_tangent - skew * along_normal) / determinant, common::dot(n, bitangent),
            (along_normal - skew * along_tangent) / determinant};
  }
};

}  // namespace glark::maps
