// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/combinations.h"

namespace glark::conformance {

// From path to path, every circumstance goes on in steps of its own. From change to change, the start goes on by a
// digit of the change's number, so that in 72 changes each path meets each combination of the others.
std::vector<Combination> combinations_of(std::size_t change, std::size_t paths) {
  std::vector<Combination> all;
  for (std::size_t path = 0; path < paths; ++path) {
    std::size_t rest = change;
    const auto digit = [&rest](std::size_t base) {
      const std::size_t value = rest % base;
      rest /= base;
      return value;
    };
    Combination one;
    one.path = path;
    one.history = histories[(path + digit(histories.size())) % histories.size()];
    one.refinement = (path + digit(refinement_count)) % refinement_count;
    one.depths = static_cast<Depths>((path / refinement_count + digit(depths_names.size())) % depths_names.size());
    one.triangles = sizes[(path / histories.size() + digit(sizes.size())) % sizes.size()];
    all.push_back(one);
  }
  return all;
}

}  // namespace glark::conformance
