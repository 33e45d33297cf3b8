// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Source: Boubekeur 2007, ch. 3.2.2. There the samples of a node are classified into its children, level after level. Here a counting
// sort takes several levels at once, and the moments of the finest cells add up to those of their parents, so that a sample is moved
// and looked at a few times in all.
#include "glark/clients/vstree/construction.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "glark/clients/vstree/cells.h"
#include "glark/clients/vstree/height_field.h"
#include "glark/clients/vstree/quadric.h"
#include "glark/clients/vstree/samples.h"

namespace glark::vstree {
namespace {

constexpr std::size_t samples_alone = 1 << 15;  // a sort of so many hands its tasks to other threads
constexpr std::size_t samples_a_cube = 64;  // of the finest cells, aimed at: many cubes become transition nodes earlier
constexpr std::size_t samples_a_rectangle = 6;
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
  std::uint32_t slot = 0;  // of its node
  std::size_t begin = 0, end = 0;
  unsigned buffer = 0;  // in which its records are
  bool enters_surface = false;
  Moments moments = {};   // of a node that does
  unsigned depth = 0;     // below the root of the octree or the quadtree
  LocalFrame frame = {};  // of one below

  std::size_t size() const { return end - begin; }
};

class Construction {
 public:
  Construction(std::size_t count, const Options& options, float diagonal, std::vector<std::uint32_t>& order,
               const Workers& workers)
      : count_(count), options_(options), diagonal_(diagonal), order_(order), workers_(workers) {
    order.resize(count);
    const std::size_t bytes = std::max<std::size_t>(1, count) * sizeof(Record);
    for (auto& buffer : buffers_) {  // stays as it is until written, so that threads share that
      buffer.reset(static_cast<Record*>(operator new (bytes, std::align_val_t{alignof(Record)})));
    }
  }

  // position(i) gives the i-th point within the cube, normal(i) its normal.
  template <typename Position, typename Normal>
  Nodes run(const Position& position, const Normal& normal);

 private:
  friend class Emission;

  std::span<Record> records(unsigned buffer, std::size_t begin, std::size_t end) {
    return {buffers_[buffer].get() + begin, end - begin};
  }
  template <typename Position, typename Normal>
  std::vector<std::uint32_t> fill(unsigned levels, const Position& position, const Normal& normal);
  Cells sort_cubes(const Task& task);
  Cells sort_rectangles(const Task& task);
  void carry_out(Nodes& out, Task& task);
  void finish(Nodes& out, std::vector<Task>& tasks);
  float error_of(const Moments& moments, std::span<const Record> records) const;
  bool is_leaf(const Node& node, const Moments& moments) const;
  void close(std::uint32_t begin, std::span<const Record> records);

  struct Release {
    void operator()(Record* records) const { operator delete (records, std::align_val_t{alignof(Record)}); }
  };
  std::size_t count_;
  Options options_;
  float diagonal_;
  std::vector<std::uint32_t>& order_;
  const Workers& workers_;
  std::unique_ptr<Record[], Release> buffers_[2];
};

float Construction::error_of(const Moments& moments, std::span<const Record> records) const {
  switch (options_.metric) {
    case Metric::l2: return std::sqrt(moments.plane_error()) / diagonal_;
    case Metric::l21: return std::sqrt(moments.normal_error());
    case Metric::qef: return std::sqrt(best_point_error(records, moments)) / diagonal_;
    case Metric::density: break;
  }
  return moments.count();
}

bool Construction::is_leaf(const Node& node, const Moments& moments) const {
  return node.error <= options_.threshold || node.size() <= options_.least_samples || moments.at_one_point();
}

// The samples of a leaf, in their order from now on.
void Construction::close(std::uint32_t begin, std::span<const Record> records) {
  for (const Record& record : records) order_[begin++] = record.index();
}

// Nodes from the cells of one sort, the coarsest first.
class Emission {
 public:
  // sorted: the node whose samples were sorted, with the buffer that they are in now.
  Emission(Construction& owner, Nodes& out, const Cells& cells, const Task& sorted, Kind kind)
      : owner_(owner), out_(out), cells_(cells), sorted_(sorted), kind_(kind) {}

