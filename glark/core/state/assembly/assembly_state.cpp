// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/assembly/assembly_state.h"

#include "glark/core/state/share_group.h"

namespace glark::core {

std::uint64_t AssemblyState::epoch() const { return share_.assembly.epoch.load(std::memory_order_relaxed); }

// GL may refuse a name that is not known to be a vertex program.
void AssemblyState::bound(GLuint name) {
  const std::lock_guard lock(share_.mutex);
  const auto known = share_.assembly.by_name.find(name);
  bound_ = known != share_.assembly.by_name.end() ? known->second : nullptr;
}

void AssemblyState::loaded() {
  find_bound();
  GLint error = -1;
  gl_.GetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &error);
  const std::lock_guard lock(bound_->mutex);
  bound_->text_number = bound_->refused == (error != -1) ? bound_->text_number : 0;
  bound_->refused = error != -1;
  bound_->text_epoch = 0;
}

void AssemblyState::loaded(GLuint name) {
  const std::lock_guard lock(share_.mutex);
  const auto known = share_.assembly.by_name.find(name);
  if (known != share_.assembly.by_name.end()) {
    const std::lock_guard program_lock(known->second->mutex);
    known->second->text_epoch = 0;
  }
}

void AssemblyState::deleted(std::span<const GLuint> names) {
  const std::lock_guard lock(share_.mutex);
  for (const GLuint name : names) {
    if (name != 0) {
      share_.assembly.by_name.erase(name);
    }
  }
  bound_ = nullptr;
}

void AssemblyState::set_environment(GLuint first, const GLfloat* values, GLsizei count) {
  environment_.set(epoch(), first, values, count);
}

void AssemblyState::set_local(GLuint first, const GLfloat* values, GLsizei count) {
  find_bound();
  const std::lock_guard lock(bound_->mutex);
  bound_->local.set(epoch(), first, values, count);
}

void AssemblyState::forget() {
  bound_ = nullptr;
  share_.assembly.epoch.fetch_add(1, std::memory_order_relaxed);
}

void AssemblyState::find_bound() {
  if (bound_ != nullptr) {
    return;
  }
  GLint name = 0;
  gl_.GetProgramivARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_BINDING_ARB, &name);
  const std::lock_guard lock(share_.mutex);
  std::shared_ptr<AssemblyProgram>& slot = share_.assembly.by_name[static_cast<GLuint>(name)];
  if (slot == nullptr) {
    slot = std::make_shared<AssemblyProgram>();
  }
  bound_ = slot;
}

const std::shared_ptr<AssemblyProgram>& AssemblyState::current() {
  find_bound();
  const std::lock_guard lock(bound_->mutex);
  if (bound_->text_epoch != epoch()) {
    read_text(*bound_);
  }
  return bound_;
}

// Some applications load the same text again and again.
void AssemblyState::read_text(AssemblyProgram& program) const {
  GLint length = 0;
  gl_.GetProgramivARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  gl_.GetProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_STRING_ARB, text.data());
  program.text_epoch = epoch();
  if (program.text_number == 0 || text != program.text) {
    program.text = std::move(text);
    program.text_number = share_.assembly.texts.fetch_add(1, std::memory_order_relaxed) + 1;
  }
}

std::uint64_t AssemblyState::local_stamp(AssemblyProgram& program) const {
  const std::lock_guard lock(program.mutex);
  return program.local.stamp(epoch());
}

const GLfloat* AssemblyState::environment(GLuint first, GLuint count) {
  return environment_.read(epoch(), first, count, [this](GLuint index, GLfloat* value) {
    gl_.GetProgramEnvParameterfvARB(GL_VERTEX_PROGRAM_ARB, index, value);
  });
}

void AssemblyState::ask_local(GLuint index, GLfloat* value) const {
  gl_.GetProgramLocalParameterfvARB(GL_VERTEX_PROGRAM_ARB, index, value);
}

}  // namespace glark::core
