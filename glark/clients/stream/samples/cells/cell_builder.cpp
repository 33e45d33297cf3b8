// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/cells/cell_builder.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "glark/clients/stream/space/morton.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr double cubes = 1 << 21;  // along the longest side of the box

// What all samples have.
struct Head {
  std::uint32_t index;
  Vector3f before, after, normal;
};

std::size_t record_size(std::size_t channels) { return sizeof(Head) + channels * (sizeof(float) + 1); }

// Removes elements from the beginning of an array.
template <class Array>
void drop(Array& array, std::size_t count) {
  array.erase(array.begin(), array.begin() + static_cast<std::ptrdiff_t>(count));
}

template <class Array>
Array first_of(const Array& array, std::size_t count) {
  return Array(array.begin(), array.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

CellBuilder::CellBuilder(const CellPlan& plan, const CellBox& box, std::size_t channels,
                         const std::filesystem::path& folder)
    : most_(plan.samples_a_cell),
      channels_(channels),
      box_(box),
      sorted_(record_size(channels), plan.sorting, folder),
      file_(std::make_unique<SampleCells>(folder, channels)),
      record_(record_size(channels)) {
  double side = 0;
  for (std::size_t k = 0; k < 3; ++k)
    side = std::max(side, static_cast<double>(box.high[k]) - static_cast<double>(box.low[k]));
  if (side > 0) scale_ = cubes / side;
}

std::uint64_t CellBuilder::key_of(const Vector3f& position) const {
  std::array<std::uint32_t, 3> cube{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = (static_cast<double>(position[k]) - static_cast<double>(box_.low[k])) * scale_;
    cube[k] = static_cast<std::uint32_t>(std::clamp(at, 0.0, cubes - 1));
  }
  return morton_code(cube);
}

void CellBuilder::add(const SampleRow& row) {
  const Head head{row.index, row.before, row.after, row.normal};
  std::memcpy(record_.data(), &head, sizeof head);
  if (channels_ > 0) {
    std::memcpy(&record_[sizeof head], row.values.data(), row.values.size_bytes());
    std::copy(row.is_edited.begin(), row.is_edited.end(), &record_[sizeof head + row.values.size_bytes()]);
  }
  sorted_.add(key_of(row.before), record_);
}

std::unique_ptr<SampleCells> CellBuilder::finish() {
  sorted_.each([&](std::uint64_t key, std::span<const char> record) {
    take(key, record);
    if (keys_.size() > most_) cut(cut_place());
  });
  if (keys_.size() > 1) cut(cut_place());
  if (!keys_.empty()) cut(keys_.size());
  return std::move(file_);
}

void CellBuilder::take(std::uint64_t key, std::span<const char> record) {
  Head head;
  std::memcpy(&head, record.data(), sizeof head);
  keys_.push_back(key);
  indices_.push_back(head.index);
  samples_.before.push_back(head.before);
  samples_.after.push_back(head.after);
  samples_.normals.push_back(head.normal);
  samples_.normals_after.push_back(head.normal);
  for (std::size_t k = 0; k < channels_; ++k) {
    float value = 0;
    std::memcpy(&value, &record[sizeof head + k * sizeof value], sizeof value);
    samples_.values.push_back(value);
    samples_.is_edited.push_back(static_cast<std::uint8_t>(record[sizeof head + channels_ * sizeof value + k]));
  }
}

// The last place where the highest bit changes.
std::size_t CellBuilder::cut_place() const {
  const std::size_t last = std::min(most_, keys_.size() - 1);
  std::size_t place = last;
  std::uint64_t highest = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    const std::uint64_t changed = std::bit_floor(keys_[i] ^ keys_[i - 1]);
    if (changed < highest || changed == 0) continue;
    highest = changed;
    place = i;
  }
  return place;
}

void CellBuilder::cut(std::size_t count) {
  const std::size_t values = channels_ * count;
  file_->append(std::span(indices_).first(count),
                {first_of(samples_.before, count), first_of(samples_.after, count), first_of(samples_.normals, count),
                 first_of(samples_.normals_after, count), first_of(samples_.values, values),
                 first_of(samples_.is_edited, values)});
  drop(keys_, count);
  drop(indices_, count);
  for (std::vector<Vector3f>* vectors : {&samples_.before, &samples_.after, &samples_.normals, &samples_.normals_after})
    drop(*vectors, count);
  drop(samples_.values, values);
  drop(samples_.is_edited, values);
}

}  // namespace glark::stream
