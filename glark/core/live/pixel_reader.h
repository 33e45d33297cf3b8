// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "glark/core/state/environment.h"

namespace glark::core {

// A pixel's colour and depth. Two of them differ if a draw between them changed the pixel.
struct PixelValue {
  std::array<unsigned char, 4> color{};
  float depth = 0;
  bool operator==(const PixelValue&) const = default;
};

// Reads the pixel from the framebuffer that draws write to. No state and no error is left behind. A framebuffer that
// cannot be read gives the same value each time.
PixelValue read_pixel(const Environment& environment, const std::array<int, 2>& pixel);

}  // namespace glark::core
