// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cells that are in memory: when it is full, the least recently used one goes.
// Based on: Boubekeur 2007, Annex 10, full scalability. There, a cell that goes leaves one sample, because an editor must
// stay interactive. Here it leaves nothing, so that the result does not depend on the memory.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "glark/clients/stream/samples/cells/cell_plan.h"
#include "glark/clients/stream/samples/cells/sample_cells.h"

namespace glark::stream {

class CellCache {
 public:
  // Beyond plan.cache come the cells that threads are using at the moment: each thread should use one at a time, and may
  // be loading another.
  CellCache(const SampleCells& file, const CellPlan& plan) : file_(file), plan_(plan), slots_(file.cells()) {}

  // Several threads may call it. The cell stays as long as the result is kept. Throws Error if it cannot be read.
  std::shared_ptr<const LoadedCell> get(std::uint32_t cell) const;
  // Forgets all cells: the file was changed.
  void clear();
  // How often a cell was read from the file.
  std::uint64_t loads() const { return loads_; }

 private:
  static constexpr std::uint32_t nothing = static_cast<std::uint32_t>(-1);
  struct Slot {
    std::shared_ptr<const LoadedCell> cell;
    std::uint32_t newer = nothing, older = nothing;  // in the list of the cells in memory
  };

  std::shared_ptr<const LoadedCell> find(std::uint32_t cell) const;
  bool keep(std::uint32_t cell, std::shared_ptr<const LoadedCell>& loaded) const;
  void link_newest(std::uint32_t cell) const;
  void unlink(std::uint32_t cell) const;
  std::size_t bytes_of(std::uint32_t cell) const { return cell_bytes(file_.size_of(cell), file_.channels()); }

  const SampleCells& file_;
  CellPlan plan_;
  mutable std::mutex mutex_;
  mutable std::vector<Slot> slots_;
  mutable std::uint32_t newest_ = nothing, oldest_ = nothing;
  mutable std::size_t bytes_ = 0, freed_ = 0;
  mutable std::atomic<std::uint64_t> loads_ = 0;
};

}  // namespace glark::stream
