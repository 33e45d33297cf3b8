// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Source: Boubekeur 2007, ch. 3.2.2. There the samples of a node are classified into its children, level after level. Here a counting
// sort takes several levels at once, and the moments of the finest cells add up to those of their parents, so that a sample is moved
// and looked at a few times in all.
#include "glark/clients/vstree/construction.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <utility>

#include "glark/clients/vstree/cells.h"
#include "glark/clients/vstree/height_field.h"
#include "glark/clients/vstree/quadric.h"
#include "glark/clients/vstree/samples.h"

namespace glark::vstree {
namespace {

constexpr std::size_t samples_alone = 1 << 15;  // a sort of so many hands its tasks to other threads
constexpr std::size_t samples_a_part = 1 << 12;
constexpr std::size_t samples_a_cube =
    200;  // of the finest cells, aimed at: many cubes become transition nodes earlier
constexpr std::size_t samples_a_rectangle = 4;
constexpr unsigned most_cube_levels = 6;  // at a time: 2^18 counters
constexpr unsigned most_rectangle_levels = 8;

// How many levels divide `count` samples of a surface, four children each, into runs of `aim`.
unsigned levels_for(std::size_t count, std::size_t aim, unsigned most) {
  unsigned levels = 1;
  while (levels < most && (count >> (2 * levels)) > aim) ++levels;
  return levels;
}

// A node whose samples are to be divided.
struct Task {
  std::uint32_t slot = 0;            // of its node
  std::span<Record> records, other;  // the samples, and as much room
  bool is_alone = false;             // no other thread helps, and the room is this one's
  bool enters_surface = false;
  Moments moments = {};   // of a node that does
  unsigned depth = 0;     // below the root of the octree or the quadtree
  LocalFrame frame = {};  // of one below

  std::size_t size() const { return records.size(); }
};

class Construction {
 public:
  Construction(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
               const Workers& workers, bool keeps_records, bool ends_at_layer)
      : points_(points),
        cube_(cube),
        options_(options),
        order_(order),
        workers_(workers),
        keeps_records_(keeps_records),
        ends_at_layer_(ends_at_layer),
        buffers_{Records(points.positions.size() / 3), Records(points.positions.size() / 3)} {
    order.resize(points.positions.size() / 3);
  }

  Nodes run();
  Records sorted() { return std::move(buffers_[0]); }

 private:
  friend class Emission;

  std::vector<std::uint32_t> fill(unsigned levels);
  Cells sort_cubes(const Task& task);
  Cells sort_rectangles(const Task& task);
  Cells cells_of(std::span<const Record> sorted, std::span<const std::uint32_t> begins, unsigned levels, Kind kind);
  void enter_surface(Nodes& out, Task& task);
  void carry_out(Nodes& out, Task& task);
  void finish(Nodes& out, std::vector<Task>& tasks);
  static void append(Nodes& out, const Nodes& part, std::span<const Task> tasks);
  float error_of(const Moments* moments, std::span<const Record> records) const;
  bool is_leaf(const Node& node, std::span<const Record> records) const;
  void close(std::uint32_t begin, std::span<const Record> records);

  const PointSet& points_;
  const Cube& cube_;
  const Options options_;
  std::vector<std::uint32_t>& order_;
  const Workers& workers_;
  const bool keeps_records_;
  const bool ends_at_layer_;
  Records buffers_[2];
  tbb::enumerable_thread_specific<Records> rooms_;  // for tasks of one thread, small enough for its cache
};

// moments: null for numbers of samples.
float Construction::error_of(const Moments* moments, std::span<const Record> records) const {
  switch (options_.metric) {
    case Metric::l2: return std::sqrt(moments->plane_error()) / cube_.diagonal;
    case Metric::l21: return std::sqrt(moments->normal_error());
    case Metric::qef: return std::sqrt(best_point_error(records, *moments)) / cube_.diagonal;
    case Metric::density: break;
  }
  return static_cast<float>(records.size());
}

bool Construction::is_leaf(const Node& node, std::span<const Record> records) const {
  return node.error <= options_.threshold || node.size() <= options_.least_samples || are_at_one_point(records);
}

// The samples of a leaf, in their order from now on.
void Construction::close(std::uint32_t begin, std::span<const Record> records) {
  if (keeps_records_) {
    Record* const to = &buffers_[0].all()[begin];
    if (to != records.data()) std::copy(records.begin(), records.end(), to);
  }
  for (const Record& record : records) order_[begin++] = record.index();
}

// Nodes from the cells of one sort, the coarsest first.
class Emission {
 public:
  // sorted: the node whose samples were sorted.
  Emission(Construction& owner, Nodes& out, const Cells& cells, const Task& sorted, Kind kind)
      : owner_(owner), out_(out), cells_(cells), sorted_(sorted), kind_(kind), begin_(out.nodes[sorted.slot].begin) {}

  void children_of(std::uint32_t slot, unsigned level, std::uint32_t index) {
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
    for (std::uint32_t i = first; i < last; ++i) node(first_slot + (i - first), level + 1, i);
  }

