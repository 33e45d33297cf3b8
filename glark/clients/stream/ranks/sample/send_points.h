// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The second pass of all ranks: each reads its range of the scan, and sends the points to the owners of their cells.
#pragma once

#include "glark/clients/stream/ranks/sample/cell_file.h"
#include "glark/clients/stream/sample/pass/cell_pass.h"
#include "glark/clients/stream/sample/pass/stored_point.h"

namespace glark::stream {

// A point of a coherent scan. It begins with the index of its cell.
struct StreamedPoint {
  LocalPoint point;
  // The batch in which a single process would read the point. It would check its memory after each batch.
  std::uint32_t batch = 0;
};

// A point of a shuffled scan.
struct ShuffledPoint {
  std::uint32_t cell = 0;
  StoredPoint point;
};

struct SendInput {
  BlockSource& source;
  const Plan& plan;
  const Shares& shares;
  const std::filesystem::path& folder;  // for the file of cells
  Progress progress;
};

// Fills the file by the points of all ranks. Throws RanksError, also for a scan that has changed since the first pass.
void send_streamed_points(Ranks& ranks, const SendInput& input, CellFile& file);
void send_shuffled_points(Ranks& ranks, const SendInput& input, CellFile& file);

}  // namespace glark::stream
