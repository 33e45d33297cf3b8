// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/suite/picture.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "conformance/gl/gl.h"

namespace glark::conformance {
namespace {

std::size_t offset_of(const Picture& picture, int x, int y) {
  return std::size_t{4} *
         (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
}

bool is_different(const Picture& a, const Picture& b, std::size_t offset, int tolerance) {
  for (std::size_t i = offset; i < offset + 4; ++i)
    if (std::abs(int{a.rgba[i]} - int{b.rgba[i]}) > tolerance) return true;
  return false;
}

}  // namespace

Picture::Picture(int width_of, int height_of, std::array<std::uint8_t, 4> colour) : width(width_of), height(height_of) {
  rgba.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = colour[i % 4];
}

std::array<std::uint8_t, 4> Picture::at(int x, int y) const {
  const std::size_t o = offset_of(*this, x, y);
  return {rgba[o], rgba[o + 1], rgba[o + 2], rgba[o + 3]};
}

void Picture::set(int x, int y, std::array<std::uint8_t, 4> colour) {
  std::copy(colour.begin(), colour.end(), rgba.begin() + static_cast<std::ptrdiff_t>(offset_of(*this, x, y)));
}

Picture read_picture(int width, int height) {
  Picture picture(width, height);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  return picture;
}

int count_different(const Picture& a, const Picture& b, int tolerance) {
  if (a.width != b.width || a.height != b.height) return std::max(a.width * a.height, b.width * b.height);
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) count += is_different(a, b, i, tolerance) ? 1 : 0;
  return count;
}

Picture difference_of(const Picture& a, const Picture& b, int tolerance) {
  Picture result = a;
  for (std::size_t i = 0; i < result.rgba.size(); i += 4) {
    const bool differs = a.rgba.size() != b.rgba.size() || is_different(a, b, i, tolerance);
    for (std::size_t j = 0; j < 3; ++j)
      result.rgba[i + j] = differs ? 255 : static_cast<std::uint8_t>(result.rgba[i + j] / 3);
    result.rgba[i + 3] = 255;
  }
  return result;
}

void write_png(const Picture& picture, const std::string& path) {
  Picture opaque = picture;
  for (std::size_t i = 3; i < opaque.rgba.size(); i += 4) opaque.rgba[i] = 255;
  const std::string unfinished = path + ".part";
  // PNG begins at the top, so this begins with the last row.
  const std::uint8_t* top = opaque.rgba.data() + offset_of(opaque, 0, opaque.height - 1);
  if (stbi_write_png(unfinished.c_str(), opaque.width, opaque.height, 4, top, -4 * opaque.width) == 0)
    throw std::runtime_error("cannot write " + unfinished);
  std::filesystem::rename(unfinished, path);
}

}  // namespace glark::conformance
