// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sample in the unit cube, in the form that sorts move, and the bounding cube.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <new>
#include <span>

#include "glark/clients/common/float4.h"

namespace glark::common {

// A sample within the unit cube. The fourth float of the position holds the bits of the sample's index. The fourth
// float of the normal is 1 if the sample has a normal.
struct Record {
  Float4 position;
  Float4 normal;

  std::uint32_t index() const { return std::bit_cast<std::uint32_t>(static_cast<float>(position[3])); }
  // The position without the bits of the index.
  Float4 point() const { return without_fourth(position); }
};

inline bool are_at_one_point(std::span<const Record> records) {
  const Float4 first = records.front().point();
  return std::all_of(records.begin(), records.end(), [&](const Record& record) {
    const Float4 apart = record.point() - first;
    return dot(apart, apart) == 0;
  });
}

// An array of records without initial values. The first write to each memory page is expensive. Without initial values,
// the threads share these first writes.
class Records {
 public:
  Records() = default;
  explicit Records(std::size_t count)
      : records_(static_cast<Record*>(operator new (std::max<std::size_t>(1, count) * sizeof(Record),
                                                    std::align_val_t{alignof(Record)}))),
        count_(count) {}
  std::span<Record> all() const { return {records_.get(), count_}; }

 private:
  struct Release {
    void operator()(Record* records) const { operator delete (records, std::align_val_t{alignof(Record)}); }
  };
  std::unique_ptr<Record[], Release> records_;
  std::size_t count_ = 0;
};

// The bounding cube, which maps positions to the unit cube.
struct Cube {
  Float4 low{};
  float side = 1;
  float scale = 1;     // 1 / side
  float diagonal = 1;  // the diagonal of the bounding box, relative to the side

  Float4 inside(const float* position) const {
    return (Float4{position[0], position[1], position[2], 0} - low) * scale;
  }
};

inline constexpr unsigned octree_levels = 21;  // the last level's cubes are as small as a float resolves

// The cell of a position on the octree's last level.
inline std::array<std::uint32_t, 3> octree_cell(Float4 position) {
  constexpr float cells = 1U << octree_levels;
  constexpr Float4 last{cells - 1, cells - 1, cells - 1, 0};
  const Int4 cell = __builtin_convertvector(least(position * cells, last), Int4);
  return {static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]),
          static_cast<std::uint32_t>(cell[2])};
}

}  // namespace glark::common
