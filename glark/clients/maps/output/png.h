// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace glark::maps {

// The bytes of a PNG file with red, green and blue. texels: [3 * width * height], the highest row first.
std::string png_of(std::span<const std::uint8_t> texels, unsigned width, unsigned height);
// The same with 16 bits of grey. texels: [width * height].
std::string png_of(std::span<const std::uint16_t> texels, unsigned width, unsigned height);

}  // namespace glark::maps