  void children_of(std::uint32_t slot, unsigned level, std::uint32_t index) {
    const std::vector<Cell>& fine = cells_.levels[level + 1];
    const std::uint32_t first = cells_.levels[level][index].first_child;
    const std::uint32_t last = cells_.levels[level][index + 1].first_child;
    if (kind_ == Kind::surface && last - first > 1 && close_in_pairs(slot, {&fine[first], last - first})) return;
    const auto first_slot = static_cast<std::uint32_t>(out_.nodes.size());
    Node child;
    child.frame = out_.nodes[slot].frame;
    child.kind = kind_;
    child.level = static_cast<std::uint8_t>(out_.nodes[slot].level + 1);
    unsigned children = 0;
    for (std::uint32_t i = first; i < last; ++i) {
      children |= 1U << (fine[i].key & (kind_ == Kind::volume ? 7U : 3U));
      child.begin = static_cast<std::uint32_t>(sorted_.begin) + fine[i].begin;
      child.end = static_cast<std::uint32_t>(sorted_.begin) + fine[i + 1].begin;
      out_.nodes.push_back(child);
    }
    out_.nodes[slot].first_child = first_slot;
    out_.nodes[slot].children = static_cast<std::uint8_t>(children);
    for (std::uint32_t i = first; i < last; ++i) node(first_slot + (i - first), level + 1, i);
  }

