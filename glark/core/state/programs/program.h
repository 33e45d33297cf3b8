// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program of the application: the sources it was linked from, and the programs that were derived from it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/objects/quiet.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/statistics.h"
#include "glark/core/state/programs/derived_program.h"
#include "glark/core/state/programs/link_settings.h"
#include "glark/core/state/programs/vertex_stage_traits.h"

namespace glark::core {

struct StageSource {
  GLenum stage;
  std::shared_ptr<const std::string> source;
};

// A number that is the same in every run for the same sources. Users name shader programs by it.
std::uint64_t source_hash(const std::vector<StageSource>& stages);
std::string hash_text(std::uint64_t hash);  // 16 hexadecimal digits
// The vertex stage may multiply by the matrix of GL_PROJECTION.
bool reads_conventional_projection(const std::vector<StageSource>& stages);
// The shaders may write buffers or images. Mistaking another program for such a one only costs what is kept.
bool may_store(const std::vector<StageSource>& stages);

// note_bits() of what the log and the application's debug output were told about a program.
struct ToldNotes {
  unsigned logged = 0;
  unsigned sent = 0;
};

struct Program {
  // Guards all members: contexts that share the program draw with it in their own threads. Recursive, because programs
  // are derived by draws and by queries, which hold it already.
  mutable std::recursive_mutex mutex;
  GLuint name = 0;  // the application's program; for the fixed function, a program of ours with the generated shader
  bool fixed_function = false;
  bool assembly = false;  // of ours: the GLSL of an assembly program
  std::vector<StageSource> stages;
  bool from_binary = false;
  bool linked = true;      // false: GL runs the executable from before the last link, and cannot return to it
  bool may_store = false;  // may_store()
  LinkSettings link_settings;
  bool prepared = false;       // the next four members are valid
  std::optional<Cause> cause;  // why it cannot be refined
  std::vector<capture::Field> fields;
  refine::VertexStageTraits traits;
  refine::VertexInputTraits input_traits;
  // How the outputs vary if the inputs at these locations have a divisor (bit i: location i). Only what was asked for.
  std::map<std::uint32_t, refine::StageVariation> instanced_variations;
  bool subroutines_asked = false;  // the next member is valid
  bool uses_subroutines = false;
  std::map<DerivedKey, std::shared_ptr<DerivedProgram>> derived;  // null: it could not be derived
  std::vector<UniformMirror> mirrors;
  std::string refinement_source;
  std::string refinement_log;
  std::vector<std::string> virtual_uniforms;                              // names, by location - virtual_location_base
  std::uint64_t hash = 0;                                                 // source_hash()
  bool left_alone = false;                                                // the user named its hash
  bool conventional_projection = false;                                   // reads_conventional_projection()
  bool counts_primitives = false;                                         // a stage mentions gl_PrimitiveID
  ProgramCounters* counters = nullptr;                                    // valid if prepared
  std::shared_ptr<ToldNotes> told_notes = std::make_shared<ToldNotes>();  // states of the fixed function share them
  std::map<GLint, GLuint64> handles;  // by location: bindless textures and images that uniforms name
  bool uniforms_stale = false;        // a display list changed uniforms: copy all values before the next refined draw

  bool has_virtual_uniform(GLint location) const {
    const std::lock_guard lock(mutex);
    return location - virtual_location_base < static_cast<GLint>(virtual_uniforms.size());
  }
  bool has_stage(GLenum stage) const {
    for (const StageSource& source : stages) {
      if (source.stage == stage) {
        return true;
      }
    }
    return false;
  }
  // A geometry shader is written for ARB_geometry_shader4, or EXT_geometry_shader4.
  bool has_old_geometry_shader() const;
};

// The mirrors of a program. They do not change during the lifetime of this object, and debug output does not report
// calls to them.
class LockedMirrors {
 public:
  LockedMirrors() = default;
  LockedMirrors(std::shared_ptr<const Program> program, const gl::Dispatch& gl, bool audible)
      : program_(std::move(program)),
        lock_(program_->mutex),
        mirrors_(program_->mirrors),
        quiet_(gl, audible && !mirrors_.empty()) {}
  auto begin() const { return mirrors_.begin(); }
  auto end() const { return mirrors_.end(); }

 private:
  std::shared_ptr<const Program> program_;
  std::unique_lock<std::recursive_mutex> lock_;
  std::span<const UniformMirror> mirrors_;
  Quiet quiet_;
};

}  // namespace glark::core
