// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/cell_file.h"

#include <algorithm>
#include <cstring>

#include "glark/clients/stream/ranks/deliver.h"
#include "glark/clients/stream/sample/pass/local_points.h"

namespace glark::stream {

CellFile::CellFile(Ranks& ranks, const Shares& shares, std::span<const std::uint64_t> own_counts)
    : begins_(shares.owned.size()), places_(ranks.size()) {
  std::vector<std::vector<CellCount>> counts(ranks.size());
  for (std::size_t cell = 0; cell < own_counts.size(); ++cell)
    if (own_counts[cell] > 0) counts[shares.owners[cell]].push_back({cell, own_counts[cell]});
  std::vector<std::vector<CellCount>> received(ranks.size());
  deliver_values(ranks, counts, [&](std::size_t from, std::span<const CellCount> some) {
    received[from].assign(some.begin(), some.end());
  });
  const auto index_of = [&](std::uint64_t cell) {
    const auto found = std::lower_bound(shares.owned.begin(), shares.owned.end(), cell);
    return static_cast<std::size_t>(found - shares.owned.begin());
  };
  std::vector<std::uint64_t> ends(begins_.size());
  for (const std::vector<CellCount>& some : received)
    for (const CellCount& count : some) ends[index_of(count.cell)] += count.count;
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] = begins_[i - 1] + ends[i - 1];
  std::vector<std::uint64_t> next = begins_;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)  // the order of the scan
    for (const CellCount& count : received[rank]) {
      std::uint64_t& at = next[index_of(count.cell)];
      places_[rank].push_back({static_cast<std::uint32_t>(count.cell), at, at, at + count.count});
      at += count.count;
    }
}

void CellFile::begin(const std::filesystem::path& folder, std::size_t record_size) {
  file_.reset();  // its room on the disk is free before the next one needs it
  file_ = std::make_unique<TemporaryFile>(folder);
  record_size_ = record_size;
  for (std::vector<Place>& places : places_)
    for (Place& place : places) place.next = place.begin;
}

CellFile::Place& CellFile::place_of(std::size_t rank, std::uint32_t cell, const std::string& scan) {
  std::vector<Place>& places = places_[rank];
  const auto found = std::lower_bound(places.begin(), places.end(), cell,
                                      [](const Place& place, std::uint32_t c) { return place.cell < c; });
  if (found == places.end() || found->cell != cell) fail_as_changed(scan);
  return *found;
}

void CellFile::put(std::size_t rank, std::span<const char> records, const std::string& scan) {
  const auto cell_at = [&](std::size_t at) {
    std::uint32_t cell = 0;
    std::memcpy(&cell, &records[at], sizeof(cell));
    return cell;
  };
  for (std::size_t begin = 0, end = 0; begin < records.size(); begin = end) {
    const std::uint32_t cell = cell_at(begin);
    while (end < records.size() && cell_at(end) == cell) end += record_size_;
    Place& place = place_of(rank, cell, scan);
    const std::uint64_t count = (end - begin) / record_size_;
    if (place.next + count > place.end) fail_as_changed(scan);
    file_->write(place.next * record_size_, records.subspan(begin, end - begin));
    place.next += count;
  }
}

void CellFile::require_complete(const std::string& scan) const {
  for (const std::vector<Place>& places : places_)
    for (const Place& place : places)
      if (place.next != place.end) fail_as_changed(scan);
}

void CellFile::read(std::size_t owned, std::uint64_t first, std::span<char> records) const {
  file_->read((begins_[owned] + first) * record_size_, records);
}

}  // namespace glark::stream
