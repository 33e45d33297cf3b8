// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/cell_blocks.h"

namespace glark::reconstruct {
namespace {

std::uint64_t spread(std::uint64_t x) {
  x = (x | (x << 16)) & 0x0000FF0000FF;
  x = (x | (x << 8)) & 0x00F00F00F00F;
  x = (x | (x << 4)) & 0x0C30C30C30C3;
  return (x | (x << 2)) & 0x249249249249;
}

std::int32_t gather(std::uint64_t x) {
  x &= 0x249249249249;
  x = (x | (x >> 2)) & 0x0C30C30C30C3;
  x = (x | (x >> 4)) & 0x00F00F00F00F;
  x = (x | (x >> 8)) & 0x0000FF0000FF;
  return static_cast<std::int32_t>((x | (x >> 16)) & 0xFFFF);
}

}  // namespace

constinit const CellBlocks::Masks CellBlocks::masks = CellBlocks::all_masks();

std::uint64_t key_of(const CellIndex& cell) {
  return spread(static_cast<std::uint32_t>(cell[0])) | (spread(static_cast<std::uint32_t>(cell[1])) << 1) |
         (spread(static_cast<std::uint32_t>(cell[2])) << 2);
}

CellIndex cell_of_key(std::uint64_t key) { return {gather(key), gather(key >> 1), gather(key >> 2)}; }

CellBlocks::CellBlocks(const std::vector<std::uint64_t>& keys, const std::vector<std::uint32_t>& begins)
    : table_(keys.size() / 8) {
  for (std::size_t i = 0; i < keys.size();) {
    const std::uint64_t key = keys[i] / cells;
    table_.insert(key, static_cast<std::uint32_t>(blocks_.size()));
    Block& block = blocks_.emplace_back();
    unsigned cell = 0;
    for (; i < keys.size() && keys[i] / cells == key; ++i) {
      const auto at = static_cast<unsigned>(keys[i] % cells);
      block.occupied |= std::uint64_t{1} << at;
      for (; cell <= at; ++cell) block.begins[cell] = begins[i];
    }
    for (; cell <= cells; ++cell) block.begins[cell] = begins[i];
  }
}

}  // namespace glark::reconstruct
