// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// For streams without coherence. The count of each cell is known, so that each cell has its place in one file.
#include <algorithm>

#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/sample/pass/cell_trees.h"
#include "glark/clients/stream/sample/pass/stored_point.h"

namespace glark::stream {
namespace {

constexpr std::size_t points_at_once = 1 << 15, read_size = 1 << 12;

class CellSorter {
 public:
  CellSorter(const PassInput& input, const std::filesystem::path& folder, TreeStore& trees)
      : input_(input),
        plan_(input.plan),
        trees_(trees),
        kind_(input.source.schema()),
        file_(input.checkpoints.folder().is_used()
                  ? std::make_unique<TemporaryFile>(KeptFile{input.checkpoints.folder().path("points")})
                  : std::make_unique<TemporaryFile>(folder)),
        begins_(plan_.cells.size()),
        written_(plan_.cells.size()),
        buffers_(plan_.cells.size()),
        cells_(points_at_once),
        batch_(points_at_once) {
    std::uint64_t begin = 0;
    for (std::size_t i = 0; i < begins_.size(); ++i) {
      begins_[i] = begin;
      begin += plan_.cells[i].count;
    }
    buffer_size_ = std::clamp<std::size_t>(plan_.open_bytes / sizeof(StoredPoint) / begins_.size(), 1, 1 << 16);
  }

  void run() {
    if (!load_trees()) sort();
    for (const std::size_t group = trees_at_a_time; next_cell_ < begins_.size();) {
      const std::size_t first = next_cell_;
      next_cell_ = std::min(begins_.size(), first + group);
      build_trees(first, next_cell_);
      trim_memory(plan_.memory);
      const std::uint64_t done = next_cell_ < begins_.size() ? begins_[next_cell_] : input_.census.points;
      if (input_.advance) input_.advance(input_.census.points / 2 + done / 2);
      if (input_.checkpoints.is_due(done)) save_trees();
    }
  }

 private:
  common::WorkFolder& folder() const { return input_.checkpoints.folder(); }

  bool load_trees() {
    std::uint64_t cell = 0;
    const bool is_begun = folder().load("trees-built", [&](common::StateReader& state) {
      return state.get(cell) && cell <= begins_.size() && trees_.load(state);
    });
    next_cell_ = is_begun ? static_cast<std::size_t>(cell) : 0;
    if (is_begun) input_.checkpoints.begin(next_cell_ < begins_.size() ? begins_[next_cell_] : 0);
    return is_begun;
  }
  void save_trees() {
    folder().save("trees-built", [&](common::StateWriter& state) {
      state.put(std::uint64_t{next_cell_});
      trees_.save(state);
    });
  }

  void sort() {
    std::uint64_t done = load_sorted();
    for (std::uint64_t read = 1; read > 0;) {
      read = input_.source.each(done, done + points_at_once, [&](const Points& points) { locate(points, done); });
      for (std::size_t i = 0; i < read; ++i)
        if (cells_[i] != no_cell) add(cells_[i], batch_[i]);
      done += read;
      if (input_.advance) input_.advance(done / 2);
      if (input_.checkpoints.is_due(done)) save_sorted(done);
    }
    flush_all();
    for (std::uint32_t cell = 0; cell < buffers_.size(); ++cell) {
      buffers_[cell] = {};
      if (written_[cell] != plan_.cells[cell].count) fail_as_changed(input_.source.name());
    }
    input_.checkpoints.begin(0);
    if (folder().is_used()) save_trees();
  }

  std::uint64_t load_sorted() {
    std::uint64_t done = 0;
    std::vector<std::uint64_t> written;
    const bool is_begun = folder().load("sorted", [&](common::StateReader& state) {
      return state.get(done) && state.get_all(written) && written.size() == written_.size();
    });
    if (!is_begun) done = 0;
    if (is_begun) written_ = written;
    input_.checkpoints.begin(done);
    return done;
  }
  void save_sorted(std::uint64_t done) {
    flush_all();
    folder().save("sorted", [&](common::StateWriter& state) {
      state.put(done);
      state.put_all(std::span<const std::uint64_t>(written_));
    });
  }

  void flush_all() {
    for (std::uint32_t cell = 0; cell < buffers_.size(); ++cell) flush(cell);
  }

  void locate(const Points& points, std::uint64_t begin) {
    CellFinder finder(plan_, input_.source.name());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto slot = static_cast<std::size_t>(points.first + i - begin);
      cells_[slot] = finder.find(&points.positions[3 * i]);
      if (cells_[slot] == no_cell) continue;
      batch_[slot] = stored_point(finder.centre(), kind_, points, i);
    }
  }

  void add(std::uint32_t cell, const StoredPoint& point) {
    std::vector<StoredPoint>& buffer = buffers_[cell];
    if (buffer.capacity() == 0) buffer.reserve(buffer_size_);
    buffer.push_back(point);
    if (buffer.size() == buffer_size_) flush(cell);
  }

  void flush(std::uint32_t cell) {
    std::vector<StoredPoint>& buffer = buffers_[cell];
    if (written_[cell] + buffer.size() > plan_.cells[cell].count) fail_as_changed(input_.source.name());
    file_->write((begins_[cell] + written_[cell]) * sizeof(StoredPoint),
                 {reinterpret_cast<const char*>(buffer.data()), buffer.size() * sizeof(StoredPoint)});
    written_[cell] += buffer.size();
    buffer.clear();
  }

  // Sums up the points of a cell. Returns false if there are too many micro-clusters.
  bool fill(MicroTable& table, std::size_t cell, unsigned bits) const {
    const double half = plan_.side(cell) / 2;
    const CellFrame frame({-half, -half, -half}, plan_.side(cell), bits);
    std::vector<StoredPoint> points;
    for (std::uint64_t done = 0; done < plan_.cells[cell].count; done += points.size()) {
      points.resize(static_cast<std::size_t>(std::min<std::uint64_t>(read_size, plan_.cells[cell].count - done)));
      file_->read((begins_[cell] + done) * sizeof(StoredPoint),
                  {reinterpret_cast<char*>(points.data()), points.size() * sizeof(StoredPoint)});
      for (const StoredPoint& stored : points) add_stored(stored, frame, kind_, table);
      if (table.size() > plan_.tree_clusters) return false;
    }
    return true;
  }

  SummedCell summed(std::size_t cell) const {
    for (unsigned fewer = 0;; ++fewer) {
      MicroTable table;
      if (fill(table, cell, plan_.bits(cell) - fewer)) return {cell, table.take(), fewer};
    }
  }

  void build_trees(std::size_t first, std::size_t last) {
    std::vector<SummedCell> cells(last - first);
    input_.workers.each(cells.size(), 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) cells[i] = summed(first + i);
    });
    put_trees(cells, plan_, kind_.has_normals, input_.workers, trees_);
  }

  const PassInput& input_;
  const Plan& plan_;
  TreeStore& trees_;
  PointKind kind_;
  std::unique_ptr<TemporaryFile> file_;
  std::vector<std::uint64_t> begins_, written_;  // of each cell, in points
  std::vector<std::vector<StoredPoint>> buffers_;
  std::size_t buffer_size_ = 0;
  std::size_t next_cell_ = 0;         // whose tree is to be built
  std::vector<std::uint32_t> cells_;  // of the points of the batch
  std::vector<StoredPoint> batch_;
};

}  // namespace

void sort_into_cells(const PassInput& input, const std::filesystem::path& folder, TreeStore& trees) {
  CellSorter(input, folder, trees).run();
}

}  // namespace glark::stream
