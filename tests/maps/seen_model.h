// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A baked model as a shader sees it: the displaced surface, its normal and its colour at places of triangles.
#pragma once

#include <glark/maps.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glark/clients/common/vector.h"

namespace glark::maps::test {

struct Seen {
  common::Vector3d position, normal, colour;
};

class SeenModel {
 public:
  explicit SeenModel(const Baked& model) : model_(model) {}

  Seen at(std::size_t triangle, const std::array<double, 3>& weights) const {
    using Vector = common::Vector3d;
    Vector position, normal, tangent;
    std::array<double, 2> texcoord{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = model_.triangles[3 * triangle + k];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[axis] += weights[k] * static_cast<double>(model_.positions[3 * vertex + axis]);
        normal[axis] += weights[k] * static_cast<double>(model_.normals[3 * vertex + axis]);
        tangent[axis] += weights[k] * static_cast<double>(model_.tangents[4 * vertex + axis]);
      }
      for (std::size_t axis = 0; axis < 2; ++axis)
        texcoord[axis] += weights[k] * static_cast<double>(model_.texcoords[2 * vertex + axis]);
    }
    normal = common::unit(normal);
    tangent = common::unit(tangent);
    const double turn = static_cast<double>(model_.tangents[4 * std::size_t{model_.triangles[3 * triangle]} + 3]);
    const Vector bitangent = common::unit(common::cross(normal, tangent)) * turn;
    const auto map = [&](const auto& texels, std::size_t channels, std::size_t channel) {
      return filtered(texcoord, [&](std::size_t i) { return static_cast<double>(texels[channels * i + channel]); });
    };
    Seen seen;
    const double height = static_cast<double>(model_.bias) +
                          static_cast<double>(model_.scale) * map(model_.displacement_map, 1, 0) / 65535;
    seen.position = position + normal * height;
    Vector local;
    for (std::size_t k = 0; k < 3; ++k) {
      local[k] = map(model_.normal_map, 3, k) / 255 * 2 - 1;
      if (!model_.colour_map.empty()) seen.colour[k] = map(model_.colour_map, 3, k) / 255;
    }
    seen.normal = common::unit(tangent * local.x + bitangent * local.y + normal * local.z);
    return seen;
  }

 private:
  template <class Texel>
  double filtered(const std::array<double, 2>& texcoord, const Texel& texel) const {
    const double x = std::clamp(texcoord[0] * model_.width - 0.5, 0.0, model_.width - 1.001);
    const double y = std::clamp(texcoord[1] * model_.height - 0.5, 0.0, model_.height - 1.001);
    const auto i = static_cast<std::size_t>(x);
    const auto j = static_cast<std::size_t>(y);
    const double fx = x - static_cast<double>(i);
    const double fy = y - static_cast<double>(j);
    const std::size_t at = j * model_.width + i;
    return (1 - fy) * ((1 - fx) * texel(at) + fx * texel(at + 1)) +
           fy * ((1 - fx) * texel(at + model_.width) + fx * texel(at + model_.width + 1));
  }

  const Baked& model_;
};

}  // namespace glark::maps::test
