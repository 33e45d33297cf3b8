// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where the samples of a sampling are: in memory, or in cells on the disk. Both give the same bits.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "glark/clients/stream/samples/nearest_set.h"
#include "glark/clients/stream/samples/sample_index.h"
#include "glark/clients/stream/samples/samples.h"

namespace glark::stream {

// The samples near a place, and what the next search in the same thread can use again.
struct FoundSamples {
  std::vector<NearSample> nearest;   // the nearest one first
  Samples samples;                   // copies of them in the same order, by gather() only
  std::vector<CellSample> in_cells;  // of a search in cells
  std::uint32_t last_cell = 0;
};

// Some samples, one after the other, and their indices in the sampling.
using TakeSamples = std::function<void(std::span<const std::uint32_t> indices, const Samples& samples)>;

class SampleStore {
 public:
  SampleStore() = default;
  virtual ~SampleStore() = default;
  SampleStore(const SampleStore&) = delete;
  SampleStore& operator=(const SampleStore&) = delete;

  virtual std::size_t size() const = 0;
  // Finds the `count` nearest samples before the edit, or all if there are fewer. Several threads may call it, each with
  // a `found` of its own. Throws Error if a disk cannot be read.
  virtual void nearest(const common::Vector3f& point, std::size_t count, FoundSamples& found) const = 0;
  // The same, with copies of the samples.
  virtual void gather(const common::Vector3f& point, std::size_t count, FoundSamples& found) const = 0;
  // Gives all samples, some at a time.
  virtual void each(const TakeSamples& take) const = 0;
  // The cells on the disk; 0 for samples in memory.
  virtual std::size_t cells() const = 0;
};

class SamplesInMemory final : public SampleStore {
 public:
  explicit SamplesInMemory(Samples samples);

  const SampleIndex& index() const { return index_; }
  Samples& samples() { return samples_; }

  std::size_t size() const override { return samples_.size(); }
  void nearest(const common::Vector3f& point, std::size_t count, FoundSamples& found) const override;
  void gather(const common::Vector3f& point, std::size_t count, FoundSamples& found) const override;
  void each(const TakeSamples& take) const override;
  std::size_t cells() const override { return 0; }

 private:
  Samples samples_;
  SampleIndex index_;
};

}  // namespace glark::stream
