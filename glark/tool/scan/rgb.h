// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Conversions of colours, because the libraries take colours without alpha.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "glark/tool/scan/console.h"

namespace glark::tool {

inline std::vector<std::uint8_t> rgb_of(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    rgb.insert(rgb.end(), rgba.begin() + static_cast<std::ptrdiff_t>(i),
               rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  return rgb;
}

inline void warn_of_alpha(const std::vector<std::uint8_t>& rgba, const std::string& file) {
  for (std::size_t i = 3; i < rgba.size(); i += 4) {
    if (rgba[i] == 255) continue;
    warn(fmt::format("{}: point {} is not opaque; the result has no alpha", file, i / 4));
    return;
  }
}

inline std::vector<std::uint8_t> rgba_of(const std::vector<std::uint8_t>& rgb) {
  constexpr std::uint8_t opaque = 255;
  std::vector<std::uint8_t> rgba;
  rgba.reserve(rgb.size() / 3 * 4);
  for (std::size_t i = 0; i < rgb.size(); i += 3) rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], opaque});
  return rgba;
}

}  // namespace glark::tool
