// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/soundness.h"

#include "glark/core/refine/soundness/executor.h"

namespace glark::refine {

std::optional<StageVariation> find_variation(const std::vector<const SyntaxTree*>& trees,
                                             const std::set<std::string>& constants) {
  Executor executor(trees);
  executor.state().constants = constants;
  if (!executor.run()) return std::nullopt;
  StageVariation variation;
  Run& run = executor.state();
  for (const auto& [path, value] : run.memory.outputs()) {
    if (value.varies())
      variation.outputs.push_back({path, value.variation, run.notes.explain(value), run.notes.inputs_of(value)});
  }
  return variation;
}

}  // namespace glark::refine
