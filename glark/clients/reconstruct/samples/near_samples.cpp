// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/near_samples.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace glark::reconstruct {
namespace {

constexpr Record far_away{{9, 9, 9, 0}, {}};  // far from the unit cube
constexpr std::int32_t most_cells = 4;        // the most cells of a box along each axis

// Returns whether the first three lanes of the mask are set.
bool are_all(Int4 mask) {
#ifdef __SSE__
  return (_mm_movemask_ps(std::bit_cast<Float4>(mask)) & 7) == 7;
#else
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(mask);
  return (halves[0] & (halves[1] | 0xFFFFFFFF00000000)) == ~std::uint64_t{0};
#endif
}

// Transposes four rows. The fourth column is returned as integers, because its bits may be NaN as floats.
Int4 transpose(const Float4 (&rows)[4], Float4 (&out)[3]) {
  const Float4 ab = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Float4 cd = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Float4 ab_z = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Float4 cd_z = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  out[0] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  out[2] = __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
  return std::bit_cast<Int4>(__builtin_shufflevector(ab_z, cd_z, 2, 3, 6, 7));
}

// Returns the finest level on which the box has few cells.
const Level& level_for(const Octree& octree, Float4 low, Float4 high, CellBox& box) {
  for (std::size_t depth = 0;; ++depth) {
    const Level& level = octree.levels[depth];
    box = {cell_of(low, level.level), cell_of(high, level.level)};
    bool few = true;
    for (unsigned axis = 0; axis < 3; ++axis) few &= box.high[axis] - box.low[axis] < most_cells;
    if (few || depth + 1 == octree.levels.size()) return level;
  }
}

}  // namespace

void NearSamples::gather(const Octree& octree, Float4 low, Float4 high) {
  low_ = low;
  high_ = high;
  CellBox box;
  const Level& level = level_for(octree, low, high, box);
  std::size_t count = 0;
  level.blocks.each(box, [&](std::uint32_t begin, std::uint32_t end) {
    const std::size_t most = count + (end - begin) + 4;
    if (inside_.size() < most) inside_.resize(2 * most);
    Record* const out = inside_.data();
    // A branch in this loop would be mispredicted.
    for (std::uint32_t i = begin; i < end; ++i) {
      const Record& record = octree.records[i];
      out[count] = record;
      count += are_all((record.position >= low) & (record.position <= high)) ? 1 : 0;
    }
  });
  if (inside_.size() < count + 4) inside_.resize(count + 4);
  for (std::size_t i = count; i < count + 4; ++i) inside_[i] = far_away;
  samples_.resize((count + 3) / 4);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Record* const r = &inside_[4 * i];
    samples_[i].colour = transpose({r[0].position, r[1].position, r[2].position, r[3].position}, samples_[i].position);
    transpose({r[0].normal, r[1].normal, r[2].normal, r[3].normal}, samples_[i].normal);
  }
}

bool NearSamples::covers(Float4 low, Float4 high) const { return are_all((low >= low_) & (high <= high_)); }

}  // namespace glark::reconstruct
