// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/combinations.h"

#include <fmt/core.h>

#include "conformance/changes/paths.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr std::array<GLenum, refinement_count> refinements = {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK,
                                                              GL_CURVED_PN_ARK};
constexpr std::size_t linear_inputs = 0, curved_triangles = 2;  // in `refinements`
constexpr std::array<const char*, refinement_count> refinement_names = {"linear inputs", "linear outputs",
                                                                        "curved triangles"};

// The same draw with what an implementation may keep for longest: the refined inputs of a draw that repeats often.
Combination kept_longest(Combination one, std::size_t turn) {
  one.history = histories.back();
  one.refinement = turn % 2 == 0 ? linear_inputs : curved_triangles;
  one.depths = turn % 4 < 2 ? Depths::uniform : Depths::tags;
  return one;
}

}  // namespace

void set_refinement(const Combination& one) {
  const GLenum refinement = refinements[one.refinement];
  if (one.depths == Depths::uniform) {
    refine_uniformly(2, refinement);
    return;
  }
  refine_by_tags(3, refinement);
  if (one.depths == Depths::measured) {
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 8);
  }
}

std::string text_of(const Combination& one) {
  return fmt::format("{} of {} triangles, {}, {}", paths()[one.path].name, one.triangles,
                     refinement_names[one.refinement], depths_names[static_cast<std::size_t>(one.depths)]);
}

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
    all.push_back(kept_longest(one, path + change));
  }
  return all;
}

}  // namespace glark::conformance
