// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a material uses the picture of its colour.
#pragma once

#include <array>
#include <map>
#include <string>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

struct TextureUse {
  std::string file = {};   // if it is not the one that Assimp names
  bool has_colour = true;  // the material has a colour besides, which multiplies the picture
  unsigned set = 0;        // which texture coordinates of the mesh
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  // Two rows, which make the coordinates of the picture from s, t and 1. The lower left pixel is at 0 0.
  std::array<std::array<double, 3>, 2> transform{{{1, 0, 0}, {0, 1, 0}}};

  std::array<float, 2> coordinates(float s, float t) const {
    std::array<float, 2> result{};
    for (std::size_t i = 0; i < 2; ++i)
      result[i] = static_cast<float>(transform[i][0] * static_cast<double>(s) +
                                     transform[i][1] * static_cast<double>(t) + transform[i][2]);
    return result;
  }
};

// By the number of the material in the scene. A material that is not here uses its picture as Assimp says.
using TextureUses = std::map<unsigned, TextureUse>;

}  // namespace glark::geometry
