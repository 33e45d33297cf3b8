// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Colours as files and screens have them (sRGB, IEC 61966-2-1), and linear ones, as glTF has them at vertices (2.0, section
// 3.7.2.1). From 0 to 1.
#pragma once

#include <cmath>

namespace glark::geometry {

inline float linear_from_srgb(float shown) {
  return shown <= 0.04045F ? shown / 12.92F : std::pow((shown + 0.055F) / 1.055F, 2.4F);
}
inline float srgb_from_linear(float linear) {
  return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

}  // namespace glark::geometry
