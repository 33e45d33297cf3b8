// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <filesystem>

#include "glark/clients/stream/ranks/ranks.h"

namespace glark::stream {

struct RanksSampleFiles {
  std::filesystem::path large, small;
  SampleFormats formats;
  std::filesystem::path temporary;  // a folder for temporary files of this rank; empty: that of `small`
};

// The same as sample_file(), by several ranks, with the same bytes. Each rank counts a range of the points. The cells are
// dealt to the ranks; each point goes to the owner of its cell, who builds the tree. Rank 0 chooses the threshold and
// writes the samples. What fits into the memory of one process, or cannot be read by ranges (text, compressed files), is
// sampled by rank 0 alone. options.memory: of each rank. options.work and options.resume have no effect.
// Returns the report on rank 0; the others know only `points`, `in_core` and `is_shuffled`.
// Errors: RanksError for those of sample_file(), on all ranks. A former output stays then.
SampleReport sample_file(Ranks& ranks, const RanksSampleFiles& files, const SampleOptions& options);

}  // namespace glark::stream
