// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/cells/cell_cache.h"

#include <utility>

#include "glark/clients/stream/files/trim_memory.h"

namespace glark::stream {
namespace {

constexpr std::size_t trimmed_bytes = 8 << 20;  // freed between two looks at the memory of the process

}  // namespace

std::shared_ptr<const LoadedCell> CellCache::get(std::uint32_t cell) const {
  if (std::shared_ptr<const LoadedCell> found = find(cell)) return found;
  std::shared_ptr<const LoadedCell> loaded = file_.load(cell);  // other threads go on meanwhile
  ++loads_;
  if (keep(cell, loaded)) trim_memory(plan_.process);
  return loaded;
}

void CellCache::clear() {
  const std::lock_guard lock(mutex_);
  slots_.assign(slots_.size(), {});
  newest_ = oldest_ = nothing;
  bytes_ = 0;
}

std::shared_ptr<const LoadedCell> CellCache::find(std::uint32_t cell) const {
  const std::lock_guard lock(mutex_);
  if (slots_[cell].cell && cell != newest_) {
    unlink(cell);
    link_newest(cell);
  }
  return slots_[cell].cell;
}

// If another thread has loaded the same cell, that one stays. Returns true now and then, when cells were freed.
bool CellCache::keep(std::uint32_t cell, std::shared_ptr<const LoadedCell>& loaded) const {
  std::vector<std::shared_ptr<const LoadedCell>> gone;  // freed without the lock
  const std::lock_guard lock(mutex_);
  if (slots_[cell].cell) {
    loaded.swap(gone.emplace_back(slots_[cell].cell));
    return false;
  }
  for (bytes_ += bytes_of(cell); bytes_ > plan_.cache && oldest_ != nothing;) {
    const std::uint32_t last = oldest_;
    unlink(last);
    bytes_ -= bytes_of(last);
    freed_ += bytes_of(last);
    gone.push_back(std::move(slots_[last].cell));
  }
  slots_[cell].cell = loaded;
  link_newest(cell);
  const bool is_due = freed_ > trimmed_bytes;
  if (is_due) freed_ = 0;
  return is_due;
}

void CellCache::link_newest(std::uint32_t cell) const {
  slots_[cell].newer = nothing;
  slots_[cell].older = newest_;
  if (newest_ != nothing) slots_[newest_].newer = cell;
  newest_ = cell;
  if (oldest_ == nothing) oldest_ = cell;
}

void CellCache::unlink(std::uint32_t cell) const {
  const Slot& slot = slots_[cell];
  if (slot.newer == nothing)
    newest_ = slot.older;
  else
    slots_[slot.newer].older = slot.older;
  if (slot.older == nothing)
    oldest_ = slot.newer;
  else
    slots_[slot.older].newer = slot.newer;
}

}  // namespace glark::stream
