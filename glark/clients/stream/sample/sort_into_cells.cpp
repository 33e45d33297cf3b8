// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// For streams without coherence. The count of each cell is known, so that each cell has its place in one file.
#include <algorithm>

#include "glark/clients/stream/sample/local_points.h"

namespace glark::stream {
namespace {

constexpr std::size_t batch_size = 1 << 15, read_size = 1 << 13;
constexpr float normal_steps = 32767;

struct StoredPoint {
  std::array<float, 3> from_centre{};
  std::array<std::int16_t, 3> normal{};
  std::array<std::uint8_t, 4> colour{};
};

class CellSorter {
 public:
  CellSorter(const PassInput& input, const std::filesystem::path& folder, TreeStore& trees)
      : input_(input),
        plan_(input.plan),
        trees_(trees),
        kind_(input.source.schema()),
        file_(folder),
        begins_(plan_.cells.size()),
        written_(plan_.cells.size()),
        buffers_(plan_.cells.size()),
        cells_(batch_size),
        batch_(batch_size) {
    std::uint64_t begin = 0;
    for (std::size_t i = 0; i < begins_.size(); ++i) {
      begins_[i] = begin;
      begin += plan_.cells[i].count;
    }
    buffer_size_ = std::clamp<std::size_t>(plan_.open_bytes / sizeof(StoredPoint) / begins_.size(), 16, 1 << 16);
  }

  void run() {
    sort();
    const Advance& advance = input_.advance;
    std::size_t done = 0;
    const std::size_t group = trees_at_a_time;
    for (std::size_t first = 0; first < begins_.size(); first += group) {
      const std::size_t last = std::min(begins_.size(), first + group);
      input_.workers.each(last - first, 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) build_tree(first + i);
      });
      for (std::size_t i = first; i < last; ++i) done += plan_.cells[i].count;
      if (advance) advance(input_.census.points / 2 + done / 2);
    }
  }

 private:
  void sort() {
    std::uint64_t done = 0;
    for (std::uint64_t read = 1; read > 0; done += read) {
      read = input_.source.each(done, done + batch_size, [&](const Points& points) { locate(points, done); });
      for (std::size_t i = 0; i < read; ++i)
        if (cells_[i] != no_cell) add(cells_[i], batch_[i]);
      if (input_.advance) input_.advance((done + read) / 2);
    }
    for (std::uint32_t cell = 0; cell < buffers_.size(); ++cell) {
      flush(cell);
      buffers_[cell] = {};
      if (written_[cell] != plan_.cells[cell].count) fail_as_changed(input_.source.name());
    }
  }

  void locate(const Points& points, std::uint64_t begin) {
    CellFinder finder(plan_, input_.source.name());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto slot = static_cast<std::size_t>(points.first + i - begin);
      cells_[slot] = finder.find(&points.positions[3 * i]);
      if (cells_[slot] == no_cell) continue;
      const std::array<double, 3> centre = plan_.centre(cells_[slot]);
      StoredPoint& point = batch_[slot];
      const std::array<float, 3> normal = kind_.has_normals ? unit_normal_of(points, i) : std::array<float, 3>{};
      for (std::size_t k = 0; k < 3; ++k) {
        point.from_centre[k] = static_cast<float>(points.positions[3 * i + k] - centre[k]);
        point.normal[k] = static_cast<std::int16_t>(std::lround(normal_steps * normal[k]));
      }
      point.colour = kind_.colour_of(points, i);
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
    file_.write((begins_[cell] + written_[cell]) * sizeof(StoredPoint),
                {reinterpret_cast<const char*>(buffer.data()), buffer.size() * sizeof(StoredPoint)});
    written_[cell] += buffer.size();
    buffer.clear();
  }

  void build_tree(std::size_t cell) {
    MicroTable table;
    std::vector<StoredPoint> points;
    for (std::uint64_t done = 0; done < plan_.cells[cell].count; done += points.size()) {
      points.resize(static_cast<std::size_t>(std::min<std::uint64_t>(read_size, plan_.cells[cell].count - done)));
      file_.read((begins_[cell] + done) * sizeof(StoredPoint),
                 {reinterpret_cast<char*>(points.data()), points.size() * sizeof(StoredPoint)});
      for (const StoredPoint& stored : points) {
        LocalPoint point;
        place_in_cell({stored.from_centre[0], stored.from_centre[1], stored.from_centre[2]}, plan_.side(cell),
                      plan_.bits(cell), point);
        for (std::size_t k = 0; k < 3; ++k) point.normal[k] = static_cast<float>(stored.normal[k]) / normal_steps;
        point.colour = stored.colour;
        table.add(MicroTable::part_of(point.key), point, kind_.has_normals);
      }
    }
    std::vector<MicroCluster> clusters = table.take();
    trees_.put(cell, cluster_tree(clusters, plan_.tree_options(cell, kind_.has_normals)));
  }

  const PassInput& input_;
  const Plan& plan_;
  TreeStore& trees_;
  PointKind kind_;
  TemporaryFile file_;
  std::vector<std::uint64_t> begins_, written_;  // of each cell, in points
  std::vector<std::vector<StoredPoint>> buffers_;
  std::size_t buffer_size_ = 0;
  std::vector<std::uint32_t> cells_;  // of the points of the batch
  std::vector<StoredPoint> batch_;
};

}  // namespace

void sort_into_cells(const PassInput& input, const std::filesystem::path& folder, TreeStore& trees) {
  CellSorter(input, folder, trees).run();
}

}  // namespace glark::stream
