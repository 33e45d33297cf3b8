// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples of all ranks on their way to rank 0, which writes them cell by cell.
#pragma once

#include <filesystem>
#include <vector>

#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/ranks/sample/cell_file.h"
#include "glark/clients/stream/sample/assembly.h"

namespace glark::stream {

// A cluster, as far as it is written, or the error of its cell needs it.
struct SentSample {
  std::array<double, 3> position{};
  std::array<float, 3> normal{};
  std::array<std::uint8_t, 4> colour{};
  float count = 0, square = 0;  // as ClusterNode has them
};

// The samples of the cells that a rank owns, in a temporary file.
class SampleSpool {
 public:
  // Throws Error if the folder cannot be written.
  explicit SampleSpool(const std::filesystem::path& folder) : file_(folder) {}
  void add(const SentSample& sample);
  std::uint64_t count() const { return count_; }
  std::vector<SentSample> read(std::uint64_t first, std::uint64_t count);

 private:
  void flush();

  TemporaryFile file_;
  std::vector<SentSample> buffer_;
  std::uint64_t count_ = 0;
};

// Pieces are the samples of cells that follow one another. Rank 0 gets a piece from all owners at a time.
class SamplePieces {
 public:
  // own_counts: of the owned cells. counts: of all cells, on rank 0.
  SamplePieces(Ranks& ranks, const Shares& shares, SampleSpool& spool, const std::vector<std::uint64_t>& own_counts,
               const std::vector<std::uint64_t>& counts);

  // On rank 0: calls write(select_cell). Throws RanksError for errors of any rank.
  void write_all(const std::function<void(const SelectCell&)>& write);
  // On the others.
  void send_all();

 private:
  std::vector<SentSample> own_part();
  void exchange_piece(const std::string& problem);
  void add_samples(std::size_t cell, CellSamples& samples);

  Ranks& ranks_;
  const Shares& shares_;
  SampleSpool& spool_;
  const std::vector<std::uint64_t>& own_counts_;
  const std::vector<std::uint64_t>& counts_;
  std::vector<std::uint64_t> ends_;                // one past the last cell of each piece
  std::size_t piece_ = 0;                          // the next one
  std::size_t next_owned_ = 0;                     // the first owned cell that is in no piece yet
  std::uint64_t sent_ = 0;                         // samples of this rank
  std::vector<std::vector<SentSample>> received_;  // of each rank, on rank 0
  std::vector<std::size_t> taken_;                 // of them
};

}  // namespace glark::stream
