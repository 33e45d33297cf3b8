// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/proximity_grid.h"

#include <algorithm>
#include <cmath>

namespace glark::surfel {
namespace {

constexpr float rounding = 1.25F;  // distances with a smaller ratio share a bitmap

}  // namespace

void ProximityGrid::begin(std::span<const Place> points, float greatest_distance) {
  points_ = points;
  greatest_distance_ = greatest_distance;
  used_ = latest_ = 0;
  constexpr float far = 1e30F;
  Place high = {-far, -far};
  low_ = {far, far};
  for (const Place& point : points) {
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  constexpr float margin = 1.5F;  // in cells
  for (std::size_t k = 0; k < 2; ++k) {
    const float size = std::max(high[k] - low_[k] + 2 * greatest_distance, 1e-30F);
    scale_[k] = (cells - 2 * margin) / size;
    low_[k] -= greatest_distance + margin / scale_[k];
  }
}

// Draws a disc around each point. All discs are shifted copies of the same bits.
void ProximityGrid::rasterize(Bitmap& bitmap) const {
  bitmap.rows.fill(0);
  const float wide = bitmap.distance * scale_[0], high = bitmap.distance * scale_[1];
  const int rows = static_cast<int>(high), columns = static_cast<int>(wide);
  std::array<std::uint64_t, cells> disc;
  for (int row = 0; row <= 2 * rows; ++row) {
    const float part = static_cast<float>(row - rows) / std::max(high, 1.0F);
    const int half = static_cast<int>(std::lrint(wide * std::sqrt(std::max(0.0F, 1 - part * part))));
    const int width = 2 * std::min(half, columns) + 1;
    disc[static_cast<std::size_t>(row)] = ((std::uint64_t{1} << width) - 1) << (columns - width / 2);
  }
  for (const Place& point : points_) {
    const int x = static_cast<int>((point[0] - low_[0]) * scale_[0]) - columns;
    const int y = static_cast<int>((point[1] - low_[1]) * scale_[1]) - rows;
    std::uint64_t* const first = bitmap.rows.data() + std::clamp(y, 0, cells - 1 - 2 * rows);
    const int shift = std::clamp(x, 0, cells - 1 - 2 * columns);
    for (int row = 0; row <= 2 * rows; ++row) first[row] |= disc[static_cast<std::size_t>(row)] << shift;
  }
}

const ProximityGrid::Bitmap& ProximityGrid::bitmap_for(float distance) {
  const auto fits = [&](const Bitmap& bitmap) {
    return bitmap.distance >= distance && bitmap.distance <= distance * rounding;
  };
  if (latest_ < used_ && fits(bitmaps_[latest_])) return bitmaps_[latest_];
  const auto end = bitmaps_.begin() + static_cast<std::ptrdiff_t>(used_);
  latest_ = static_cast<std::size_t>(std::find_if(bitmaps_.begin(), end, fits) - bitmaps_.begin());
  if (latest_ == used_) {
    if (used_ == bitmaps_.size()) bitmaps_.emplace_back();
    bitmaps_[used_].distance = std::min(distance * std::sqrt(rounding), greatest_distance_);
    rasterize(bitmaps_[used_++]);
  }
  return bitmaps_[latest_];
}

bool ProximityGrid::is_near(Place place, float distance) {
  const Bitmap& bitmap = bitmap_for(distance);
  const float x = (place[0] - low_[0]) * scale_[0], y = (place[1] - low_[1]) * scale_[1];
  if (!(x >= 0 && x < cells && y >= 0 && y < cells)) return false;
  return (bitmap.rows[static_cast<std::size_t>(y)] >> static_cast<unsigned>(x) & 1) != 0;
}

}  // namespace glark::surfel
