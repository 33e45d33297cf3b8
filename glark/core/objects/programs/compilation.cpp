// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/programs/compilation.h"

#include <array>
#include <chrono>

#include "glark/core/objects/buffer_names.h"
#include "glark/core/objects/gpu_buffer.h"

namespace glark::core {
namespace {

void tell(const std::optional<ProgressLine>& line) {
  if (line) {
    log(line->level, line->text);
  }
}

}  // namespace

double Compilation::seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Every frame compiles at least one program, however long that takes.
bool Compilation::may_begin(const void* which) {
  if (pace_ == CompilePace::at_once || programs_ == 0 || seconds_ < seconds_a_frame) {
    waiting_.erase(which);
    return true;
  }
  waiting_.insert(which);
  refused_ = true;
  return false;
}

bool Compilation::build(ComputePass& pass, const ComputeText& text, std::span<const char* const> uniforms) {
  if (pass.built() || pass.failed()) {
    return pass.built();
  }
  if (!may_begin(&pass)) {
    return false;
  }
  const Step step(*this);
  if (!pass.build(gl_, text, uniforms)) {
    return false;
  }
  if (pace_ == CompilePace::spread && !in_turns_) {
    warm_up(pass);
  }
  return true;
}

// Software renderers compile at the first dispatch. An indirect dispatch of no work groups makes them do it now.
void Compilation::warm_up(const ComputePass& pass) {
  GLint program = 0;
  GLint buffer = 0;
  gl_.GetIntegerv(GL_CURRENT_PROGRAM, &program);
  gl_.GetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &buffer);
  if (no_groups_ == 0) {
    constexpr std::array<GLuint, 3> none{};
    const CopyWriteBinding binding(gl_, 0);
    no_groups_ = bind_new_buffer(gl_);
    gl_.BufferData(GL_COPY_WRITE_BUFFER, sizeof(none), none.data(), GL_STATIC_DRAW);
  }
  gl_.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, no_groups_);
  pass.use(gl_);
  gl_.DispatchComputeIndirect(0);
  gl_.UseProgram(static_cast<GLuint>(program));
  gl_.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, static_cast<GLuint>(buffer));
}

void Compilation::begin_turn() {
  pace_ = CompilePace::spread;
  in_turns_ = true;
  refused_ = false;
  seconds_ = 0;
  programs_ = 0;
}

void Compilation::note(double seconds, Step::Kind kind) {
  seconds_ += seconds;
  if (kind == Step::Kind::first_draw) {
    progress_.add(seconds);
    return;
  }
  ++programs_;
  tell(progress_.compiled(seconds, waiting_.size()));
}

void Compilation::frame_finished() {
  if (programs_ == 0) {  // so nothing waits for the next frame
    waiting_.clear();
    tell(progress_.finished());
  }
  seconds_ = 0;
  programs_ = 0;
  shown_frame_ = true;
}

void Compilation::release() {
  if (no_groups_ != 0) {
    gl_.DeleteBuffers(1, &no_groups_);
    no_groups_ = 0;
  }
}

}  // namespace glark::core
