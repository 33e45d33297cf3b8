// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/points/point_set.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <mutex>

namespace glark::common {
namespace {

constexpr float largest = 1e18F;  // squares of larger numbers leave the range of floats
constexpr std::size_t grain = 1 << 16;

void check_size(std::size_t points, std::size_t size, std::size_t each, const char* name) {
  if (size == 0 || size == points * each) return;
  throw vstree::Error(
      vstree::Element::array, 0,
      fmt::format("{} has {} elements for {} points; give {} a point, or none", name, size, points, each));
}

bool all_within(std::span<const float> numbers, float limit) {
  Int4 sound[4] = {~Int4{}, ~Int4{}, ~Int4{}, ~Int4{}};
  const Float4 low = Float4{} - limit, high = Float4{} + limit;
  std::size_t i = 0;
  for (; i + 16 <= numbers.size(); i += 16) {
    Float4 some[4];
    std::memcpy(some, &numbers[i], sizeof(some));
    for (int k = 0; k < 4; ++k) sound[k] &= (some[k] >= low) & (some[k] <= high);
  }
  const Int4 all = sound[0] & sound[1] & sound[2] & sound[3];
  bool result = (all[0] & all[1] & all[2] & all[3]) != 0;
  for (; i < numbers.size(); ++i) result &= std::abs(numbers[i]) <= limit;
  return result;
}

// Returns the first element of `numbers` beyond the limit, or numbers.size(). NaN counts as beyond.
std::size_t first_beyond(std::span<const float> numbers, float limit, const Workers& workers) {
  std::size_t first = numbers.size();
  std::mutex mutex;
  workers.each(numbers.size(), 4 * grain, [&](std::size_t begin, std::size_t end) {
    if (all_within(numbers.subspan(begin, end - begin), limit)) return;
    while (std::abs(numbers[begin]) <= limit) ++begin;
    const std::lock_guard lock(mutex);
    first = std::min(first, begin);
  });
  return first;
}

}  // namespace

void check(const vstree::PointSet& points, const Workers& workers) {
  if (points.positions.size() % 3 != 0) {
    throw vstree::Error(vstree::Element::array, 0,
                        fmt::format("positions has {} numbers; give three for each point", points.positions.size()));
  }
  const std::size_t count = points.positions.size() / 3;
  if (count > (std::size_t{1} << 31))
    throw vstree::Error(vstree::Element::array, 0,
                        fmt::format("positions has {} points; 2^31 are possible: split it", count));
  check_size(count, points.normals.size(), 3, "normals");
  check_size(count, points.colours.size(), 3, "colours");
  check_size(count, points.texcoords.size(), 2, "texcoords");
  const std::size_t position = first_beyond(points.positions, largest, workers);
  if (position < points.positions.size()) {
    throw vstree::Error(vstree::Element::point, position / 3,
                        fmt::format("has the coordinate {}; finite ones up to 1e18 are possible: remove the point",
                                    points.positions[position]));
  }
  const std::size_t normal = first_beyond(points.normals, std::numeric_limits<float>::max(), workers);
  if (normal < points.normals.size()) {
    throw vstree::Error(vstree::Element::point, normal / 3,
                        "has a normal that is not finite; make it zero to say that there is none");
  }
  const std::size_t texcoord = first_beyond(points.texcoords, std::numeric_limits<float>::max(), workers);
  if (texcoord < points.texcoords.size())
    throw vstree::Error(vstree::Element::point, texcoord / 2,
                        "has a texture coordinate that is not finite; remove the point");
}

Cube bounding_cube(std::span<const float> positions, const Workers& workers) {
  Cube cube;
  const std::size_t count = positions.size() / 3;
  if (count == 0) return cube;
  Float4 low{positions[0], positions[1], positions[2], 0};
  Float4 high = low;
  std::mutex mutex;
  workers.each(count, grain, [&](std::size_t begin, std::size_t end) {
    Float4 my_low{positions[3 * begin], positions[3 * begin + 1], positions[3 * begin + 2], 0};
    Float4 my_high = my_low;
    for (std::size_t i = begin; i < end; ++i) {
      const Float4 p{positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 0};
      my_low = least(my_low, p);
      my_high = greatest(my_high, p);
    }
    const std::lock_guard lock(mutex);
    low = least(low, my_low);
    high = greatest(high, my_high);
  });
  const Float4 extent = high - low;
  cube.low = low;
  const float side = std::max({extent[0], extent[1], extent[2]});
  if (!(side > 0) || !std::isfinite(1 / side)) return cube;  // all points are equal in single precision
  cube.side = side;
  cube.scale = 1 / side;
  cube.diagonal = std::sqrt(dot(extent * cube.scale, extent * cube.scale));
  return cube;
}

}  // namespace glark::common
