// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "glark/clients/common/error_message.h"

namespace glark::vstree {
namespace {

const char* name_of(Element element) {
  switch (element) {
    case Element::point: return "point";
    case Element::triangle: return "triangle";
    case Element::array: return "array";
    case Element::option: break;
  }
  return "option";
}

std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element == Element::point || element == Element::triangle;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what)
    : ElementError(element, index,
                   common::error_message("glark-vstree", name_of(element), number_of(element, index), what)) {}

void check(const Options& options) {
  const auto within = [](float value, float most, const char* name) {
    if (value >= 0 && value <= most) return;
    throw Error(Element::option, 0, fmt::format("{} is {}; 0 to {} is possible", name, value, most));
  };
  within(options.threshold, 1e18F, "threshold");
  within(options.delta_a, 1, "delta_a");
  within(options.delta_d, 1, "delta_d");
}

void check_triangles(std::span<const std::uint32_t> triangles, std::size_t points) {
  if (triangles.size() % 3 != 0) {
    throw Error(Element::array, 0, fmt::format("triangles has {} indices; give three for each", triangles.size()));
  }
  // There are at most 2^31 points. So signed comparisons suffice, for which there are vector instructions.
  std::uint32_t beyond = 0;
  const auto last = static_cast<std::int32_t>(static_cast<std::int64_t>(points) - 1);
  for (const std::uint32_t index : triangles)
    beyond |= index | (static_cast<std::int32_t>(index) > last ? 0x80000000U : 0U);
  if ((beyond & 0x80000000U) == 0) return;
  const auto wrong =
      std::find_if(triangles.begin(), triangles.end(), [&](std::uint32_t index) { return index >= points; });
  throw Error(Element::triangle, static_cast<std::size_t>(wrong - triangles.begin()) / 3,
              fmt::format("has index {} of {} points; remove it, or give all points", *wrong, points));
}

}  // namespace glark::vstree
