// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/motion.h"

namespace glark::edit {

Motion motion_of(std::span<const Field> fields, const Samples& now) {
  std::vector<double> sums(now.size());
  std::vector<Vector3d> moved(now.size());
  for (const Field& field : fields) {
    for (std::size_t k = 0; k < field.samples.size(); ++k) {
      sums[field.samples[k]] += field.weights[k];
      moved[field.samples[k]] += field.weights[k] * field.by[k];
    }
  }
  Motion motion;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!(sums[i] > 0)) continue;
    motion.samples.push_back(static_cast<std::uint32_t>(i));
    motion.positions.push_back(now.position(i) + moved[i] * (1 / sums[i]));
  }
  return motion;
}

}  // namespace glark::edit
