// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's programs as one context sees them: which one is in use, and the sources it was linked from.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "glark/core/objects/error_scope.h"
#include "glark/core/state/assembly/assembly_state.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/programs/chosen_subroutines.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_pipelines.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

struct ShareGroup;

// Is told when a program was linked again or deleted, and drops the programs derived from it.
class ProgramWatcher {
 public:
  virtual void program_changed(Program& program, GLuint name) = 0;  // the program's mutex is held

 protected:
  ~ProgramWatcher() = default;
};

class Programs {
 public:
  Programs(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
           ProgramWatcher& watcher);
  ~Programs();
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  // Null: glark has not seen the program being linked.
  std::shared_ptr<Program> find(GLuint name) const;
  // Also reads programs from GL that were linked before glark knew the context. Null: there is no such program.
  std::shared_ptr<Program> known(GLuint name);
  // The hooks call these.
  // `paths`: in which relative names of included strings are looked up.
  void compiled(GLuint shader, const std::vector<std::string>& paths = {});
  void specialized(GLuint shader);
  void shader_deleted(GLuint shader);
  void linked(GLuint name);
  void linked(GLuint name, std::vector<StageSource> stages);
  void deleted(GLuint name);

  // The program in use. Null: no program is in use, or glark does not know it.
  const std::shared_ptr<Program>& current() const { return current_; }
  void use(std::shared_ptr<Program> program) { current_ = std::move(program); }
  // GL reports that this program is in use.
  void adopt(GLuint name);
  ProgramPipelines& pipelines() { return pipelines_; }
  AssemblyState& assembly() { return assembly_; }

  ChosenSubroutines& subroutines() { return subroutines_; }

  // Uniform calls must reach derived programs, too.
  bool mirroring() const { return mirroring_.load(std::memory_order_seq_cst); }
  void refresh_mirroring();
  // The derived programs that uniform calls must reach, too: those of the program in use, or of the one named.
  LockedMirrors mirrors(const Bindings& bindings);
  LockedMirrors mirrors(const Bindings& bindings, GLuint program) const;
  // A location that glark gave to a uniform of the refinement shader of the program in use, or of the one named.
  bool has_virtual_uniform(const Bindings& bindings, GLint location);
  bool has_virtual_uniform(const Bindings& bindings, GLuint program, GLint location) const;
  // glUniformHandleui64: programs that are derived later get the handles, too.
  void set_handles(const Bindings& bindings, GLint location, GLsizei count, const GLuint64* values);
  void set_handles(const Bindings& bindings, GLuint program, GLint location, GLsizei count, const GLuint64* values);
  // A display list has set uniforms, of the program in use or of another one.
  void uniforms_changed_unseen();
  // From the first derived program on, every context of the share group mirrors uniforms.
  void mirror_from_now_on();

 private:
  // The program whose uniforms glUniform* sets; null as for current().
  std::shared_ptr<Program> set_by_uniforms(const Bindings& bindings);
  LockedMirrors locked_mirrors(std::shared_ptr<const Program> program, const Bindings& bindings) const;
  std::vector<StageSource> read_stages(GLuint program) const;

  const gl::Dispatch& gl_;
  const Capabilities& capabilities_;
  ShareGroup& share_;
  PendingError& pending_;
  ProgramWatcher& watcher_;
  ProgramPipelines pipelines_;
  AssemblyState assembly_;
  std::shared_ptr<Program> current_;
  ChosenSubroutines subroutines_;
  std::atomic<bool> mirroring_ = false;  // any context of the group sets it
};

}  // namespace glark::core
