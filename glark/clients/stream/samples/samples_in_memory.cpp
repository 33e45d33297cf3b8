// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <numeric>
#include <utility>

#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

void Samples::resize(std::size_t count, std::size_t channels) {
  for (std::vector<common::Vector3f>* vectors : {&before, &after, &normals, &normals_after}) vectors->resize(count);
  values.resize(channels * count);
  is_edited.resize(channels * count);
}

void Samples::copy(const Samples& from, std::size_t place, std::size_t to, std::size_t channels) {
  before[to] = from.before[place];
  after[to] = from.after[place];
  normals[to] = from.normals[place];
  normals_after[to] = from.normals_after[place];
  for (std::size_t k = 0; k < channels; ++k) {
    values[channels * to + k] = from.values[channels * place + k];
    is_edited[channels * to + k] = from.is_edited[channels * place + k];
  }
}

SamplesInMemory::SamplesInMemory(Samples samples) : samples_(std::move(samples)), index_(samples_.before) {}

void SamplesInMemory::nearest(const common::Vector3f& point, std::size_t count, FoundSamples& found) const {
  index_.nearest(point, count, found.nearest);
}

void SamplesInMemory::gather(const common::Vector3f& point, std::size_t count, FoundSamples& found) const {
  nearest(point, count, found);
  const std::size_t channels = samples_.channels();
  found.samples.resize(found.nearest.size(), channels);
  for (std::size_t i = 0; i < found.nearest.size(); ++i)
    found.samples.copy(samples_, found.nearest[i].index, i, channels);
}

void SamplesInMemory::each(const TakeSamples& take) const {
  std::vector<std::uint32_t> indices(size());
  std::iota(indices.begin(), indices.end(), 0U);
  take(indices, samples_);
}

}  // namespace glark::stream