  // What becomes of the node in the slot, whose cell this is.
  void node(std::uint32_t slot, unsigned level, std::uint32_t index) {
    const Moments* const moments = cells_.moments_of(level, index);
    Node& node = out_.nodes[slot];
    const std::span<Record> records = sorted_.records.subspan(node.begin - begin_, node.size());
    const Options& options = owner_.options_;
    node.error = owner_.error_of(moments, records);
    const unsigned depth = sorted_.depth + level;
    if (kind_ == Kind::volume && options.surface && !(owner_.ends_at_layer_ && node.error <= options.threshold) &&
        is_height_field(records, *moments, options.delta_a, options.delta_d)) {
      Task task = task_of(slot, depth);
      task.enters_surface = true;
      task.moments = *moments;
      hand_over(task);
    } else if (owner_.is_leaf(node, records) || depth == (kind_ == Kind::volume ? octree_levels : quadtree_levels)) {
      owner_.close(node.begin, records);
    } else if (level + 1 < cells_.levels.size()) {
      children_of(slot, level, index);
    } else {
      Task task = task_of(slot, depth);
      hand_over(task);
    }
  }

  void finish() { owner_.finish(out_, tasks_); }

 private:
  std::span<Record> records_of(unsigned level, std::uint32_t index) const {
    const Cell* const cell = &cells_.levels[level][index];
    return sorted_.records.subspan(cell[0].begin, cell[1].begin - cell[0].begin);
  }

  // Of one quadrant, or of two together; `none` is one without samples.
  float error_of(unsigned level, std::uint32_t a, std::uint32_t b) const {
    if (a == none || b == none) {
      const std::uint32_t only = a == none ? b : a;
      return owner_.error_of(cells_.moments_of(level, only), records_of(level, only));
    }
    if (cells_.moments.empty()) return static_cast<float>(records_of(level, a).size() + records_of(level, b).size());
    Moments moments = cells_.moments[level][a];
    moments.add(cells_.moments[level][b]);
    return owner_.error_of(&moments, {});
  }

  // The quadrants of a node as leaves of two, if that is all that it takes. False if not: nothing has changed then.
  bool close_in_pairs(std::uint32_t slot, unsigned level, std::uint32_t first, std::uint32_t last) {
    if (owner_.options_.metric == Metric::qef) return false;  // its errors do not add up
    std::uint32_t quadrants[4] = {none, none, none, none};
    for (std::uint32_t i = first; i < last; ++i) quadrants[cells_.levels[level][i].key & 3U] = i;
    constexpr unsigned pairs[2][2][2] = {{{0, 1}, {2, 3}}, {{0, 2}, {1, 3}}};
    for (unsigned way = 0; way < 2; ++way) {
      float errors[2] = {};
      bool joined[2] = {};
      bool enough = true;
      for (unsigned i = 0; i < 2; ++i) {
        const std::uint32_t a = quadrants[pairs[way][i][0]], b = quadrants[pairs[way][i][1]];
        if (a == none && b == none) continue;
        joined[i] = a != none && b != none;
        errors[i] = error_of(level, a, b);
        enough &= errors[i] <= owner_.options_.threshold;
      }
      if (!enough || !(joined[0] || joined[1])) continue;
      write_pairs(slot, level, quadrants, pairs[way], errors);
      out_.nodes[slot].joined = static_cast<std::uint8_t>(((joined[0] ? 1U : 0U) | (joined[1] ? 2U : 0U)) << (2 * way));
      return true;
    }
    return false;
  }

  void write_pairs(std::uint32_t slot, unsigned level, const std::uint32_t (&quadrants)[4],
                   const unsigned (&pairs)[2][2], const float (&errors)[2]) {
    Node child;
    child.frame = out_.nodes[slot].frame;
    child.kind = kind_;
    child.level = static_cast<std::uint8_t>(out_.nodes[slot].level + 1);
    child.end = out_.nodes[slot].begin;
    out_.nodes[slot].first_child = static_cast<std::uint32_t>(out_.nodes.size());
    together_.clear();
    // In the order of their first quadrants with samples.
    const unsigned first = quadrants[0] == none && pairs[1][0] == 1 ? 1 : 0;
    for (const unsigned i : {first, 1 - first}) {
      child.begin = child.end;
      child.error = errors[i];
      for (const unsigned quadrant : pairs[i]) {
        if (quadrants[quadrant] == none) continue;
        const std::span<const Record> records = records_of(level, quadrants[quadrant]);
        together_.insert(together_.end(), records.begin(), records.end());
        child.end += static_cast<std::uint32_t>(records.size());
        out_.nodes[slot].children = static_cast<std::uint8_t>(out_.nodes[slot].children | (1U << quadrant));
      }
      if (child.end > child.begin) out_.nodes.push_back(child);
    }
    owner_.close(out_.nodes[slot].begin, together_);
  }

