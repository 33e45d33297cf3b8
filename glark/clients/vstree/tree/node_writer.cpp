// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/tree/node_writer.h"

#include "glark/clients/common/points/height_field.h"
#include "glark/clients/common/points/point_set.h"

namespace glark::vstree {

// The quadrants of a node, in two pairs: left and right, or lower and upper.
struct NodeWriter::Pairs {
  std::uint32_t quadrants[4] = {none, none, none, none};  // indices of cells; `none` for quadrants without samples
  const unsigned (*which)[2] = nullptr;                   // two pairs
  float errors[2] = {};
};

void NodeWriter::write_children(std::uint32_t slot, unsigned level, std::uint32_t index) {
  const std::vector<Cell>& fine = cells_.levels[level + 1];
  const std::uint32_t first = cells_.levels[level][index].first_child;
  const std::uint32_t last = cells_.levels[level][index + 1].first_child;
  if (kind_ == Kind::surface && last - first > 1 && close_in_pairs(slot, level + 1, first, last)) return;
  const auto first_slot = static_cast<std::uint32_t>(out_.nodes.size());
  Node child;
  child.frame = out_.nodes[slot].frame;
  child.kind = kind_;
  child.level = static_cast<std::uint8_t>(out_.nodes[slot].level + 1);
  unsigned children = 0;
  for (std::uint32_t i = first; i < last; ++i) {
    children |= 1U << (fine[i].key & (kind_ == Kind::volume ? 7U : 3U));
    child.begin = begin_ + fine[i].begin;
    child.end = begin_ + fine[i + 1].begin;
    out_.nodes.push_back(child);
  }
  out_.nodes[slot].first_child = first_slot;
  out_.nodes[slot].children = static_cast<std::uint8_t>(children);
  for (std::uint32_t i = first; i < last; ++i) write_node(first_slot + (i - first), level + 1, i);
}

void NodeWriter::write_node(std::uint32_t slot, unsigned level, std::uint32_t index) {
  const Moments* const moments = cells_.moments_of(level, index);
  Node& node = out_.nodes[slot];
  const std::span<Record> records = sorted_.records.subspan(node.begin - begin_, node.size());
  const Options& options = builder_.options();
  node.error = builder_.error_of(moments, records);
  const unsigned depth = sorted_.depth + level;
  if (kind_ == Kind::volume && options.surface && !(builder_.ends_at_layer() && node.error <= options.threshold) &&
      is_height_field(records, *moments, options.delta_a, options.delta_d)) {
    Task task = task_of(slot, depth);
    task.enters_surface = true;
    task.moments = *moments;
    hand_over(task);
  } else if (builder_.is_leaf(node, records) || depth == (kind_ == Kind::volume ? octree_levels : quadtree_levels)) {
    builder_.close(node.begin, records);
  } else if (level + 1 < cells_.levels.size()) {
    write_children(slot, level, index);
  } else {
    Task task = task_of(slot, depth);
    hand_over(task);
  }
}

std::span<Record> NodeWriter::records_of(unsigned level, std::uint32_t index) const {
  const Cell* const cell = &cells_.levels[level][index];
  return sorted_.records.subspan(cell[0].begin, cell[1].begin - cell[0].begin);
}

// Returns the error of two quadrants as one leaf. If only one of them has samples, returns its error.
float NodeWriter::error_of(unsigned level, std::uint32_t a, std::uint32_t b) const {
  if (a == none || b == none) {
    const std::uint32_t only = a == none ? b : a;
    return builder_.error_of(cells_.moments_of(level, only), records_of(level, only));
  }
  if (cells_.moments.empty()) return static_cast<float>(records_of(level, a).size() + records_of(level, b).size());
  Moments moments = cells_.moments[level][a];
  moments.add(cells_.moments[level][b]);
  return builder_.error_of(&moments, {});
}

// Joins the quadrants to two leaves if both leaves are within the threshold. Otherwise returns false and changes
// nothing.
bool NodeWriter::close_in_pairs(std::uint32_t slot, unsigned level, std::uint32_t first, std::uint32_t last) {
  if (builder_.options().metric == Metric::qef) return false;  // errors of this metric do not add up
  Pairs pairs;
  for (std::uint32_t i = first; i < last; ++i) pairs.quadrants[cells_.levels[level][i].key & 3U] = i;
  static constexpr unsigned ways[2][2][2] = {{{0, 1}, {2, 3}}, {{0, 2}, {1, 3}}};
  for (unsigned way = 0; way < 2; ++way) {
    pairs.which = ways[way];
    pairs.errors[0] = pairs.errors[1] = 0;
    bool joined[2] = {};
    bool enough = true;
    for (unsigned i = 0; i < 2; ++i) {
      const std::uint32_t a = pairs.quadrants[pairs.which[i][0]], b = pairs.quadrants[pairs.which[i][1]];
      if (a == none && b == none) continue;
      joined[i] = a != none && b != none;
      pairs.errors[i] = error_of(level, a, b);
      enough &= pairs.errors[i] <= builder_.options().threshold;
    }
    if (!enough || !(joined[0] || joined[1])) continue;
    write_pairs(slot, level, pairs);
    out_.nodes[slot].joined = static_cast<std::uint8_t>(((joined[0] ? 1U : 0U) | (joined[1] ? 2U : 0U)) << (2 * way));
    return true;
  }
  return false;
}

void NodeWriter::write_pairs(std::uint32_t slot, unsigned level, const Pairs& pairs) {
  const std::uint32_t* const quadrants = pairs.quadrants;
  Node child;
  child.frame = out_.nodes[slot].frame;
  child.kind = kind_;
  child.level = static_cast<std::uint8_t>(out_.nodes[slot].level + 1);
  child.end = out_.nodes[slot].begin;
  out_.nodes[slot].first_child = static_cast<std::uint32_t>(out_.nodes.size());
  together_.clear();
  // The pair whose first quadrant with samples comes first is written first.
  const unsigned first = quadrants[0] == none && pairs.which[1][0] == 1 ? 1 : 0;
  for (const unsigned i : {first, 1 - first}) {
    child.begin = child.end;
    child.error = pairs.errors[i];
    for (unsigned k = 0; k < 2; ++k) {
      const unsigned quadrant = pairs.which[i][k];
      if (quadrants[quadrant] == none) continue;
      const std::span<const Record> records = records_of(level, quadrants[quadrant]);
      together_.insert(together_.end(), records.begin(), records.end());
      child.end += static_cast<std::uint32_t>(records.size());
      out_.nodes[slot].children = static_cast<std::uint8_t>(out_.nodes[slot].children | (1U << quadrant));
    }
    if (child.end > child.begin) out_.nodes.push_back(child);
  }
  builder_.close(out_.nodes[slot].begin, together_);
}

Task NodeWriter::task_of(std::uint32_t slot, unsigned depth) const {
  Task task;
  task.slot = slot;
  const Node& node = out_.nodes[slot];
  task.records = sorted_.records.subspan(node.begin - begin_, node.size());
  task.other = sorted_.other.subspan(node.begin - begin_, node.size());
  task.is_alone = sorted_.is_alone;
  task.depth = depth;
  task.frame = sorted_.frame;
  return task;
}

void NodeWriter::hand_over(Task& task) {
  if (!sorted_.is_alone) {
    tasks_.push_back(task);
  } else {
    builder_.divide(out_, task);
  }
}

}  // namespace glark::vstree
