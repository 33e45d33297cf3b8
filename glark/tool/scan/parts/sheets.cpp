// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/sheets.h"

#include <algorithm>
#include <cstdlib>

#include "glark/tool/scan/parts/sample_search.h"

namespace glark::tool {
namespace {

constexpr std::size_t more = std::size_t{1} << 15;  // sheets between two merges, at least

}  // namespace

Sheets::Sheets(std::size_t samples) : next_cleaning_(4 * samples + more) {}

void Sheets::add(std::array<std::uint32_t, 3> samples) {
  if (std::find(samples.begin(), samples.end(), SampleSearch::no_sample) != samples.end()) return;
  if (samples[0] == samples[1] || samples[1] == samples[2] || samples[2] == samples[0]) return;
  std::rotate(samples.begin(), std::min_element(samples.begin(), samples.end()), samples.end());
  const bool is_turned = samples[1] > samples[2];
  if (is_turned) std::swap(samples[1], samples[2]);
  sheets_.push_back({samples, is_turned ? -1 : 1});
  if (sheets_.size() >= next_cleaning_) merge();
}

void Sheets::add(std::span<const Sheet> sheets) {
  sheets_.insert(sheets_.end(), sheets.begin(), sheets.end());
  if (sheets_.size() >= next_cleaning_) merge();
}

std::span<const Sheet> Sheets::merged() {
  merge();
  return sheets_;
}

void Sheets::merge() {
  std::sort(sheets_.begin(), sheets_.end(), [](const Sheet& a, const Sheet& b) { return a.corners < b.corners; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sheets_.size();) {
    Sheet sheet{sheets_[i].corners, 0};
    for (; i < sheets_.size() && sheets_[i].corners == sheet.corners; ++i) sheet.count += sheets_[i].count;
    if (sheet.count != 0) sheets_[kept++] = sheet;
  }
  sheets_.resize(kept);
  next_cleaning_ = 2 * kept + more;
}

std::vector<std::uint32_t> Sheets::take_triangles() {
  merge();
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * sheets_.size());
  for (const Sheet& sheet : sheets_) {
    const auto [a, b, c] = sheet.corners;
    for (std::int32_t k = 0; k < std::abs(sheet.count); ++k)
      indices.insert(indices.end(), {a, sheet.count > 0 ? b : c, sheet.count > 0 ? c : b});
  }
  sheets_ = {};
  return indices;
}

}  // namespace glark::tool
