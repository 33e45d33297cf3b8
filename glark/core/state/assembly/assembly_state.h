// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The assembly vertex program of a context and its parameters. The hooks keep it up to date. Unknown state is asked for
// when a draw needs it.
#pragma once

#include <memory>
#include <span>

#include "glark/core/state/assembly/assembly_program.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

struct ShareGroup;

class AssemblyState {
 public:
  AssemblyState(const gl::Dispatch& gl, ShareGroup& share) : gl_(gl), share_(share) {}

  // The hooks call these after GL.
  void bound(GLuint name);
  void loaded();             // the text of the current program
  void loaded(GLuint name);  // the text of any program
  void deleted(std::span<const GLuint> names);
  void set_environment(GLuint first, const GLfloat* values, GLsizei count);
  void set_local(GLuint first, const GLfloat* values, GLsizei count);
  // A call that is not followed may have changed any of this.
  void forget();

  // The program that is bound; its text is up to date.
  const std::shared_ptr<AssemblyProgram>& current();
  // Changes whenever a parameter may have changed.
  std::uint64_t environment_stamp() { return environment_.stamp(epoch()); }
  std::uint64_t local_stamp(AssemblyProgram& program) const;
  // Hand the values of a range to `use`. Local parameters are those of the current program.
  const GLfloat* environment(GLuint first, GLuint count);
  template <typename Use>
  void with_local(AssemblyProgram& program, GLuint first, GLuint count, const Use& use) const {
    const std::lock_guard lock(program.mutex);
    use(program.local.read(epoch(), first, count, [this](GLuint index, GLfloat* value) { ask_local(index, value); }));
  }

 private:
  std::uint64_t epoch() const;
  void find_bound();
  void read_text(AssemblyProgram& program) const;
  void ask_local(GLuint index, GLfloat* value) const;

  const gl::Dispatch& gl_;
  ShareGroup& share_;
  std::shared_ptr<AssemblyProgram> bound_;  // null: not known
  ProgramParameters environment_;
};

}  // namespace glark::core
