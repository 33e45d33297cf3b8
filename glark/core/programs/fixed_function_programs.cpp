// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/fixed_function_programs.h"

namespace glark::core {

refine::FragmentReads FixedFunctionPrograms::fragment_reads(const Program* fragment) const {
  const gl::Dispatch& gl = env_.gl;
  std::string text;
  if (fragment != nullptr) {
    for (const StageSource& stage : fragment->stages) {
      text += *stage.source;
    }
  } else if (gl.GetProgramStringARB != nullptr && gl.IsEnabled(GL_FRAGMENT_PROGRAM_ARB) != GL_FALSE) {
    GLint length = 0;
    gl.GetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
    text.resize(static_cast<std::size_t>(length));
    gl.GetProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_STRING_ARB, text.data());
  } else if (env_.capabilities.ati_fragment_shader && gl.IsEnabled(GL_FRAGMENT_SHADER_ATI) != GL_FALSE) {
    return {.own_fragment_stage = true, .texture_units = ~0U};  // GL does not say which ones it reads
  } else {
    return {};
  }
  return refine::fragment_reads(text);
}

const refine::FixedFunctionState& FixedFunctionPrograms::read_state(const Program* fragment) {
  const GLuint fragment_name = fragment != nullptr ? fragment->name : 0;
  if (env_.state.fixed_function().stale() || fragment_ != fragment_name) {
    env_.state.fixed_function().mark_read();
    last_ = nullptr;
    fragment_ = fragment_name;
    state_ = refine::read_fixed_function_state(env_.gl, fragment_reads(fragment), env_.capabilities.fog_distance);
  }
  return state_;
}

Program* FixedFunctionPrograms::find(Program* fragment, MaterialSet materials) {
  read_state(fragment);
  std::pair key{state_, fragment_};
  if (materials != 0 && state_.lighting) {
    key.first.material_attribute = material_attributes(materials, env_.ark);
  }
  std::shared_ptr<Program>& slot = programs_[key];
  if (slot == nullptr) {
    slot = derived_.fixed_function(key.first, fragment);
    slot->refinement_source = refinement_source_;
    slot->told_notes = told_notes_.try_emplace(fragment_, slot->told_notes).first->second;
  }
  last_ = materials == 0 ? slot.get() : last_;
  return slot.get();
}

void FixedFunctionPrograms::set_refinement_source(std::string source) {
  refinement_source_ = std::move(source);
  for (auto& [fragment, told] : told_notes_) {
    *told = {};
  }
  for (auto& [key, program] : programs_) {
    derived_.discard(*program);
    program->refinement_source = refinement_source_;
  }
}

void FixedFunctionPrograms::discard_derived() {
  for (auto& [key, program] : programs_) {
    derived_.discard(*program);
  }
}

void FixedFunctionPrograms::forget_fragment(GLuint name) {
  last_ = nullptr;
  told_notes_.erase(name);
  if (name == fragment_) {
    env_.state.fixed_function().touch();  // it may read other texture coordinates now
  }
  for (auto entry = programs_.begin(); entry != programs_.end();) {
    if (entry->first.second == name && name != 0) {
      derived_.remove_generated(name, *entry->second);
      entry = programs_.erase(entry);
    } else {
      ++entry;
    }
  }
}

void FixedFunctionPrograms::release() {
  for (auto& [key, program] : programs_) {
    derived_.remove_generated(key.second, *program);
  }
  last_ = nullptr;
  programs_.clear();
}

}  // namespace glark::core
