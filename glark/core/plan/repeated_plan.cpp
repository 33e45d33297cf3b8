// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a draw that repeats needs of the planner.
#include <mutex>

#include "glark/core/plan/planner.h"

namespace glark::core {

std::optional<Cause> Planner::judge_repeated(const DrawCall& call, const Program& program) const {
  if (!smooth()) {
    return std::nullopt;
  }
  const std::lock_guard lock(program.mutex);
  return parts_.meshes.judge(call, {.fields = &program.fields}, std::nullopt);
}

bool Planner::takes_normals_of_other_passes(const Program& program) const {
  return smooth() && capture::find_role(program.fields, capture::Role::normal) == nullptr;
}

}  // namespace glark::core
