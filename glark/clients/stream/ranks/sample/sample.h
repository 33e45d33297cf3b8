// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <functional>

#include "glark/clients/stream/ranks/ranks.h"
#include "glark/clients/stream/sample/in_core.h"

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

// What several ranks sample, and what becomes of the samples.
struct RanksSampleInput {
  Source source;
  std::filesystem::path temporary;  // a folder for temporary files of this rank
  CreateWriter create;              // makes the writer, on rank 0
  std::function<void(const SampleReport&)> published = [](const SampleReport&) {};  // is called on rank 0 at the end
};

// The same as sample(), by several ranks, with the same bits. The writer is made on rank 0. Errors: as sample_file().
SampleReport sample(Ranks& ranks, const RanksSampleInput& input, const SampleOptions& options);

}  // namespace glark::stream
