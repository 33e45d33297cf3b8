// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The nearest samples of each of some points that lie close together. One search finds the samples around all of these
// points. The nearest ones of a point are then chosen among them, which takes a tenth of the time of a search.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

class NearSamples {
 public:
  // count: the nearest samples of a point, 3 to 64.
  NearSamples(const SampleStore& store, std::size_t count);

  // Gathers the samples around the next points.
  void gather(const common::Vector3f& centre);
  // How far from the centre the points may be so that find() seldom gathers again.
  float reach() const { return reach_; }
  // Finds the nearest samples, the nearest one first, with the weights of the kernel. Gathers again if it has to.
  std::span<const Neighbour> find(const common::Vector3f& point, bool is_singular);
  // Whether the last point lies away from all samples: its nearest one is about as far as all others that were found.
  bool is_away() const { return distances_[0] > away * last_farthest_; }
  // What the indices of find() mean.
  const Samples& samples() const { return gathered_.samples; }

 private:
  bool choose(const common::Vector3f& point);
  static constexpr std::size_t most = 256;  // so that an index has 8 bits
  static constexpr float away = 0.9F;

  void sort_keys(std::size_t found);
  void sort_like_keys(const std::array<float, most>& squares, std::size_t found);
  template <std::size_t width>
  void sort_few(std::size_t found);

  const SampleStore& store_;
  std::size_t count_;
  FoundSamples gathered_;
  common::Vector3f centre_;
  float reach_ = 0;
  float farthest_ = 0;           // the distance of the last one of the `count` nearest samples from the centre
  float covered_ = -1;           // all samples within this distance from the centre are gathered
  common::Vector3f last_point_;  // the one of the last find(), and the distance of its farthest neighbour
  float last_farthest_ = 0;
  std::array<float, most> x_{}, y_{}, z_{};  // the positions before, for loops over all
  std::array<std::int32_t, most + 1> keys_{};
  std::array<float, most> distances_{};
  std::array<Neighbour, 64> found_{};
};

// A channel at a point: the mean of its edited values with the weights of the neighbours, and their share of all weights,
// 0 to 1. The rest is the point's own value: where nothing was edited, a scan keeps its details.
struct EditedValue {
  float value = 0, share = 0;

  double mixed_with(double own) const {
    return static_cast<double>(share) * static_cast<double>(value) + (1 - static_cast<double>(share)) * own;
  }
};

// width: the number of channels. Source: Boubekeur 2007, ch. 4.4.1, for samples that were all edited.
inline EditedValue edited_value(const Samples& samples, std::span<const Neighbour> neighbours, std::size_t width,
                                std::size_t channel) {
  float sum = 0, edited = 0, kept = 0;
  for (const Neighbour& near : neighbours) {
    const std::size_t at = width * near.index + channel;
    const bool counts = samples.is_edited[at] != 0;
    (counts ? edited : kept) += near.weight;
    sum += counts ? near.weight * samples.values[at] : 0;
  }
  return edited > 0 ? EditedValue{sum / edited, kept > 0 ? edited / (edited + kept) : 1} : EditedValue{};
}

}  // namespace glark::stream
