// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/programs.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "glark/core/state/programs/shader_includes.h"
#include "glark/core/state/share_group.h"

namespace glark::core {
namespace {

std::shared_ptr<const std::string> read_source(const gl::Dispatch& gl, GLuint shader) {
  GLint length = 0;
  gl.GetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  if (length <= 1) {
    return nullptr;
  }
  std::string source(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  gl.GetShaderSource(shader, length, &written, source.data());
  source.resize(static_cast<std::size_t>(written));
  return std::make_shared<const std::string>(std::move(source));
}

}  // namespace

Programs::Programs(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
                   ProgramWatcher& watcher)
    : gl_(gl),
      capabilities_(capabilities),
      share_(share),
      pending_(pending),
      watcher_(watcher),
      pipelines_(gl),
      assembly_(gl, share) {
  const std::lock_guard lock(share_.mutex);
  share_.contexts.push_back(this);
  mirroring_ = share_.any_derived.load();
}

Programs::~Programs() {
  const std::lock_guard lock(share_.mutex);
  std::erase(share_.contexts, this);
}

std::shared_ptr<Program> Programs::find(GLuint name) const {
  const std::lock_guard lock(share_.mutex);
  const auto found = share_.programs.find(name);
  if (found != share_.programs.end()) {
    return found->second;
  }
  const bool in_use = current_ != nullptr && name != 0 && current_->name == name;  // it was deleted, and lives on
  return in_use ? current_ : nullptr;
}

std::shared_ptr<Program> Programs::known(GLuint name) {
  std::shared_ptr<Program> program = find(name);
  if (program == nullptr) {
    ErrorScope errors(pending_);
    linked(name, read_stages(name));
    program = find(name);
  }
  return program;
}

void Programs::adopt(GLuint name) {
  current_ = name != 0 ? known(name) : nullptr;
  refresh_mirroring();
}

void Programs::refresh_mirroring() { mirroring_ = share_.any_derived.load(std::memory_order_relaxed); }

void Programs::uniforms_changed_unseen() {
  if (!share_.any_derived.load(std::memory_order_relaxed)) {
    return;
  }
  std::vector<std::shared_ptr<Program>> programs;  // a program's mutex may not be taken while the group's is held
  {
    const std::lock_guard lock(share_.mutex);
    for (const auto& [name, program] : share_.programs) {
      programs.push_back(program);
    }
  }
  for (const std::shared_ptr<Program>& program : programs) {
    const std::lock_guard lock(program->mutex);
    program->uniforms_stale = true;
  }
}

void Programs::mirror_from_now_on() {
  if (share_.any_derived.exchange(true)) {
    return;
  }
  const std::lock_guard lock(share_.mutex);
  for (Programs* context : share_.contexts) {
    context->mirroring_ = true;
  }
}

std::shared_ptr<Program> Programs::set_by_uniforms(const Bindings& bindings) {
  if (current_ == nullptr && bindings.program == 0 && bindings.pipeline != 0) {
    return find(pipelines_.object(bindings.pipeline).active);
  }
  return current_;
}

LockedMirrors Programs::locked_mirrors(std::shared_ptr<const Program> program, const Bindings& bindings) const {
  return program != nullptr ? LockedMirrors(std::move(program), gl_, bindings.debug_output) : LockedMirrors();
}

LockedMirrors Programs::mirrors(const Bindings& bindings) {
  return locked_mirrors(set_by_uniforms(bindings), bindings);
}

LockedMirrors Programs::mirrors(const Bindings& bindings, GLuint program) const {
  return locked_mirrors(find(program), bindings);
}

bool Programs::has_virtual_uniform(const Bindings& bindings, GLint location) {
  const std::shared_ptr<Program> program = set_by_uniforms(bindings);
  return program != nullptr && program->has_virtual_uniform(location);
}

bool Programs::has_virtual_uniform(const Bindings&, GLuint program, GLint location) const {
  const std::shared_ptr<Program> known = find(program);
  return known != nullptr && known->has_virtual_uniform(location);
}

namespace {

void note_handles(Program& program, GLint location, GLsizei count, const GLuint64* values) {
  const std::lock_guard lock(program.mutex);
  for (GLsizei i = 0; i < count && location >= 0 && values != nullptr; ++i) {
    program.handles[location + i] = values[i];
  }
}

}  // namespace

void Programs::set_handles(const Bindings& bindings, GLint location, GLsizei count, const GLuint64* values) {
  if (const std::shared_ptr<Program> program = set_by_uniforms(bindings); program != nullptr) {
    note_handles(*program, location, count, values);
  }
}

void Programs::set_handles(const Bindings&, GLuint program, GLint location, GLsizei count, const GLuint64* values) {
  if (const std::shared_ptr<Program> known = find(program); known != nullptr) {
    note_handles(*known, location, count, values);
  }
}

std::vector<StageSource> Programs::read_stages(GLuint program) const {
  GLint count = 0;
  gl_.GetProgramiv(program, GL_ATTACHED_SHADERS, &count);
  std::vector<GLuint> shaders(static_cast<std::size_t>(count));
  if (count > 0) {
    gl_.GetAttachedShaders(program, count, nullptr, shaders.data());
  }
  std::vector<StageSource> stages;
  for (const GLuint shader : shaders) {
    GLint stage = 0;
    gl_.GetShaderiv(shader, GL_SHADER_TYPE, &stage);
    std::shared_ptr<const std::string> source;
    {
      const std::lock_guard lock(share_.mutex);
      const auto found = share_.compiled_sources.find(shader);
      source = found != share_.compiled_sources.end() ? found->second : nullptr;
    }
    source = source != nullptr ? source : read_source(gl_, shader);
    if (source == nullptr || source->empty()) {
      return {};  // a binary or SPIR-V stage
    }
    stages.push_back({static_cast<GLenum>(stage), source});
  }
  return stages;
}

void Programs::compiled(GLuint shader, const std::vector<std::string>& paths) {
  if (!capabilities_.refinable || gl_.IsShader(shader) == GL_FALSE) {
    return;
  }
  std::shared_ptr<const std::string> source = read_source(gl_, shader);
  if (source != nullptr && may_include(*source)) {
    ErrorScope errors(pending_);
    source = std::make_shared<const std::string>(expand_includes(gl_, *source, paths));
  }
  const std::lock_guard lock(share_.mutex);
  share_.compiled_sources[shader] = std::move(source);
}

// SPIR-V takes the place of any source that the shader had.
void Programs::specialized(GLuint shader) {
  const std::lock_guard lock(share_.mutex);
  share_.compiled_sources[shader] = std::make_shared<const std::string>();
}

// A shader that is still attached stays alive and may be linked again; its source is read again then.
void Programs::shader_deleted(GLuint shader) {
  const std::lock_guard lock(share_.mutex);
  share_.compiled_sources.erase(shader);
}

void Programs::linked(GLuint name) {
  if (capabilities_.refinable && gl_.IsProgram(name) != GL_FALSE) {
    linked(name, read_stages(name));
  }
}

// Notes the stages of a program that was just linked, and drops the programs derived from the old stages.
void Programs::linked(GLuint name, std::vector<StageSource> stages) {
  if (!capabilities_.refinable || gl_.IsProgram(name) == GL_FALSE) {
    return;
  }
  std::shared_ptr<Program> program;
  {
    const std::lock_guard lock(share_.mutex);
    std::shared_ptr<Program>& slot = share_.programs[name];
    slot = slot != nullptr ? slot : std::make_shared<Program>();
    program = slot;
  }
  const std::lock_guard lock(program->mutex);
  watcher_.program_changed(*program, name);
  program->name = name;
  program->stages = std::move(stages);
  *program->told_notes = {};
  program->from_binary = program->stages.empty();
  program->may_store = program->from_binary || may_store(program->stages);
  GLint linked = GL_FALSE;
  gl_.GetProgramiv(name, GL_LINK_STATUS, &linked);
  program->linked = linked != GL_FALSE;
  program->link_settings =
      program->linked ? read_link_settings(gl_, name, program->has_old_geometry_shader()) : LinkSettings{};
  program->subroutines_asked = false;
  program->handles.clear();
  subroutines_.forget();
}

void Programs::deleted(GLuint name) {
  std::shared_ptr<Program> program;
  {
    const std::lock_guard lock(share_.mutex);
    const auto found = share_.programs.find(name);
    if (found == share_.programs.end()) {
      return;
    }
    program = found->second;
    share_.programs.erase(found);
  }
  const std::lock_guard lock(program->mutex);
  watcher_.program_changed(*program, name);
  // GL keeps a program in use until another one is used. We could not return to it after a refined draw.
  program->prepared = true;
  program->cause = Cause::program_gone;
}

}  // namespace glark::core
