// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/input_validation.h"

#include <algorithm>
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

// Messages name the number of a point or normal.
std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element == Element::point || element == Element::normal;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

void check_range(const char* name, float value, float low, float high) {
  if (value >= low && value <= high) return;
  throw Error(Element::option, 0,
              std::string(name) + " is " + std::to_string(value) + "; it must be from " + std::to_string(low) + " to " +
                  std::to_string(high));
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
  if (cloud.positions.size() % 3 != 0) {
    throw Error(Element::cloud, 0,
                "has " + std::to_string(cloud.positions.size()) + " coordinates; give three, x y z, for each point");
  }
  if (cloud.positions.size() / 3 >= none) {
    throw Error(Element::cloud, 0,
                "has " + std::to_string(cloud.positions.size() / 3) +
                    " points; indices have 32 bits: split it into clouds of less than 4294967295");
  }
  if (!cloud.normals.empty() && cloud.normals.size() != cloud.positions.size()) {
    throw Error(Element::cloud, 0,
                "has " + std::to_string(cloud.normals.size()) + " coordinates of normals for " +
                    std::to_string(cloud.positions.size() / 3) + " points; give three for each point, or no normals");
  }
}

void check_point(const Cloud& cloud, std::size_t point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const float value = cloud.positions[3 * point + k];
    if (!(std::fabs(value) <= greatest_coordinate)) {
      throw Error(Element::point, point,
                  std::string("has the ") + "xyz"[k] + " coordinate " + std::to_string(value) +
                      "; it must be finite and at most 1e18: leave the point out, or scale the cloud");
    }
    if (!cloud.normals.empty() && !std::isfinite(cloud.normals[3 * point + k])) {
      throw Error(Element::normal, point,
                  std::string("has the ") + "xyz"[k] + " coordinate " + std::to_string(cloud.normals[3 * point + k]) +
                      "; it must be finite: 0 0 0 where it is not known");
    }
  }
}

}  // namespace glark::surfel
