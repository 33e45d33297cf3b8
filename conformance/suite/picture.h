// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace glark::conformance {

// RGBA, 8 bits a channel. Row 0 is the lowest, as in the GL.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  Picture() = default;
  Picture(int width_of, int height_of, std::array<std::uint8_t, 4> colour = {0, 0, 0, 255});

  std::array<std::uint8_t, 4> at(int x, int y) const;
  void set(int x, int y, std::array<std::uint8_t, 4> colour);
};

// Reads the bound framebuffer, from (0, 0).
Picture read_picture(int width, int height);

// How many pixels differ by more than `tolerance` in a channel. Pictures of different sizes differ everywhere.
int count_different(const Picture& a, const Picture& b, int tolerance);

// White where the pictures differ by more than `tolerance`, otherwise a darkened `a`.
Picture difference_of(const Picture& a, const Picture& b, int tolerance);

// Throws std::runtime_error that names the file. The file appears whole or not at all.
void write_png(const Picture& picture, const std::string& path);

}  // namespace glark::conformance
