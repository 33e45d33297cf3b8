// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/validation.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <optional>

#include "glark/clients/common/error_message.h"

namespace glark::maps {
namespace {

const char* name_of(Element element) {
  switch (element) {
    case Element::point: return "point";
    case Element::triangle: return "triangle";
    case Element::array: return "array:";
    case Element::file: return "file";
    case Element::option: break;
  }
  return "the option";
}

std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element == Element::point || element == Element::triangle;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what)
    : ElementError(element, index,
                   common::error_message("glark-maps", name_of(element), number_of(element, index), what)) {}

void check(const BakeOptions& options) {
  constexpr std::size_t least_memory = std::size_t{1} << 20;
  constexpr unsigned least_side = 64, most_side = 32768;
  constexpr double most_texels = 64;
  if (options.texture_memory < least_memory)
    throw Error(
        Element::option, 0,
        fmt::format("texture_memory is {} bytes; {} or more is possible", options.texture_memory, least_memory));
  if (options.most_side < least_side || options.most_side > most_side)
    throw Error(Element::option, 0,
                fmt::format("most_side is {}; {} to {} is possible", options.most_side, least_side, most_side));
  if (options.texcoords > Texcoords::charts)
    throw Error(Element::option, 0,
                fmt::format("texcoords is {}; 0 to 2 are possible", static_cast<unsigned>(options.texcoords)));
  const bool has_size = options.width > 0 || options.height > 0;
  for (const unsigned side : {options.width, options.height})
    if (has_size && (!std::has_single_bit(side) || side < least_side || side > most_side))
      throw Error(Element::option, 0,
                  fmt::format("width, height is {} x {}; 0 x 0 or powers of two from {} to {} are possible",
                              options.width, options.height, least_side, most_side));
  if (!(options.texels_per_point > 0 && options.texels_per_point <= most_texels))
    throw Error(
        Element::option, 0,
        fmt::format("texels_per_point is {}; above 0 to {} is possible", options.texels_per_point, most_texels));
  if (!(options.noise >= 0) || !std::isfinite(options.noise))
    throw Error(Element::option, 0, fmt::format("noise is {}; 0 or a length is possible", options.noise));
  if (!(options.reach >= 0) || !std::isfinite(options.reach))
    throw Error(Element::option, 0, fmt::format("reach is {}; 0 or a length is possible", options.reach));
}

}  // namespace glark::maps
