// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Everything that glark keeps for one OpenGL context: the options it was made with, the application's state, and the
// stages that draw with it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "glark/core/ark_state.h"
#include "glark/core/context_options.h"
#include "glark/core/objects/error_scope.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/state/arrays/buffer_writes.h"
#include "glark/core/state/attribute_stack.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/gl_state.h"
#include "glark/core/state/lists/state_changes.h"
#include "glark/core/state/share_group.h"
#include "glark/core/state/textures/texture_writes.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class Stages;

class Context final : private ProgramWatcher {
 public:
  // The context must be current. `gl` outlives it.
  static std::unique_ptr<Context> create(const gl::Dispatch& gl, std::shared_ptr<ShareGroup> share,
                                         const ContextOptions& options);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Deletes our GL objects; only while the context is current. The destructor alone leaves them to the driver.
  void release();
  // Between two frames, while the context is current. `transparent`, the roles of attributes, the tension, the shaders
  // that are left alone and `read_counts` stay as they were when the context was created.
  void change_options(ContextOptions wanted);
  // At the end of a frame: before buffers are swapped, or when the context is current again after another one has shown
  // its pictures.
  void frame_finished();

  const gl::Dispatch& gl() const { return gl_; }  // for the application's calls
  const Capabilities& capabilities() const { return capabilities_; }
  ContextOptions& options() { return options_; }
  const ContextOptions& options() const { return options_; }
  ArkState& ark() { return ark_; }
  const ArkState& ark() const { return ark_; }
  ShareGroup& share() const { return *share_; }
  GlState& state() { return state_; }
  const GlState& state() const { return state_; }
  // Record writes to buffers and textures, and state changes.
  BufferWrites writes() { return {state_.arrays(), state_.stamps(), share_->buffers}; }
  TextureWrites textures() { return {gl_, state_, share_->textures}; }
  StateChanges changes() { return StateChanges(state_); }
  // Saves GL_ARK.
  AttributeStack& attribute_stack() { return attribute_stack_; }
  PendingError& pending_error() { return pending_error_; }
  // Null: the context cannot refine.
  Stages* stages() const { return stages_.get(); }

  // Draw calls must reach their hooks.
  bool refining() const { return refining_; }
  // Recomputes `refining` after a change of the state that it depends on.
  void update_refining();

 private:
  Context(const gl::Dispatch& dispatch, std::shared_ptr<ShareGroup> group, const ContextOptions& wanted);
  void start();
  void program_changed(Program& program, GLuint name) override;

  const gl::Dispatch& gl_;
  gl::Dispatch supported_;  // for our calls: only what the context offers
  std::shared_ptr<ShareGroup> share_;
  ContextOptions options_;
  Capabilities capabilities_;
  ArkState ark_;
  AttributeStack attribute_stack_;
  PendingError pending_error_;
  GlState state_;
  Compilation compilation_{supported_};
  bool refining_ = false;
  std::unique_ptr<Stages> stages_;
};

}  // namespace glark::core
