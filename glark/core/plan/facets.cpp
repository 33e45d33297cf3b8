// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/facets.h"

#include <algorithm>

#include "glark/core/capture/layout.h"

namespace glark::core {

bool shows_facets(const Environment& environment, const Program& program) {
  if (!environment.options.smooth || environment.ark.enabled) return false;
  const GLenum shade_model = environment.bindings().shade_model;
  if (program.fixed_function) return program.input_traits.can_curve && shade_model == GL_FLAT;
  const capture::Field* const normal = capture::find_role(program.fields, capture::Role::normal);
  const refine::Interpolation most =
      shade_model == GL_FLAT ? refine::Interpolation::unless_flat_shaded : refine::Interpolation::never;
  const std::vector<refine::OutputVariation>& outputs = program.traits.variation.outputs;
  return normal != nullptr && (program.traits.fragments_make_facets ||
                               std::any_of(outputs.begin(), outputs.end(), [&](const refine::OutputVariation& output) {
                                 return output.interpolation >= most && output.inputs.contains(normal->name);
                               }));
}

}  // namespace glark::core
