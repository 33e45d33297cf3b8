// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/output/png.h"

#include <png.h>

#include <bit>
#include <memory>
#include <new>
#include <stdexcept>

namespace glark::maps {
namespace {

void append(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

[[noreturn]] void fail(png_structp, png_const_charp what) { throw std::runtime_error(std::string("libpng: ") + what); }

std::string encode(const std::uint8_t* bytes, unsigned width, unsigned height, int depth, int colour,
                   std::size_t bytes_a_row) {
  constexpr int quick = 3;  // zlib's level; the best one takes ten times as long for a twentieth of the bytes
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = nullptr;
  const auto release = [&info](png_structp held) { png_destroy_write_struct(&held, &info); };
  const std::unique_ptr<png_struct, decltype(release)> owner(png, release);
  info = png_create_info_struct(png);
  if (info == nullptr) throw std::bad_alloc();
  png_set_write_fn(png, &out, append, nullptr);
  png_set_compression_level(png, quick);
  png_set_IHDR(png, info, width, height, depth, colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (depth == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (std::size_t row = 0; row < height; ++row) png_write_row(png, bytes + row * bytes_a_row);
  png_write_end(png, nullptr);
  return out;
}

}  // namespace

std::string png_of(std::span<const std::uint8_t> texels, unsigned width, unsigned height) {
  return encode(texels.data(), width, height, 8, PNG_COLOR_TYPE_RGB, std::size_t{3} * width);
}

std::string png_of(std::span<const std::uint16_t> texels, unsigned width, unsigned height) {
  return encode(reinterpret_cast<const std::uint8_t*>(texels.data()), width, height, 16, PNG_COLOR_TYPE_GRAY,
                std::size_t{2} * width);
}

}  // namespace glark::maps
