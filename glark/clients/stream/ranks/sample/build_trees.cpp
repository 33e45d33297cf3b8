// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/build_trees.h"

#include <algorithm>
#include <mutex>

#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/sample/open_changes.h"
#include "glark/clients/stream/ranks/sample/send_points.h"
#include "glark/clients/stream/sample/pass/cell_trees.h"
#include "glark/clients/stream/sample/pass/local_points.h"
#include "glark/clients/stream/sample/pass/open_memory.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t points_at_once = 1 << 12;

// Calls visit(points) for the points of an owned cell, in order, and stops if it returns false. Returns false then.
template <class Sent, class Visit>
bool each_point(const BuildInput& input, std::size_t owned, const Visit& visit) {
  const std::uint64_t count = input.plan.cells[input.shares.owned[owned]].count;
  std::vector<Sent> points;
  for (std::uint64_t done = 0; done < count; done += points.size()) {
    points.resize(static_cast<std::size_t>(std::min(points_at_once, count - done)));
    input.file.read(owned, done, bytes_of(points));
    if (!visit(std::span<const Sent>(points))) return false;
  }
  return true;
}

// Sums up the points of a cell as the single process does while it streams, and notes how its memory grows.
class StreamedCell {
 public:
  StreamedCell(const BuildInput& input, std::size_t owned) : input_(input), owned_(owned) {}

  // Returns false if there are too many micro-clusters for a tree.
  bool fill() {
    const bool is_whole = each_point<StreamedPoint>(input_, owned_, [&](std::span<const StreamedPoint> points) {
      for (const StreamedPoint& point : points) add(point);
      return table_.size() <= input_.plan.tree_clusters;
    });
    change_to(0);  // a finished cell has no table
    return is_whole;
  }
  SummedCell take() { return {input_.shares.owned[owned_], table_.take(), 0}; }
  const std::vector<OpenChange>& changes() const { return changes_; }

 private:
  void add(const StreamedPoint& point) {
    if (point.batch != batch_) {
      if (begun_) change_to(sizeof(MicroTable) + table_.bytes());
      batch_ = point.batch;
    }
    begun_ = true;
    table_.add(MicroTable::part_of(point.point.key), point.point, input_.kind.has_normals);
  }
  // The table has so many bytes after the batch.
  void change_to(std::size_t bytes) {
    if (bytes != bytes_)
      changes_.push_back({batch_, static_cast<std::int64_t>(bytes) - static_cast<std::int64_t>(bytes_)});
    bytes_ = bytes;
  }

  const BuildInput& input_;
  std::size_t owned_;
  MicroTable table_;
  bool begun_ = false;
  std::uint32_t batch_ = 0;
  std::size_t bytes_ = 0;
  std::vector<OpenChange> changes_;
};

SummedCell summed_shuffled(const BuildInput& input, std::size_t owned) {
  const std::size_t cell = input.shares.owned[owned];
  const double half = input.plan.side(cell) / 2;
  for (unsigned fewer = 0;; ++fewer) {
    MicroTable table;
    const CellFrame frame({-half, -half, -half}, input.plan.side(cell), input.plan.bits(cell) - fewer);
    const bool fits = each_point<ShuffledPoint>(input, owned, [&](std::span<const ShuffledPoint> points) {
      for (const ShuffledPoint& point : points) add_stored(point.point, frame, input.kind, table);
      return table.size() <= input.plan.tree_clusters;
    });
    if (fits) return {cell, table.take(), fewer};
  }
}

// Calls sum_up(owned) for each owned cell, some at a time, and builds the trees of the results.
template <class SumUp>
void build(const BuildInput& input, TreeStore& trees, const SumUp& sum_up) {
  const std::size_t count = input.shares.owned.size();
  for (std::size_t first = 0; first < count; first += trees_at_a_time) {
    std::vector<SummedCell> cells(std::min(trees_at_a_time, count - first));
    input.workers.each(cells.size(), 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) cells[i] = sum_up(first + i);
    });
    std::erase_if(cells, [](const SummedCell& cell) { return cell.clusters.empty(); });
    put_trees(cells, input.plan, input.kind.has_normals, input.workers, trees);
    trim_memory(input.plan.memory);
  }
}

}  // namespace

bool build_streamed_trees(Ranks& ranks, const BuildInput& input, TreeStore& trees) {
  std::vector<OpenChange> changes;
  std::mutex mutex;
  bool fits = true;
  together(ranks, [&] {
    build(input, trees, [&](std::size_t owned) {
      StreamedCell cell(input, owned);
      const bool is_small = cell.fill();
      const std::lock_guard lock(mutex);
      fits = fits && is_small;
      changes.insert(changes.end(), cell.changes().begin(), cell.changes().end());
      return is_small ? cell.take() : SummedCell{};
    });
  });
  if (sum(ranks, fits ? 0 : 1) > 0) return false;
  const std::uint64_t batch = batch_size(input.plan);
  return fit_in_open_memory(ranks, input.plan, (input.points + batch - 1) / batch, changes);
}

void build_shuffled_trees(Ranks& ranks, const BuildInput& input, TreeStore& trees) {
  together(ranks, [&] { build(input, trees, [&](std::size_t owned) { return summed_shuffled(input, owned); }); });
}

}  // namespace glark::stream
