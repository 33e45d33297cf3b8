// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/draw_programs.h"

#include <memory>
#include <vector>

namespace glark::core {

DrawPrograms::DrawPrograms(const Environment& environment, capture::CaptureStage& stage)
    : env_(environment),
      derived_(environment, stage),
      fixed_function_(environment, derived_),
      assembly_(environment, derived_, fixed_function_),
      capture_(environment, stage),
      in_use_(environment) {}

Program* DrawPrograms::named(GLuint name) {
  if (name == 0) {
    return env_.capabilities.is_compatibility() ? fixed_function_.find(nullptr, 0) : nullptr;
  }
  return env_.state.programs().find(name).get();  // the share group keeps it
}

void DrawPrograms::changed(Program& program, GLuint name) {
  derived_.discard(program);
  fixed_function_.forget_fragment(name);
  assembly_.forget_fragment(name);
}

void DrawPrograms::tag_attribute_changed() {
  fixed_function_.discard_derived();
  assembly_.discard_derived();
  std::vector<std::shared_ptr<Program>> programs;
  {
    const std::lock_guard lock(env_.share.mutex);
    for (auto& [name, program] : env_.share.programs) {
      programs.push_back(program);
    }
  }
  for (const std::shared_ptr<Program>& program : programs) {
    derived_.discard(*program);
  }
}

void DrawPrograms::release() {
  fixed_function_.release();
  assembly_.release();
  capture_.clear();
}

}  // namespace glark::core
