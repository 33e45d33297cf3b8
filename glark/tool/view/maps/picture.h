// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pictures of a model's maps. The upper row is the first one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glark::tool {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> texels;  // red green blue alpha
};

struct Heights {
  int width = 0, height = 0;
  std::vector<std::uint16_t> texels;  // 65535 is the height 1
};

// Decodes PNG or JPEG. Throws std::runtime_error with the reason, without the name of the file.
Picture decode_picture(std::span<const unsigned char> file);

// Decodes a PNG of 16-bit grey. Throws as decode_picture does.
Heights decode_heights(std::span<const unsigned char> file);

}  // namespace glark::tool
