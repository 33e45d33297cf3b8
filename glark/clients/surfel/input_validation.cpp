// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/input_validation.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "glark/clients/common/error_message.h"

namespace glark::surfel {
namespace {

constexpr float greatest_coordinate = 1e18F;

const char* name_of(Element element) {
  switch (element) {
    case Element::point: return "point";
    case Element::normal: return "normal";
    case Element::option: return "option";
    case Element::view: return "view";
    case Element::cloud: break;
  }
  return "cloud";
}

// Only messages about points and normals name a number.
std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element == Element::point || element == Element::normal;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

void check_range(const char* name, float value, float low, float high) {
  if (value >= low && value <= high) return;
  throw Error(Element::option, 0, fmt::format("{} is {}; it must be from {} to {}", name, value, low, high));
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what)
    : ElementError(element, index,
                   common::error_message("glark-surfel", name_of(element), number_of(element, index), what)) {}

void check_options(const Options& options) {
  check_range("leaf_points", static_cast<float>(options.leaf_points), 8, 1024);
  check_range("delta_a", options.delta_a, 0, 1);
  check_range("delta_d", options.delta_d, 0, 1);
  check_range("inflation", options.inflation, 0.5F, 8);
  check_range("reach", options.reach, 1, 100);
  check_range("levels", static_cast<float>(options.levels), 1, 16);
}

void check_array_sizes(const Cloud& cloud) {
  const std::size_t coordinates = cloud.positions.size(), points = coordinates / 3;
  if (coordinates % 3 != 0) {
    throw Error(Element::cloud, 0, fmt::format("has {} coordinates; give three, x y z, for each point", coordinates));
  }
  if (points >= none) {
    throw Error(Element::cloud, 0,
                fmt::format("has {} points; indices have 32 bits: split it into clouds of less than {}", points, none));
  }
  if (!cloud.normals.empty() && cloud.normals.size() != coordinates) {
    throw Error(Element::cloud, 0,
                fmt::format("has {} coordinates of normals for {} points; give three for each point, or no normals",
                            cloud.normals.size(), points));
  }
}

void check_point(const Cloud& cloud, std::size_t point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const float position = cloud.positions[3 * point + k];
    if (!(std::fabs(position) <= greatest_coordinate)) {
      throw Error(Element::point, point,
                  fmt::format("has the {} coordinate {}; it must be finite and at most 1e18: leave the point out, or "
                              "scale the cloud",
                              "xyz"[k], position));
    }
    if (!cloud.normals.empty() && !std::isfinite(cloud.normals[3 * point + k])) {
      throw Error(Element::normal, point,
                  fmt::format("has the {} coordinate {}; it must be finite: give 0 0 0 if the normal is not known",
                              "xyz"[k], cloud.normals[3 * point + k]));
    }
  }
}

void check_update(const Cloud& cloud, std::span<const std::uint32_t> moved, std::size_t had_points, bool had_normals) {
  check_array_sizes(cloud);
  const std::size_t points = cloud.positions.size() / 3;
  if (points < had_points || (had_points > 0 && cloud.normals.empty() == had_normals)) {
    throw Error(
        Element::cloud, 0,
        fmt::format("has {} points {} normals; before, it had {} points {} normals. Updates cannot remove "
                    "points, nor add or remove normals: make new strips",
                    points, cloud.normals.empty() ? "without" : "with", had_points, had_normals ? "with" : "without"));
  }
  for (const std::uint32_t point : moved) {
    if (point < points) continue;
    throw Error(Element::point, point, fmt::format("has moved, but there are {} points: name one of these", points));
  }
}

void check_level(unsigned level, unsigned level_count) {
  if (level < level_count) return;
  throw Error(Element::option, level,
              fmt::format("level is {}; there are {}: ask for more by Options::levels", level, level_count));
}

void check_view(const View& view) {
  if (view.width == 0 || view.height == 0) {
    throw Error(
        Element::view, 0,
        fmt::format("has {} x {} pixels; set width and height to those of the viewport", view.width, view.height));
  }
  const auto check_pixels = [](const char* name, float pixels) {
    if (pixels >= 0) return;
    throw Error(Element::view, 0, fmt::format("has {} of {}; it must be 0 or more", name, pixels));
  };
  check_pixels("point_pixels", view.point_pixels);
  check_pixels("level_pixels", view.level_pixels);
  for (std::size_t i = 0; i < 16; ++i) {
    if (std::isfinite(view.clip_from_object[i])) continue;
    throw Error(Element::view, 0,
                fmt::format("has a matrix whose element {} is {}; it must be finite", i, view.clip_from_object[i]));
  }
}

}  // namespace glark::surfel
