// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/edit/sampling_in_cells.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "glark/clients/stream/edit/same_order.h"
#include "glark/clients/stream/edit/sample_pairs.h"
#include "glark/clients/stream/edit/turned_normals.h"
#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/samples/cells/cell_builder.h"

namespace glark::stream {
namespace {

using common::Vector3f;

// An edited channel: its columns in both files.
struct EditedColumn {
  std::size_t after = 0;
  std::size_t before = none;  // none: it is new
};

Vector3f relative(std::span<const double> positions, std::size_t i, const std::array<double, 3>& origin) {
  return {static_cast<float>(positions[3 * i] - origin[0]), static_cast<float>(positions[3 * i + 1] - origin[1]),
          static_cast<float>(positions[3 * i + 2] - origin[2])};
}

// Reads the pairs twice: to find out what was edited and where the samples are, and to make the cells.
class CellReader {
 public:
  CellReader(const SamplingFiles& files, const SamplingMemory& memory, std::size_t threads)
      : files_(files), pairs_(files.from, files.to, files.folder), memory_(memory), threads_(threads) {
    require_possible();
    survey();
  }

  Sampling read(const common::Workers& workers) {
    const CellPlan plan = plan_cells(memory_, pairs_.count(), columns_.size(), threads_);
    TriedSamples tried(pairs_.count());
    auto store = std::make_unique<SamplesInCells>(build(plan, tried), plan);
    if (sampling_.is_deformed) {
      if (channel_index(pairs_.after(), "index") == none) tried.require_same_order(*store, files_.to.string());
      turn_normals(*store, workers);
    }
    sampling_.store = std::move(store);
    return std::move(sampling_);
  }

 private:
  void require_possible() const {
    if (pairs_.count() > std::numeric_limits<std::uint32_t>::max())
      throw Error(Element::file, 0,
                  fmt::format("{}: has {} samples; at most 4294967295 are possible: take fewer", files_.from.string(),
                              pairs_.count()));
    if (!pairs_.before().normals)
      throw Error(Element::file, 0,
                  fmt::format("{}: has no normals, and they are estimated only in memory; raise the memory to about {} "
                              "bytes, or write the sampling as PLY",
                              files_.from.string(), bytes_in_memory(files_).reading / 2 * 3));
  }

  void survey() {
    std::vector<bool> is_edited(pairs_.after().channels.size());
    bool is_first = true;
    pairs_.each([&](const SamplePair& pair) {
      if (is_first) std::copy_n(pair.before.positions.begin(), 3, sampling_.origin.begin());
      for (std::size_t i = 0; i < pair.before.size(); ++i) {
        const Vector3f before = relative(pair.before.positions, i, sampling_.origin);
        sampling_.is_deformed |= !(before == relative(pair.positions, i, sampling_.origin));
        box_.low = is_first ? before : common::least(box_.low, before);
        box_.high = is_first ? before : common::greatest(box_.high, before);
        is_first = false;
        for (std::size_t k = 0; k < is_edited.size(); ++k)
          if (!is_edited[k]) is_edited[k] = is_edited_at(pair, i, column(k));
      }
    });
    for (std::size_t k = 0; k < is_edited.size(); ++k) {
      if (!is_edited[k] || pairs_.after().channels[k].name == "index") continue;
      columns_.push_back(column(k));
      sampling_.channels.push_back(pairs_.after().channels[k]);
    }
  }

  std::unique_ptr<SampleCells> build(const CellPlan& plan, TriedSamples& tried) const {
    CellBuilder builder(plan, box_, columns_.size(), files_.folder);
    std::vector<float> values(columns_.size());
    std::vector<std::uint8_t> edited(columns_.size());
    pairs_.each([&](const SamplePair& pair) {
      for (std::size_t i = 0; i < pair.before.size(); ++i) {
        for (std::size_t k = 0; k < columns_.size(); ++k) {
          values[k] = static_cast<float>(after(pair, i, columns_[k]));
          edited[k] = is_edited_at(pair, i, columns_[k]) ? 1 : 0;
        }
        const std::uint64_t index = pair.before.first + i;
        const SampleRow row{static_cast<std::uint32_t>(index),
                            relative(pair.before.positions, i, sampling_.origin),
                            relative(pair.positions, i, sampling_.origin),
                            common::unit(common::vector_at(pair.before.normals, i)),
                            values,
                            edited};
        tried.add(static_cast<std::size_t>(index), row.before, row.after);
        builder.add(row);
      }
    });
    std::unique_ptr<SampleCells> cells = builder.finish();
    trim_memory(0);
    return cells;
  }

  EditedColumn column(std::size_t after) const {
    return {after, channel_index(pairs_.before(), pairs_.after().channels[after].name)};
  }
  double after(const SamplePair& pair, std::size_t i, const EditedColumn& column) const {
    return pair.channels[pairs_.after().channels.size() * i + column.after];
  }
  bool is_edited_at(const SamplePair& pair, std::size_t i, const EditedColumn& column) const {
    const std::size_t width = pairs_.before().channels.size();
    return column.before == none || after(pair, i, column) != pair.before.channels[width * i + column.before];
  }

  const SamplingFiles& files_;
  SamplePairs pairs_;
  SamplingMemory memory_;
  std::size_t threads_;
  CellBox box_;
  std::vector<EditedColumn> columns_;
  Sampling sampling_;
};

}  // namespace

Sampling read_into_cells(const SamplingFiles& files, const SamplingMemory& memory, const common::Workers& workers) {
  return CellReader(files, memory, workers.count()).read(workers);
}

}  // namespace glark::stream
