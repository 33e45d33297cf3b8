// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/grid/cube_table.h"

#include <algorithm>

namespace glark::stream {

void Cube::add(const Cube& part) {
  count += part.count;
  first = std::min(first, part.first);
  last = std::max(last, part.last);
}

Cube& CubeTable::at(std::uint64_t key) {
  if (2 * used_ >= slots_.size()) grow();
  std::size_t i = place(key, slots_.size());
  while (slots_[i].key != key && slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
  if (slots_[i].key == Cube::no_key) {
    slots_[i].key = key;
    ++used_;
  }
  return slots_[i];
}

const Cube* CubeTable::find(std::uint64_t key) const {
  std::size_t i = place(key, slots_.size());
  while (slots_[i].key != key && slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
  return slots_[i].key == key ? &slots_[i] : nullptr;
}

void CubeTable::grow() {
  std::vector<Cube> old(2 * slots_.size());
  old.swap(slots_);
  for (const Cube& cube : old) {
    if (cube.key == Cube::no_key) continue;
    std::size_t i = place(cube.key, slots_.size());
    while (slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = cube;
  }
}

std::vector<Cube> CubeTable::sorted() const {
  std::vector<Cube> cubes;
  cubes.reserve(used_);
  for (const Cube& cube : slots_)
    if (cube.key != Cube::no_key) cubes.push_back(cube);
  std::sort(cubes.begin(), cubes.end(), [](const Cube& a, const Cube& b) { return a.key < b.key; });
  return cubes;
}

void CubeTable::clear() {
  std::fill(slots_.begin(), slots_.end(), Cube{});
  used_ = 0;
}

void BoundedCubes::add(const Cube& cube) {
  std::uint64_t key = key_at_level(cube.key, level_);
  while (table_.size() >= most_ && table_.find(key) == nullptr) {
    coarsen_to(level_ + 1);
    key = key_at_level(cube.key, level_);
  }
  table_.at(key).add(cube);
}

void BoundedCubes::coarsen_to(unsigned level) {
  if (level <= level_) return;
  level_ = level;
  std::vector<Cube> cubes = table_.sorted();
  table_ = CubeTable();  // before the next one grows
  for (const Cube& cube : cubes) table_.at(key_at_level(cube.key, level)).add(cube);
}

}  // namespace glark::stream
