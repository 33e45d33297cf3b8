// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 3.2.2, which classifies the samples of a node into its children, level by level. Here a
// counting sort takes several levels at once, and the moments of the finest cells add up to those of their parents. So
// each sample is moved and read only a few times.
#include "glark/clients/vstree/tree/tree_builder.h"

#include <algorithm>
#include <utility>

#include "glark/clients/common/counting_sort.h"
#include "glark/clients/common/points/point_set.h"
#include "glark/clients/vstree/quadric.h"
#include "glark/clients/vstree/tree/node_writer.h"

namespace glark::vstree {
namespace {

constexpr std::size_t samples_alone = 1 << 15;  // a larger sort hands its tasks to other threads
constexpr std::size_t samples_a_part = 1 << 12;
// The target for the finest cells. It is high, because many cubes become transition nodes earlier.
constexpr std::size_t samples_a_cube = 200;
constexpr std::size_t samples_a_rectangle = 4;
constexpr unsigned most_cube_levels = 6;  // for one sort: 2^18 counters
constexpr unsigned most_rectangle_levels = 8;

// Returns the number of levels that divide `count` samples of a surface into cells of `aim` samples. A cell has four
// children.
unsigned levels_for(std::size_t count, std::size_t aim, unsigned most) {
  unsigned levels = 1;
  while (levels < most && (count >> (2 * levels)) > aim) ++levels;
  return levels;
}

}  // namespace

TreeBuilder::TreeBuilder(const Input& input, std::vector<std::uint32_t>& order)
    : input_(input),
      order_(order),
      buffers_{Records(input.points.positions.size() / 3), Records(input.points.positions.size() / 3)} {
  order.resize(input.points.positions.size() / 3);
}

float TreeBuilder::error_of(const Moments* moments, std::span<const Record> records) const {
  switch (input_.options.metric) {
    case Metric::l2: return std::sqrt(moments->plane_error()) / input_.cube.diagonal;
    case Metric::l21: return std::sqrt(moments->normal_error());
    case Metric::qef: return std::sqrt(best_point_error(records, *moments)) / input_.cube.diagonal;
    case Metric::density: break;
  }
  return static_cast<float>(records.size());
}

bool TreeBuilder::is_leaf(const Node& node, std::span<const Record> records) const {
  return node.error <= input_.options.threshold || node.size() <= input_.options.least_samples ||
         are_at_one_point(records);
}

void TreeBuilder::close(std::uint32_t begin, std::span<const Record> records) {
  if (input_.keeps_records) {
    Record* const to = &buffers_[0].all()[begin];
    if (to != records.data()) std::copy(records.begin(), records.end(), to);
  }
  for (const Record& record : records) order_[begin++] = record.index();
}

void TreeBuilder::enter_surface(Nodes& out, Task& task) {
  task.frame = frame_of(task.records, task.moments);
  task.depth = 0;
  Node& node = out.nodes[task.slot];
  node.kind = Kind::transition;
  node.frame = static_cast<std::uint32_t>(out.frames.size());
  out.frames.push_back(task.frame);
  out.frame_nodes.push_back(task.slot);
}

void TreeBuilder::divide(Nodes& out, Task& task) {
  if (task.enters_surface) enter_surface(out, task);
  const Node& node = out.nodes[task.slot];
  if (task.enters_surface && (input_.ends_at_layer || is_leaf(node, task.records))) {
    close(node.begin, task.records);
    return;
  }
  if (!task.is_alone && task.size() <= samples_alone) {
    Records& room = rooms_.local();
    if (room.all().size() < task.size()) room = Records(std::min(samples_alone, buffers_[0].all().size()));
    task.other = room.all().first(task.size());
    task.is_alone = true;
  }
  const Kind kind = node.kind == Kind::volume ? Kind::volume : Kind::surface;
  const Cells cells = kind == Kind::volume ? sort_cubes(task) : sort_rectangles(task);
  std::swap(task.records, task.other);
  NodeWriter writer(*this, out, cells, task, kind);
  writer.write_children(task.slot, 0, 0);
  writer.finish();
}

Cells TreeBuilder::cells_of(std::span<const Record> sorted, std::span<const std::uint32_t> begins, unsigned levels,
                            Kind kind) {
  Cells cells = vstree::cells_of(begins, levels, kind == Kind::volume ? 3 : 2);
  if (input_.options.metric != Metric::density || (kind == Kind::volume && input_.options.surface))
    add_moments(cells, sorted, input_.workers);
  return cells;
}

Cells TreeBuilder::sort_cubes(const Task& task) {
  const std::span<const Record> from = task.records;
  const std::span<Record> to = task.other;
  const unsigned levels = std::min(levels_for(task.size(), samples_a_cube, 2), octree_levels - task.depth);
  const unsigned shift = octree_levels - task.depth - levels;
  const std::uint32_t mask = (1U << levels) - 1;
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [x, y, z] = octree_cell(from[i].point());
      *keys++ = every_third_bit((x >> shift) & mask) | (every_third_bit((y >> shift) & mask) << 1) |
                (every_third_bit((z >> shift) & mask) << 2);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) to[*slots++] = from[i];
  };
  const auto begins = sort_by_key(task.size(), std::size_t{1} << (3 * levels), key, move, input_.workers);
  return cells_of(to, begins, levels, Kind::volume);
}

