// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/qas/frame.h"

#include <fmt/format.h>

#include <glark/qas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace glark::qas {
namespace {

constexpr float greatest_coordinate = 1e37F;
constexpr float barycentric_tolerance = 1e-3F;

[[noreturn]] void complain(std::span<const float> positions) {
  const auto wrong =
      std::find_if(positions.begin(), positions.end(), [](float x) { return !(std::fabs(x) <= greatest_coordinate); });
  const auto index = static_cast<std::size_t>(wrong - positions.begin());
  throw Error(Element::vertex, index / 3,
              fmt::format("has the {} coordinate {}; it has to be finite and at most 1e37", "xyz"[index % 3], *wrong));
}

// Returns the greatest magnitude, or infinity if a value is NaN or too large. The four lanes stay in one register.
float greatest_of(std::span<const float> values) {
  std::array<float, 4> greatest{};
  bool numbers = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = std::fabs(values[i]);
    numbers = numbers && value <= greatest_coordinate;
    greatest[i % 4] = std::max(greatest[i % 4], value);
  }
  return numbers ? *std::max_element(greatest.begin(), greatest.end()) : std::numeric_limits<float>::infinity();
}

}  // namespace

Scaled take_positions(std::span<const float> positions, std::vector<Float4>& to) {
  if (positions.size() != 3 * to.size()) {
    throw Error(
        Element::array, 0,
        fmt::format("of positions has {} values; {} vertices take {}", positions.size(), to.size(), 3 * to.size()));
  }
  const float greatest = greatest_of(positions);
  if (!(greatest <= greatest_coordinate)) complain(positions);
  int exponent = 0;
  if (greatest > 0) std::frexp(greatest, &exponent);
  exponent = std::clamp(exponent, -120, 124);
  const Scaled scaled{std::ldexp(1.0F, -exponent), std::ldexp(1.0F, exponent)};
  for (std::size_t v = 0; v < to.size(); ++v) {
    to[v] = Float4{positions[3 * v], positions[3 * v + 1], positions[3 * v + 2], 0} * scaled.scale;
  }
  return scaled;
}

void check_barycentric(const std::array<float, 3>& barycentric) {
  const auto [w, u, v] = barycentric;
  const bool inside =
      std::min({w, u, v}) >= -barycentric_tolerance && std::fabs(w + u + v - 1) <= barycentric_tolerance;
  if (std::isfinite(w + u + v) && inside) return;
  throw Error(Element::array, 0,
              fmt::format("of barycentric coordinates ({}, {}, {}) is not of a point of the triangle: 0 to 1, of sum 1",
                          w, u, v));
}

}  // namespace glark::qas