  // What becomes of the node in the slot, whose cell this is.
  void node(std::uint32_t slot, unsigned level, std::uint32_t index) {
    const Moments& moments = cells_.levels[level][index].moments;
    Node& node = out_.nodes[slot];
    const std::span<Record> records = owner_.records(sorted_.buffer, node.begin, node.end);
    const Options& options = owner_.options_;
    node.error = owner_.error_of(moments, records);
    const unsigned depth = sorted_.depth + level;
    if (kind_ == Kind::volume && options.surface &&
        is_height_field(records, moments, options.delta_a, options.delta_d)) {
      Task task = task_of(slot, depth);
      task.enters_surface = true;
      task.moments = moments;
      hand_over(task);
    } else if (owner_.is_leaf(node, moments) || depth == (kind_ == Kind::volume ? octree_levels : quadtree_levels)) {
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
  // Whether two quadrants together are a leaf already; its error then.
  bool are_leaf(const Cell* const a, const Cell* const b, float& error) const {
    if (a == nullptr || b == nullptr) return false;
    Moments moments = a->moments;
    moments.add(b->moments);
    error = owner_.error_of(moments, {});
    return error <= owner_.options_.threshold;
  }

  // The quadrants of a node as leaves of two, if that is all that it takes. False if not: nothing has changed then.
  bool close_in_pairs(std::uint32_t slot, std::span<const Cell> children) {
    if (owner_.options_.metric == Metric::qef) return false;  // its errors do not add up
    const Cell* quadrants[4] = {};
    for (const Cell& child : children) quadrants[child.key & 3U] = &child;
    constexpr unsigned pairs[2][2][2] = {{{0, 1}, {2, 3}}, {{0, 2}, {1, 3}}};
    for (unsigned way = 0; way < 2; ++way) {
      float errors[2] = {};
      bool joined[2] = {};
      bool enough = true;
      for (unsigned i = 0; i < 2; ++i) {
        const Cell* const a = quadrants[pairs[way][i][0]];
        const Cell* const b = quadrants[pairs[way][i][1]];
        joined[i] = are_leaf(a, b, errors[i]);
        if (joined[i] || (a == nullptr && b == nullptr)) continue;
        const Cell* const only = a != nullptr ? a : b;
        errors[i] = owner_.error_of(only->moments, {});
        enough &= (a == nullptr || b == nullptr) && errors[i] <= owner_.options_.threshold;
      }
      if (!enough || !(joined[0] || joined[1])) continue;
      write_pairs(slot, quadrants, pairs[way], errors);
      out_.nodes[slot].joined = static_cast<std::uint8_t>(((joined[0] ? 1U : 0U) | (joined[1] ? 2U : 0U)) << (2 * way));
      return true;
    }
    return false;
  }

  void write_pairs(std::uint32_t slot, const Cell* const (&quadrants)[4], const unsigned (&pairs)[2][2],
                   const float (&errors)[2]) {
    Node child;
    child.frame = out_.nodes[slot].frame;
    child.kind = kind_;
    child.level = static_cast<std::uint8_t>(out_.nodes[slot].level + 1);
    child.end = out_.nodes[slot].begin;
    out_.nodes[slot].first_child = static_cast<std::uint32_t>(out_.nodes.size());
    // In the order of their first quadrants with samples.
    const unsigned first = quadrants[0] == nullptr && pairs[1][0] == 1 ? 1 : 0;
    for (const unsigned i : {first, 1 - first}) {
      child.begin = child.end;
      child.error = errors[i];
      for (const unsigned quadrant : pairs[i]) {
        const Cell* const cell = quadrants[quadrant];
        if (cell == nullptr) continue;
        const std::size_t begin = sorted_.begin + cell->begin, end = sorted_.begin + (cell + 1)->begin;
        owner_.close(child.end, owner_.records(sorted_.buffer, begin, end));
        child.end += static_cast<std::uint32_t>(end - begin);
        out_.nodes[slot].children = static_cast<std::uint8_t>(out_.nodes[slot].children | (1U << quadrant));
      }
      if (child.end > child.begin) out_.nodes.push_back(child);
    }
  }

  Task task_of(std::uint32_t slot, unsigned depth) const {
    Task task;
    task.slot = slot;
    task.begin = out_.nodes[slot].begin;
    task.end = out_.nodes[slot].end;
    task.buffer = sorted_.buffer;
    task.depth = depth;
    task.frame = sorted_.frame;
    return task;
  }

  void hand_over(Task& task) {
    if (sorted_.size() > samples_alone) {
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
  std::vector<Task> tasks_;
};

void Construction::carry_out(Nodes& out, Task& task) {
  Node& node = out.nodes[task.slot];
  if (task.enters_surface) {
    const std::span<Record> mine = records(task.buffer, task.begin, task.end);
    task.frame = enter_frame(mine, task.moments);
    task.depth = 0;
    node.kind = Kind::transition;
    node.frame = static_cast<std::uint32_t>(out.frames.size());
    out.frames.push_back(task.frame);
    out.frame_nodes.push_back(task.slot);
    if (is_leaf(node, task.moments)) {
      close(node.begin, mine);
      return;
    }
  }
  const Kind kind = node.kind == Kind::volume ? Kind::volume : Kind::surface;
  const Cells cells = kind == Kind::volume ? sort_cubes(task) : sort_rectangles(task);
  task.buffer = 1 - task.buffer;
  Emission emission(*this, out, cells, task, kind);
  emission.children_of(task.slot, 0, 0);
  emission.finish();
}

Cells Construction::sort_cubes(const Task& task) {
  const std::span<const Record> from = records(task.buffer, task.begin, task.end);
  const std::span<Record> to = records(1 - task.buffer, task.begin, task.end);
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
  return cells_of(to, begins, levels, 3, workers_);
}

Cells Construction::sort_rectangles(const Task& task) {
  const std::span<const Record> from = records(task.buffer, task.begin, task.end);
  const std::span<Record> to = records(1 - task.buffer, task.begin, task.end);
  const unsigned levels =
      std::min(levels_for(task.size(), samples_a_rectangle, most_rectangle_levels), quadtree_levels - task.depth);
  const unsigned shift = quadtree_levels - task.depth - levels;
  const std::uint32_t mask = (1U << levels) - 1;
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [u, v] = task.frame.cell(from[i].position);
      *keys++ = every_second_bit((u >> shift) & mask) | (every_second_bit((v >> shift) & mask) << 1);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) to[*slots++] = from[i];
  };
  const auto begins = sort_by_key(task.size(), std::size_t{1} << (2 * levels), key, move, workers_);
  return cells_of(to, begins, levels, 2, workers_);
}

// Each task in nodes of its own, which follow one another as the tasks do, whichever thread takes one first.
void Construction::finish(Nodes& out, std::vector<Task>& tasks) {
  std::vector<Nodes> parts(tasks.size());
  workers_.each(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t slot = std::exchange(tasks[i].slot, 0);
      parts[i].nodes.push_back(out.nodes[slot]);
      carry_out(parts[i], tasks[i]);
      tasks[i].slot = slot;
    }
  });
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const bool has_frames = !tasks[i].enters_surface && parts[i].nodes[0].kind == Kind::surface;
    const auto frame_shift = static_cast<std::uint32_t>(out.frames.size());
    const auto shift = static_cast<std::uint32_t>(out.nodes.size() - 1);
    const auto slot_of = [&](std::uint32_t mine) { return mine == 0 ? tasks[i].slot : mine + shift; };
    for (std::uint32_t k = 0; k < parts[i].nodes.size(); ++k) {
      Node node = parts[i].nodes[k];
      if (!node.is_leaf()) node.first_child += shift;
      if (!has_frames && node.frame != none) node.frame += frame_shift;
      if (k == 0) {
        out.nodes[tasks[i].slot] = node;
      } else {
        out.nodes.push_back(node);
      }
    }
    out.frames.insert(out.frames.end(), parts[i].frames.begin(), parts[i].frames.end());
    for (const std::uint32_t node : parts[i].frame_nodes) out.frame_nodes.push_back(slot_of(node));
    parts[i] = {};
  }
}

