// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts of clusters by their errors: they tell how many samples each threshold would leave.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/stream/sample/chosen_clusters.h"

namespace glark::stream {

class Divisions {
 public:
  Divisions();
  // Counts the division of a cluster with this error, which leaves so many more samples.
  void add(float error, std::uint32_t more);
  // Leaves `target` samples, but at least one, and no more than there are leaves.
  Cut cut_for(std::uint64_t target) const;
  // The counts, to be added to those of others. Their number is always the same.
  std::vector<std::uint64_t>& counts() { return more_; }

 private:
  std::vector<std::uint64_t> more_;  // samples that the divisions of a class of errors add; the least errors first
};

}  // namespace glark::stream
