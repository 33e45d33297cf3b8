// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/cells/sample_cells.h"

#include <cassert>

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t tree_bytes_a_sample = 16, bytes_of_a_tree = 16 << 10;
static_assert(sizeof(Vector3f) == 3 * sizeof(float));

// Calls each(array) for all arrays of a cell in the order of the file. The turned normals come last.
template <class Indices, class Samples, class Each>
void each_array(Indices& indices, Samples& samples, const Each& each) {
  each(indices);
  each(samples.before);
  each(samples.after);
  each(samples.normals);
  each(samples.values);
  each(samples.is_edited);
  each(samples.normals_after);
}

template <class Array>
std::size_t size_in_bytes(const Array& array) {
  return array.size() * sizeof(array[0]);
}

CellBox box_of(const std::vector<Vector3f>& positions) {
  CellBox box{positions[0], positions[0]};
  for (const Vector3f& p : positions) {
    box.low = common::least(box.low, p);
    box.high = common::greatest(box.high, p);
  }
  return box;
}

}  // namespace

std::size_t cell_bytes(std::size_t samples, std::size_t channels) {
  const std::size_t sample = sizeof(std::uint32_t) + 4 * sizeof(Vector3f) + channels * (sizeof(float) + 1);
  return sizeof(LoadedCell) + bytes_of_a_tree + samples * (sample + tree_bytes_a_sample);
}

void SampleCells::append(std::span<const std::uint32_t> indices, const Samples& samples) {
  assert(!indices.empty() && indices.size() == samples.size());
  std::vector<char> bytes;
  each_array(indices, samples, [&](const auto& array) {
    const char* begin = reinterpret_cast<const char*>(array.data());
    bytes.insert(bytes.end(), begin, begin + size_in_bytes(array));
  });
  places_.push_back({file_.append(bytes), static_cast<std::uint32_t>(indices.size())});
  boxes_.push_back(box_of(samples.before));
}

std::shared_ptr<const LoadedCell> SampleCells::load(std::size_t cell) const {
  const Place& place = places_[cell];
  auto loaded = std::make_shared<LoadedCell>();
  loaded->indices.resize(place.count);
  loaded->samples.resize(place.count, channels_);
  std::uint64_t offset = place.offset;
  each_array(loaded->indices, loaded->samples, [&](auto& array) {
    const std::size_t size = size_in_bytes(array);
    if (size > 0) file_.read(offset, {reinterpret_cast<char*>(array.data()), size});
    offset += size;
  });
  loaded->tree = std::make_unique<SampleIndex>(loaded->samples.before);
  return loaded;
}

void SampleCells::write_turned_normals(std::size_t cell, std::span<const Vector3f> normals) {
  const Place& place = places_[cell];
  assert(normals.size() == place.count);
  const std::size_t before =
      sizeof(std::uint32_t) + 3 * sizeof(Vector3f) + channels_ * (sizeof(float) + sizeof(std::uint8_t));
  file_.write(place.offset + place.count * before,
              {reinterpret_cast<const char*>(normals.data()), normals.size_bytes()});
}

}  // namespace glark::stream