Cells TreeBuilder::sort_rectangles(const Task& task) {
  const std::span<const Record> from = task.records;
  const std::span<Record> to = task.other;
  const unsigned levels =
      std::min(levels_for(task.size(), samples_a_rectangle, most_rectangle_levels), quadtree_levels - task.depth);
  const unsigned shift = quadtree_levels - task.depth - levels;
  const std::uint32_t mask = (1U << levels) - 1;
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [u, v] = task.frame.cell(task.frame.inside(from[i].point()));
      *keys++ = every_second_bit((u >> shift) & mask) | (every_second_bit((v >> shift) & mask) << 1);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) to[*slots++] = from[i];
  };
  const auto begins = sort_by_key(task.size(), std::size_t{1} << (2 * levels), key, move, input_.workers);
  return cells_of(to, begins, levels, Kind::surface);
}

// Groups of tasks write to separate nodes at the same time. The nodes are appended in the order of the tasks. So the
// result does not depend on the threads.
void TreeBuilder::divide_all(Nodes& out, std::vector<Task>& tasks) {
  std::vector<std::size_t> firsts{0};  // the first task of each group
  std::size_t samples = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    samples += tasks[i].size();
    if (samples < samples_a_part && i + 1 < tasks.size()) continue;
    firsts.push_back(i + 1);
    samples = 0;
  }
  std::vector<Nodes> parts(firsts.size() - 1);
  input_.workers.each(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const std::span<Task> mine = std::span(tasks).subspan(firsts[part], firsts[part + 1] - firsts[part]);
      for (const Task& task : mine) parts[part].nodes.push_back(out.nodes[task.slot]);
      for (std::uint32_t i = 0; i < mine.size(); ++i) {
        const std::uint32_t slot = std::exchange(mine[i].slot, i);
        divide(parts[part], mine[i]);
        mine[i].slot = slot;
      }
    }
  });
  std::size_t all = out.nodes.size();
  for (const Nodes& part : parts) all += part.nodes.size();
  if (all > out.nodes.capacity()) out.nodes.reserve(all);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    append(out, parts[part], std::span(tasks).subspan(firsts[part], firsts[part + 1] - firsts[part]));
    parts[part] = {};
  }
}

// The first nodes of a part are the nodes of its tasks.
void TreeBuilder::append(Nodes& out, const Nodes& part, std::span<const Task> tasks) {
  const auto roots = static_cast<std::uint32_t>(tasks.size());
  const bool has_frames =
      !tasks[0].enters_surface && part.nodes[0].kind == Kind::surface;  // then all tasks have frames
  const auto frame_shift = static_cast<std::uint32_t>(out.frames.size());
  const auto shift = static_cast<std::uint32_t>(out.nodes.size() - roots);
  for (std::uint32_t i = 0; i < part.nodes.size(); ++i) {
    Node node = part.nodes[i];
    if (!node.is_leaf()) node.first_child += shift;
    if (!has_frames && node.frame != none) node.frame += frame_shift;
    if (i < roots) {
      out.nodes[tasks[i].slot] = node;
    } else {
      out.nodes.push_back(node);
    }
  }
  out.frames.insert(out.frames.end(), part.frames.begin(), part.frames.end());
  for (const std::uint32_t node : part.frame_nodes)
    out.frame_nodes.push_back(node < roots ? tasks[node].slot : node + shift);
}

// Sorts the records of all points into the first levels of the octree.
std::vector<std::uint32_t> TreeBuilder::fill(unsigned levels) {
  const unsigned shift = octree_levels - levels;
  const std::span<Record> to = buffers_[0].all();
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      *keys++ = cube_key(octree_cell(input_.cube.inside(&input_.points.positions[3 * i])), shift);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) {
      to[*slots++] = record_of(input_.points, input_.cube, static_cast<std::uint32_t>(i));
    }
  };
  return sort_by_key(to.size(), std::size_t{1} << (3 * levels), key, move, input_.workers);
}

Nodes TreeBuilder::run() {
  Nodes result;
  Task all;
  all.records = buffers_[0].all();
  all.other = buffers_[1].all();
  if (all.size() == 0) return result;
  const unsigned levels = levels_for(all.size(), samples_a_cube, most_cube_levels);
  const std::vector<std::uint32_t> begins = fill(levels);
  const Cells cells = cells_of(all.records, begins, levels, Kind::volume);
  result.nodes.push_back({});
  result.nodes[0].end = static_cast<std::uint32_t>(all.size());
  NodeWriter writer(*this, result, cells, all, Kind::volume);
  writer.write_node(0, 0, 0);
  writer.finish();
  return result;
}

Nodes construct(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
                const Workers& workers, Records* sorted, bool ends_at_layer) {
  TreeBuilder builder({points, cube, options, workers, sorted != nullptr, ends_at_layer}, order);
  Nodes nodes = builder.run();
  if (sorted != nullptr) *sorted = builder.sorted();
  return nodes;
}

}  // namespace glark::vstree
