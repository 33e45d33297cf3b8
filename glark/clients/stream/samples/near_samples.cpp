// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/near_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t gathered = 4;     // times the nearest samples of a point
constexpr float wider = 1.0001F;        // for the rounding of distances
constexpr std::int32_t low_bits = 255;  // of a key: the sample. The others are those of the squared distance

}  // namespace

NearSamples::NearSamples(const SampleStore& store, std::size_t count)
    : store_(store), count_(std::min(count, store.size())) {}

void NearSamples::gather(const Vector3f& centre) {
  centre_ = centre;
  store_.gather(centre, std::min(most, gathered * count_), gathered_);
  const std::vector<NearSample>& nearest = gathered_.nearest;
  farthest_ = std::sqrt(nearest[count_ - 1].square);
  covered_ = nearest.size() == store_.size() ? std::numeric_limits<float>::max() : std::sqrt(nearest.back().square);
  reach_ = (covered_ - farthest_) / 2;
  last_point_ = centre;
  last_farthest_ = farthest_;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    x_[i] = samples().before[i].x;
    y_[i] = samples().before[i].y;
    z_[i] = samples().before[i].z;
  }
}

// Sorts at most `width` keys. A key's place is the number of smaller keys: no branch depends on the keys.
template <std::size_t width>
void NearSamples::sort_few(std::size_t found) {
  std::array<std::int32_t, width> places{}, keys{};
  std::copy_n(keys_.begin(), width, keys.begin());
  for (std::size_t other = 0; other < found; ++other)
    for (std::size_t i = 0; i < width; ++i) places[i] += keys[other] < keys[i] ? 1 : 0;
  for (std::size_t i = 0; i < found; ++i) keys_[static_cast<std::size_t>(places[i])] = keys[i];
}

void NearSamples::sort_keys(std::size_t found) {
  if (found <= 16)
    sort_few<16>(found);
  else if (found <= 32)
    sort_few<32>(found);
  else
    std::sort(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(found));
}

// Keys hold the squared distances without their last bits. Those that are alike are sorted by all bits, and then by the
// sample, so that the result does not depend on which samples are gathered.
void NearSamples::sort_like_keys(const std::array<float, most>& squares, std::size_t found) {
  const auto place = [&](std::int32_t key) { return static_cast<std::size_t>(key & low_bits); };
  const auto index_of = [&](std::size_t i) { return gathered_.nearest[i].index; };
  const auto is_nearer = [&](std::int32_t a, std::int32_t b) {
    if (((a ^ b) & ~low_bits) != 0) return false;
    const float square_a = squares[place(a)], square_b = squares[place(b)];
    return square_a < square_b || (square_a == square_b && index_of(place(a)) < index_of(place(b)));
  };
  for (std::size_t i = 1; i < found; ++i)
    for (std::size_t k = i; k > 0 && is_nearer(keys_[k], keys_[k - 1]); --k) std::swap(keys_[k], keys_[k - 1]);
}

// Returns false if other samples may be nearer than those that are gathered. The triangle inequality tells it: the
// nearest samples of the centre, and those of the last point, are near the point, too.
bool NearSamples::choose(const Vector3f& point) {
  if (covered_ < 0) return false;
  const float moved = common::length(point - centre_);
  const float bound = std::min(farthest_ + moved, last_farthest_ + common::length(point - last_point_)) * wider;
  const float square = bound * bound + std::numeric_limits<float>::min();
  std::array<float, most> squares;
  const std::size_t size = samples().size();
  for (std::size_t i = 0; i < size; ++i) {
    const float dx = x_[i] - point.x, dy = y_[i] - point.y, dz = z_[i] - point.z;
    squares[i] = dx * dx + dy * dy + dz * dz;
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < size; ++i) {
    keys_[found] = (std::bit_cast<std::int32_t>(squares[i]) & ~low_bits) | static_cast<std::int32_t>(i);
    found += squares[i] <= square ? 1 : 0;
  }
  if (found < count_) return false;
  sort_keys(found);
  sort_like_keys(squares, found);
  for (std::size_t i = 0; i < count_; ++i) {
    found_[i].index = static_cast<std::uint32_t>(keys_[i] & low_bits);
    distances_[i] = std::sqrt(squares[found_[i].index]);
  }
  last_point_ = point;
  last_farthest_ = distances_[count_ - 1];
  return away == 0 || last_farthest_ + away <= covered_;
}

// The kernel is Hermite's polynomial of the distance relative to that of the farthest neighbour.
// Source: Boubekeur 2007, ch. 4.4.1, with max instead of arg max.
std::span<const Neighbour> NearSamples::find(const Vector3f& point, bool is_singular) {
  if (!choose(point)) {
    gather(point);
    choose(point);
  }
  const float farthest = distances_[count_ - 1], scale = farthest > 0 ? 1 / farthest : 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const float t = distances_[i] * scale;
    found_[i].weight = 1 - 3 * t * t + 2 * t * t * t;
    if (is_singular) found_[i].weight /= t * t + 1e-6F;
  }
  if (!(found_[0].weight > 0)) found_[0].weight = 1;  // all are equally far, or there is one only
  return std::span(found_).first(count_);
}

}  // namespace glark::stream
