// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/picture.h"

#include <algorithm>
#include <cmath>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_ONLY_TGA
#include <stb/stb_image.h>

namespace glark::edit {

Picture::Picture(const std::string& file) {
  int channels = 0;
  stbi_uc* pixels = stbi_load(file.c_str(), &width_, &height_, &channels, 3);
  if (pixels == nullptr)
    throw Error(Element::file, 0,
                file + ": cannot be read as a picture (" + stbi_failure_reason() + "); use a PNG or JPEG file");
  pixels_.assign(pixels,
                 pixels + std::size_t{3} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  stbi_image_free(pixels);
}

Colour Picture::at(double x, double y) const {
  // The centre of the first pixel is at 0.5 0.5. Beyond the outer centres, their colours go on.
  const double column = std::clamp(x - 0.5, 0.0, width_ - 1.0), row = std::clamp(y - 0.5, 0.0, height_ - 1.0);
  const auto left = static_cast<std::size_t>(column), top = static_cast<std::size_t>(row);
  const std::size_t right = std::min(left + 1, static_cast<std::size_t>(width_) - 1);
  const std::size_t bottom = std::min(top + 1, static_cast<std::size_t>(height_) - 1);
  const double u = column - static_cast<double>(left), v = row - static_cast<double>(top);
  const auto pixel = [&](std::size_t i, std::size_t j, std::size_t k) {
    return static_cast<double>(pixels_[3 * (j * static_cast<std::size_t>(width_) + i) + k]);
  };
  Colour colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double upper = (1 - u) * pixel(left, top, k) + u * pixel(right, top, k);
    const double lower = (1 - u) * pixel(left, bottom, k) + u * pixel(right, bottom, k);
    colour[k] = static_cast<std::uint8_t>(std::lround((1 - v) * upper + v * lower));
  }
  return colour;
}

}  // namespace glark::edit
