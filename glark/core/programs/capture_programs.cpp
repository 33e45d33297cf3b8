// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/capture_programs.h"

#include "glark/core/capture/feedback_aside.h"
#include "glark/core/capture/input_slots.h"

namespace glark::core {

const CapturePrograms::Entry& CapturePrograms::find(const std::shared_ptr<DerivedProgram>& derived) {
  const auto found = entries_.find(derived);
  if (found != entries_.end()) {
    return found->second;
  }
  static const Entry none;
  if (!env_.compilation.may_begin(derived.get())) {
    return none;
  }
  const Compilation::Step step(env_.compilation);
  std::erase_if(entries_, [](const auto& entry) { return entry.first.expired(); });
  ErrorScope errors(env_.errors);
  const capture::FeedbackAside aside(env_.gl, stage_, env_.bindings());
  const GLuint tag_attribute = env_.ark.tag_attribute;
  Entry program{stage_.program_for(derived->layout, tag_attribute), input_slots(derived->layout, tag_attribute)};
  return entries_.emplace(derived, std::move(program)).first->second;
}

}  // namespace glark::core
