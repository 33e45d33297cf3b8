// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/tree/micro_clusters.h"

#include <algorithm>

namespace glark::stream {

void MicroCluster::add(const LocalPoint& point, bool has_normals) {
  const auto& p = point.position;
  const auto& n = point.normal;
  count += 1;
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] += p[k];
    normal[k] += n[k];
    colour[k] += point.colour[k];
  }
  const auto& v = has_normals ? n : p;
  sums[0] += v[0] * v[0];
  sums[1] += v[1] * v[1];
  sums[2] += v[2] * v[2];
  sums[3] += v[0] * v[1];
  sums[4] += v[1] * v[2];
  sums[5] += v[2] * v[0];
  if (!has_normals) return;
  const float d = -(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
  sums[6] += n[0] * d;
  sums[7] += n[1] * d;
  sums[8] += n[2] * d;
  sums[9] += d * d;
}

void MicroTable::rebuild(Part& table, std::size_t slots) {
  table.slots.assign(slots, 0);
  for (std::uint32_t i = 0; i < table.clusters.size(); ++i) {
    std::size_t at = (table.clusters[i].key * 2654435761U) & (slots - 1);
    while (table.slots[at] != 0) at = (at + 1) & (slots - 1);
    table.slots[at] = i + 1;
  }
}

void MicroTable::add(unsigned part, const LocalPoint& point, bool has_normals) {
  Part& table = parts_[part];
  if (table.last < table.clusters.size() && table.clusters[table.last].key == point.key) {
    table.clusters[table.last].add(point, has_normals);
    return;
  }
  if (2 * table.clusters.size() >= table.slots.size())
    rebuild(table, std::max<std::size_t>(64, 2 * table.slots.size()));
  std::size_t at = (point.key * 2654435761U) & (table.slots.size() - 1);
  while (table.slots[at] != 0 && table.clusters[table.slots[at] - 1].key != point.key)
    at = (at + 1) & (table.slots.size() - 1);
  if (table.slots[at] == 0) {
    table.clusters.push_back({.key = point.key});
    table.slots[at] = static_cast<std::uint32_t>(table.clusters.size());
  }
  table.last = table.slots[at] - 1;
  table.clusters[table.last].add(point, has_normals);
}

std::vector<MicroCluster> MicroTable::take() {
  std::vector<MicroCluster> all;
  std::size_t count = 0;
  for (const Part& part : parts_) count += part.clusters.size();
  all.reserve(count);
  for (Part& part : parts_) {
    all.insert(all.end(), part.clusters.begin(), part.clusters.end());
    part = {};
  }
  std::sort(all.begin(), all.end(), [](const MicroCluster& a, const MicroCluster& b) { return a.key < b.key; });
  return all;
}

std::size_t MicroTable::size() const {
  std::size_t size = 0;
  for (const Part& part : parts_) size += part.clusters.size();
  return size;
}

std::size_t MicroTable::bytes() const {
  std::size_t bytes = 0;
  for (const Part& part : parts_)
    bytes += part.clusters.capacity() * sizeof(MicroCluster) + part.slots.capacity() * sizeof(std::uint32_t);
  return bytes;
}

void MicroTable::save(common::StateWriter& state) const {
  for (const Part& part : parts_) state.put_all(std::span<const MicroCluster>(part.clusters));
}

bool MicroTable::load(common::StateReader& state) {
  for (Part& part : parts_) {
    if (!state.get_all(part.clusters)) return false;
    std::size_t slots = 64;
    while (slots < 2 * part.clusters.size() + 2) slots *= 2;
    if (!part.clusters.empty()) rebuild(part, slots);
  }
  return true;
}

}  // namespace glark::stream
