// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/edit/same_order.h"

#include <fmt/format.h>
#include <glark/point_stream.h>

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t tried_samples = 2000, least_tried = 100;
constexpr float near_samples = 0.03F, far_samples = 0.1F;  // relative to the diagonal of all

}  // namespace

TriedSamples::TriedSamples(std::size_t samples) : step_(samples / tried_samples + 1) {}

void TriedSamples::add(std::size_t index, const Vector3f& before, const Vector3f& after) {
  if (index % step_ == 0) tried_.push_back(before);
  low_ = is_empty_ ? before : common::least(low_, before);
  high_ = is_empty_ ? before : common::greatest(high_, before);
  low_after_ = is_empty_ ? after : common::least(low_after_, after);
  high_after_ = is_empty_ ? after : common::greatest(high_after_, after);
  is_empty_ = false;
}

void TriedSamples::require_same_order(const SampleStore& store, const std::string& file) const {
  const float near = near_samples * common::length(high_ - low_);
  const float far = far_samples * common::length(high_after_ - low_after_);
  std::size_t neighbours = 0, strangers = 0;
  FoundSamples found;  // a sample and the one nearest to it
  for (const Vector3f& place : tried_) {
    store.gather(place, 2, found);
    if (!(found.nearest.back().square < near * near)) continue;
    ++neighbours;
    strangers += common::length(found.samples.after.front() - found.samples.after.back()) > far ? 1 : 0;
  }
  if (neighbours < least_tried || 2 * strangers <= neighbours) return;
  throw Error(Element::file, 0,
              fmt::format("{}: its points have another order than those of the sampling: {} of {} that were neighbours "
                          "lie far apart; export it with the property \"index\" of the sampling, or without sorting",
                          file, strangers, neighbours));
}

}  // namespace glark::stream
