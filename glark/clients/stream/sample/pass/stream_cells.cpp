// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 4.3, algorithm 2. A cell holds micro-clusters instead of points.
#include <algorithm>
#include <bit>
#include <cstring>

#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/sample/pass/local_points.h"
#include "glark/clients/stream/sample/pass/open_memory.h"

namespace glark::stream {
namespace {

constexpr std::size_t bytes_a_point = 256;  // of open_bytes, for each point of a batch
constexpr double most_open_share = 1.4;     // of open_bytes, at any time
constexpr std::size_t least_batch = 1 << 15, most_batch = 1 << 16;

}  // namespace

std::size_t batch_size(const Plan& plan) {
  return std::clamp(std::bit_ceil(plan.open_bytes / bytes_a_point), least_batch, most_batch);
}

bool fits_in_open_memory(const Plan& plan, std::size_t bytes, std::uint64_t batches) {
  return static_cast<double>(bytes) <= most_open_share * static_cast<double>(plan.open_bytes) &&
         (batches % 32 != 0 || bytes <= plan.open_bytes);
}

namespace {

class CellStream {
 public:
  CellStream(const PassInput& input, TreeStore& trees)
      : input_(input),
        plan_(input.plan),
        trees_(trees),
        kind_(input.source.schema()),
        batch_(batch_size(input.plan)),
        tables_(plan_.cells.size()),
        missing_(plan_.cells.size()) {
    for (std::size_t i = 0; i < missing_.size(); ++i) missing_[i] = plan_.cells[i].count;
  }

  bool run() {
    std::uint64_t done = begin();
    for (std::uint64_t read = 1; read > 0;) {
      read = input_.source.each(done, done + batch_.size(), [&](const Points& points) { locate(points, done); });
      if (!add(std::span(batch_).first(static_cast<std::size_t>(read)))) return false;
      done += read;
      trim_memory(plan_.memory);
      if (input_.advance) input_.advance(done);
      if (input_.checkpoints.is_due(done)) save(done);
    }
    if (done != input_.census.points || finished_ != plan_.cells.size()) fail_as_changed(input_.source.name());
    return true;
  }

 private:
  static constexpr const char* state_name = "stream";

  // Restores the state of an earlier run. Returns the number of points that it has finished; 0 without a state.
  std::uint64_t begin() {
    std::uint64_t done = 0;
    const bool is_begun = input_.checkpoints.folder().load(state_name, [&](common::StateReader& state) {
      std::uint64_t finished = 0;
      std::vector<std::uint64_t> missing;
      if (!state.get(done) || !state.get(finished) || !state.get_all(missing) || missing.size() != missing_.size() ||
          !trees_.load(state))
        return false;
      for (std::size_t cell = 0; cell < tables_.size(); ++cell) {
        if (missing[cell] == 0 || missing[cell] == missing_[cell]) continue;  // complete, or not begun
        tables_[cell] = std::make_unique<MicroTable>();
        if (!tables_[cell]->load(state)) return false;
      }
      finished_ = static_cast<std::size_t>(finished);
      missing_ = std::move(missing);
      return true;
    });
    if (!is_begun) {
      done = 0;
      for (auto& table : tables_) table.reset();
    }
    input_.checkpoints.begin(done);
    return done;
  }

  void save(std::uint64_t done) {
    input_.checkpoints.folder().save(state_name, [&](common::StateWriter& state) {
      state.put(done);
      state.put(std::uint64_t{finished_});
      state.put_all(std::span<const std::uint64_t>(missing_));
      trees_.save(state);
      for (const auto& table : tables_)
        if (table) table->save(state);
    });
  }

  // Fills the batch with a piece of the stream.
  void locate(const Points& points, std::uint64_t begin) {
    CellFinder finder(plan_, input_.source.name());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t cell = finder.find(&points.positions[3 * i]);
      batch_[static_cast<std::size_t>(points.first + i - begin)] = local_point(finder, cell, kind_, points, i);
    }
  }

  // Each thread adds to parts of its own, so that the sums have the order of the stream.
  bool add(std::span<const LocalPoint> points) {
    for (const LocalPoint& point : points)
      if (point.cell != no_cell && !tables_[point.cell]) tables_[point.cell] = std::make_unique<MicroTable>();
    const std::size_t owners = std::min<std::size_t>(input_.workers.count(), MicroTable::parts);
    input_.workers.each(owners, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t owner = first; owner < last; ++owner)
        for (const LocalPoint& point : points) {
          const unsigned part = MicroTable::part_of(point.key);
          if (point.cell != no_cell && part % owners == owner) tables_[point.cell]->add(part, point, kind_.has_normals);
        }
    });
    std::vector<std::uint32_t> complete;
    for (const LocalPoint& point : points) {
      if (point.cell == no_cell) continue;
      if (missing_[point.cell] == 0) fail_as_changed(input_.source.name());
      if (--missing_[point.cell] == 0) complete.push_back(point.cell);
    }
    if (!finish_all(complete)) return false;
    finished_ += complete.size();
    return fits_in_open_memory(plan_, open_bytes(), ++batches_);
  }

  // Builds the trees of these cells, several at a time as the memory allows. Returns false if one cell alone is too large.
  bool finish_all(std::span<const std::uint32_t> cells) {
    while (!cells.empty()) {
      std::size_t count = 0;
      for (std::size_t clusters = 0; count < std::min(trees_at_a_time, cells.size()); ++count) {
        clusters += tables_[cells[count]]->size();
        if (clusters > plan_.tree_clusters) break;
      }
      if (count == 0) return false;
      input_.workers.each(count, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) finish(cells[i]);
      });
      cells = cells.subspan(count);
    }
    return true;
  }

  void finish(std::uint32_t cell) {
    std::vector<MicroCluster> clusters = tables_[cell]->take();
    tables_[cell].reset();
    trees_.put(cell, cluster_tree(clusters, plan_.tree_options(cell, kind_.has_normals)));
  }

  std::size_t open_bytes() const {
    std::size_t bytes = 0;
    for (const auto& table : tables_)
      if (table) bytes += sizeof(MicroTable) + table->bytes();
    return bytes;
  }

  const PassInput& input_;
  const Plan& plan_;
  TreeStore& trees_;
  PointKind kind_;
  std::vector<LocalPoint> batch_;
  std::vector<std::unique_ptr<MicroTable>> tables_;  // of the unfinished cells
  std::vector<std::uint64_t> missing_;               // points of each cell that are still to come
  std::size_t finished_ = 0, batches_ = 0;
};

}  // namespace

bool stream_cells(const PassInput& input, TreeStore& trees) { return CellStream(input, trees).run(); }

}  // namespace glark::stream
