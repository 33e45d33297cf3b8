// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/points/height_field.h"

#include <algorithm>

namespace glark::common {
namespace {

constexpr std::size_t run = 32;     // records between two checks of the angles
constexpr std::size_t stride = 64;  // between records of the first, coarse check

}  // namespace

bool is_height_field(std::span<const Record> records, const Moments& moments, float delta_a, float delta_d) {
  if (moments.at_one_point()) return true;
  const Float4 normal = moments.normal();
  if (dot(normal, normal) == 0) return false;
  const auto turns_away = [&](const Record& record) {
    return (dot(record.normal, normal) <= delta_a) & (record.normal[3] > 0);
  };
  // A few records are enough to reject most nodes.
  for (std::size_t i = 0; i < records.size(); i += stride) {
    if (turns_away(records[i])) return false;
  }
  const Float4 centroid = without_fourth(moments.mean);
  float farthest = 0;
  float highest = 0;
  for (std::size_t begin = 0; begin < records.size(); begin += run) {
    bool away = false;
    for (const Record& record : records.subspan(begin, std::min(run, records.size() - begin))) {
      const Float4 d = record.point() - centroid;
      farthest = std::max(farthest, dot(d, d));
      highest = std::max(highest, std::abs(dot(d, normal)));
      away |= turns_away(record);
    }
    if (away) return false;
  }
  return highest < delta_d * std::sqrt(farthest);
}

}  // namespace glark::common
