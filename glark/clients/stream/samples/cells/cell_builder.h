// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes the cells of a sampling that does not fit into memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "glark/clients/stream/files/sorted_records.h"
#include "glark/clients/stream/samples/cells/cell_plan.h"
#include "glark/clients/stream/samples/cells/sample_cells.h"

namespace glark::stream {

// A sample of a sampling with channels.
struct SampleRow {
  std::uint32_t index = 0;
  common::Vector3f before, after, normal;
  std::span<const float> values;
  std::span<const std::uint8_t> is_edited;
};

// The samples are sorted by the Morton codes of their positions, so those of a cube of an octree follow one another. A
// cell ends where the code changes most among the next samples. So cells do not span the gaps between parts.
class CellBuilder {
 public:
  // box: of all positions before the edit. folder: for the temporary files.
  CellBuilder(const CellPlan& plan, const CellBox& box, std::size_t channels, const std::filesystem::path& folder);

  // Throws Error for a full disk.
  void add(const SampleRow& row);
  // Returns the cells of all samples.
  std::unique_ptr<SampleCells> finish();

 private:
  std::uint64_t key_of(const common::Vector3f& position) const;
  void take(std::uint64_t key, std::span<const char> record);
  std::size_t cut_place() const;
  void cut(std::size_t count);

  std::size_t most_, channels_;
  CellBox box_;
  double scale_ = 0;  // from a position to a cube of the octree
  SortedRecords sorted_;
  std::unique_ptr<SampleCells> file_;
  std::vector<char> record_;

  // The next samples in the order of the codes.
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> indices_;
  Samples samples_;
};

}  // namespace glark::stream