  Task task_of(std::uint32_t slot, unsigned depth) const {
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

  void hand_over(Task& task) {
    if (!sorted_.is_alone) {
      tasks_.push_back(task);
    } else {
      owner_.carry_out(out_, task);
    }
  }

  Construction& owner_;
  Nodes& out_;
  const Cells& cells_;
  const Task& sorted_;
  const Kind kind_;
  const std::uint32_t begin_;     // of the samples
  std::vector<Record> together_;  // of quadrants in pairs: not the order that they are in
  std::vector<Task> tasks_;
};

void Construction::enter_surface(Nodes& out, Task& task) {
  task.frame = frame_of(task.records, task.moments);
  task.depth = 0;
  Node& node = out.nodes[task.slot];
  node.kind = Kind::transition;
  node.frame = static_cast<std::uint32_t>(out.frames.size());
  out.frames.push_back(task.frame);
  out.frame_nodes.push_back(task.slot);
}

void Construction::carry_out(Nodes& out, Task& task) {
  if (task.enters_surface) enter_surface(out, task);
  const Node& node = out.nodes[task.slot];
  if (task.enters_surface && (ends_at_layer_ || is_leaf(node, task.records))) {
    close(node.begin, task.records);
    return;
  }
  if (!task.is_alone && task.size() <= samples_alone) {
    Records& room = rooms_.local();
    if (room.all().size() < task.size()) room = Records(samples_alone);
    task.other = room.all().first(task.size());
    task.is_alone = true;
  }
  const Kind kind = node.kind == Kind::volume ? Kind::volume : Kind::surface;
  const Cells cells = kind == Kind::volume ? sort_cubes(task) : sort_rectangles(task);
  std::swap(task.records, task.other);
  Emission emission(*this, out, cells, task, kind);
  emission.children_of(task.slot, 0, 0);
  emission.finish();
}

Cells Construction::cells_of(std::span<const Record> sorted, std::span<const std::uint32_t> begins, unsigned levels,
                             Kind kind) {
  Cells cells = vstree::cells_of(begins, levels, kind == Kind::volume ? 3 : 2);
  if (options_.metric != Metric::density || (kind == Kind::volume && options_.surface))
    add_moments(cells, sorted, workers_);
  return cells;
}

Cells Construction::sort_cubes(const Task& task) {
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
  const auto begins = sort_by_key(task.size(), std::size_t{1} << (3 * levels), key, move, workers_);
  return cells_of(to, begins, levels, Kind::volume);
}

Cells Construction::sort_rectangles(const Task& task) {
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
  const auto begins = sort_by_key(task.size(), std::size_t{1} << (2 * levels), key, move, workers_);
  return cells_of(to, begins, levels, Kind::surface);
}

// Some tasks at a time in nodes of their own, which follow one another as the tasks do, whichever thread takes some first.
void Construction::finish(Nodes& out, std::vector<Task>& tasks) {
  std::vector<std::size_t> firsts{0};  // of the tasks of each part
  std::size_t samples = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    samples += tasks[i].size();
    if (samples < samples_a_part && i + 1 < tasks.size()) continue;
    firsts.push_back(i + 1);
    samples = 0;
  }
  std::vector<Nodes> parts(firsts.size() - 1);
  workers_.each(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const std::span<Task> mine = std::span(tasks).subspan(firsts[part], firsts[part + 1] - firsts[part]);
      for (const Task& task : mine) parts[part].nodes.push_back(out.nodes[task.slot]);
      for (std::uint32_t i = 0; i < mine.size(); ++i) {
        const std::uint32_t slot = std::exchange(mine[i].slot, i);
        carry_out(parts[part], mine[i]);
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

// The first nodes of a part are those of its tasks.
void Construction::append(Nodes& out, const Nodes& part, std::span<const Task> tasks) {
  const auto roots = static_cast<std::uint32_t>(tasks.size());
  const bool has_frames = !tasks[0].enters_surface && part.nodes[0].kind == Kind::surface;  // then all tasks have
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

// The records of all points, sorted into the first levels of the octree.
std::vector<std::uint32_t> Construction::fill(unsigned levels) {
  const unsigned shift = octree_levels - levels;
  const std::span<Record> to = buffers_[0].all();
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      *keys++ = cube_key(octree_cell(cube_.inside(&points_.positions[3 * i])), shift);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) {
      to[*slots++] = record_of(points_, cube_, static_cast<std::uint32_t>(i));
    }
  };
  return sort_by_key(to.size(), std::size_t{1} << (3 * levels), key, move, workers_);
}

Nodes Construction::run() {
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
  Emission emission(*this, result, cells, all, Kind::volume);
  emission.node(0, 0, 0);
  emission.finish();
  return result;
}

}  // namespace

Nodes construct(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
                const Workers& workers, Records* sorted, bool ends_at_layer) {
  Construction construction(points, cube, options, order, workers, sorted != nullptr, ends_at_layer);
  Nodes nodes = construction.run();
  if (sorted != nullptr) *sorted = construction.sorted();
  return nodes;
}

}  // namespace glark::vstree