// The records of all points, sorted into the first levels of the octree.
template <typename Position, typename Normal>
std::vector<std::uint32_t> Construction::fill(unsigned levels, const Position& position, const Normal& normal) {
  const unsigned shift = octree_levels - levels;
  Record* const to = buffers_[0].get();
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [x, y, z] = octree_cell(position(i));
      *keys++ = every_third_bit(x >> shift) | (every_third_bit(y >> shift) << 1) | (every_third_bit(z >> shift) << 2);
    }
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) {
      Record record;
      record.position = position(i);
      record.position[3] = std::bit_cast<float>(static_cast<std::uint32_t>(i));
      record.normal = normal(i);
      to[*slots++] = record;
    }
  };
  return sort_by_key(count_, std::size_t{1} << (3 * levels), key, move, workers_);
}

template <typename Position, typename Normal>
Nodes Construction::run(const Position& position, const Normal& normal) {
  Nodes result;
  if (count_ == 0) return result;
  Task all;
  all.end = count_;
  const unsigned levels = levels_for(count_, samples_a_cube, most_cube_levels);
  const std::vector<std::uint32_t> begins = fill(levels, position, normal);
  const Cells cells = cells_of(records(0, 0, count_), begins, levels, 3, workers_);
  result.nodes.push_back({});
  result.nodes[0].end = static_cast<std::uint32_t>(count_);
  Emission emission(*this, result, cells, all, Kind::volume);
  emission.node(0, 0, 0);
  emission.finish();
  return result;
}

}  // namespace

Nodes construct(std::span<const Float4> points, std::span<const Float4> normals, const Options& options, float diagonal,
                std::vector<std::uint32_t>& order, const Workers& workers) {
  return Construction(points.size(), options, diagonal, order, workers)
      .run([&](std::size_t i) { return points[i]; }, [&](std::size_t i) { return normals[i]; });
}

Nodes construct(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
                const Workers& workers) {
  return Construction(points.positions.size() / 3, options, cube.diagonal, order, workers)
      .run([&](std::size_t i) { return cube.inside(points.positions.data() + 3 * i); },
           [&](std::size_t i) { return unit_normal(points.normals.data() + 3 * i); });
}

}  // namespace glark::vstree
