// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The points of the cells that a rank owns, in a file of its own. Those of a cell follow one another in the order of the
// scan, in whatever order the ranks send them: each rank has counted its points, so they have their places.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/ranks/sample/shares.h"

namespace glark::stream {

// The cells and the points of a rank. All ranks know all owners.
struct Shares {
  std::vector<std::uint32_t> owners;  // [cells]
  std::vector<std::uint32_t> owned;   // the cells of this rank, ascending
  RankRange range;                    // the points that this rank reads
};

class CellFile {
 public:
  // own_counts: the points of this rank in each cell: [cells]. Throws RanksError.
  CellFile(Ranks& ranks, const Shares& shares, std::span<const std::uint64_t> own_counts);

  // Makes an empty file for records of this size, which begin with the index of their cell.
  // Throws Error if the folder cannot be written.
  void begin(const std::filesystem::path& folder, std::size_t record_size);
  // Writes records of a rank, in the order of the scan for each cell. Throws Error for more points than it has counted.
  void put(std::size_t rank, std::span<const char> records, const std::string& scan);
  // Throws Error if points are missing.
  void require_complete(const std::string& scan) const;
  // Reads records of an owned cell from its point `first` on. owned: its index in Shares::owned.
  void read(std::size_t owned, std::uint64_t first, std::span<char> records) const;

 private:
  struct CellCount {
    std::uint64_t cell = 0, count = 0;
  };
  // The records of the file for the points of a rank in a cell.
  struct Place {
    std::uint32_t cell = 0;
    std::uint64_t begin = 0, next = 0, end = 0;
  };
  Place& place_of(std::size_t rank, std::uint32_t cell, const std::string& scan);

  std::vector<std::uint64_t> begins_;       // [owned], in records
  std::vector<std::vector<Place>> places_;  // of each rank, by cell
  std::unique_ptr<TemporaryFile> file_;
  std::size_t record_size_ = 0;
};

}  // namespace glark::stream
