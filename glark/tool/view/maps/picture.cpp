// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/maps/picture.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <string>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace glark::tool {
namespace {

constexpr int largest_map_side = 32768;

struct Header {
  int width = 0, height = 0, channels = 0;
};

[[noreturn]] void fail() {
  const char* reason = stbi_failure_reason();
  throw std::runtime_error(fmt::format("it cannot be decoded ({})", reason == nullptr ? "no reason known" : reason));
}

int size_for_stb(std::span<const unsigned char> file) {
  if (file.empty()) throw std::runtime_error("it is empty");
  if (file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::runtime_error("it is larger than 2 GiB");
  return static_cast<int>(file.size());
}

Header header_of(std::span<const unsigned char> file) {
  Header header;
  const int size = size_for_stb(file);
  if (stbi_info_from_memory(file.data(), size, &header.width, &header.height, &header.channels) == 0) fail();
  if (header.width > largest_map_side || header.height > largest_map_side)
    throw std::runtime_error(fmt::format("it has {} x {} texels, and {} a side are the most", header.width,
                                         header.height, largest_map_side));
  return header;
}

// Copies what stb decoded, and frees it.
template <class Value>
std::vector<Value> take(Value* texels, const Header& header, std::size_t channels) {
  if (texels == nullptr) fail();
  std::vector<Value> copy(
      texels, texels + channels * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height));
  stbi_image_free(texels);
  return copy;
}

}  // namespace

Picture decode_picture(std::span<const unsigned char> file) {
  Header header = header_of(file);
  constexpr int channels = 4;
  stbi_uc* texels =
      stbi_load_from_memory(file.data(), size_for_stb(file), &header.width, &header.height, &header.channels, channels);
  return {header.width, header.height, take(texels, header, channels)};
}

Heights decode_heights(std::span<const unsigned char> file) {
  Header header = header_of(file);
  const int size = size_for_stb(file);
  const int bits = stbi_is_16_bit_from_memory(file.data(), size) != 0 ? 16 : 8;
  if (bits != 16 || header.channels != 1)
    throw std::runtime_error(fmt::format("it has {} channel{} of {} bits, and heights have one of 16 bits (grey)",
                                         header.channels, header.channels == 1 ? "" : "s", bits));
  stbi_us* texels = stbi_load_16_from_memory(file.data(), size, &header.width, &header.height, &header.channels, 1);
  return {header.width, header.height, take(texels, header, 1)};
}

}  // namespace glark::tool
