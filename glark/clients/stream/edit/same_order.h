// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Whether an edited sampling without indices has the order of the one before the edit.
#pragma once

#include <string>
#include <vector>

#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

// Collects some samples from all over the sampling.
class TriedSamples {
 public:
  explicit TriedSamples(std::size_t samples);

  void add(std::size_t index, const common::Vector3f& before, const common::Vector3f& after);
  // Throws Error if most samples that were neighbours are strangers: a program has written them in another order. An edit
  // tears the sampling here and there, not everywhere. file: the name of the edited sampling.
  void require_same_order(const SampleStore& store, const std::string& file) const;

 private:
  std::size_t step_;
  std::vector<common::Vector3f> tried_;
  common::Vector3f low_, high_, low_after_, high_after_;  // the boxes of all samples
  bool is_empty_ = true;
};

}  // namespace glark::stream
