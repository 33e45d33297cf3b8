// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sampling whose cells lie on the disk. The least recently used ones are not in memory.
#pragma once

#include <memory>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/samples/cells/box_tree.h"
#include "glark/clients/stream/samples/cells/cell_cache.h"
#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

class SamplesInCells final : public SampleStore {
 public:
  // file: with at least one cell.
  SamplesInCells(std::unique_ptr<SampleCells> file, const CellPlan& plan);

  std::size_t size() const override { return size_; }
  void nearest(const common::Vector3f& point, std::size_t count, FoundSamples& found) const override;
  void gather(const common::Vector3f& point, std::size_t count, FoundSamples& found) const override;
  void each(const TakeSamples& take) const override;
  std::size_t cells() const override { return file_->cells(); }

  // Sets the normals after the edit. turned(cell, found): the normals of the samples of a cell; several threads call it.
  using Turned = std::function<std::vector<common::Vector3f>(const LoadedCell& cell, FoundSamples& found)>;
  void set_turned_normals(const common::Workers& workers, const Turned& turned);
  std::uint64_t loads() const { return cache_.loads(); }

 private:
  std::unique_ptr<SampleCells> file_;
  CellCache cache_;
  BoxTree tree_;
  std::size_t size_ = 0;
};

}  // namespace glark::stream
