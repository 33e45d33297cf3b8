// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/context.h"

#include <string>

#include "glark/core/report/log.h"
#include "glark/core/report/statistics.h"
#include "glark/core/stages.h"

namespace glark::core {
namespace {

// OpenGL ES has no glPolygonMode.
void drop_wireframe_of_es(const Capabilities& capabilities, ContextOptions& options) {
  if (capabilities.api == Capabilities::Api::es && options.wireframe) {
    log(LogLevel::warning,
        "OpenGL ES draws no wireframes: refined triangles are filled in context " + capabilities.version_text);
    options.wireframe = false;
  }
}

}  // namespace

std::shared_ptr<ShareGroup> make_share_group() { return std::make_shared<ShareGroup>(); }

Context::Context(const gl::Dispatch& dispatch, std::shared_ptr<ShareGroup> group, const ContextOptions& wanted)
    : gl_(dispatch),
      share_(std::move(group)),
      options_(wanted),
      pending_error_(dispatch),
      state_(dispatch, capabilities_, *share_, pending_error_, *this) {}

// Objects live on in the share group: another context deletes them.
Context::~Context() {
  const std::vector<GLuint> buffers = stages_ != nullptr ? stages_->take_kept_buffers() : std::vector<GLuint>();
  const std::lock_guard lock(share_->mutex);
  share_->orphaned_buffers.insert(share_->orphaned_buffers.end(), buffers.begin(), buffers.end());
}

std::unique_ptr<Context> Context::create(const gl::Dispatch& gl, std::shared_ptr<ShareGroup> share,
                                         const ContextOptions& options) {
  std::unique_ptr<Context> context(new Context(gl, std::move(share), options));
  if (gl.GetString != nullptr && gl.GetIntegerv != nullptr) {
    context->start();
  }
  context->update_refining();
  return context;
}

void Context::start() {
  ErrorScope errors(pending_error_);
  capabilities_ = read_capabilities(gl_);
  const std::string& version = capabilities_.version_text;
  if (version.empty()) {
    return;
  }
  note_context(version, capabilities_.refinable);
  drop_wireframe_of_es(capabilities_, options_);
  if (!capabilities_.refinable) {
    log(LogLevel::warning, "context " + version + " is below OpenGL 4.3 and OpenGL ES 3.2: its draws stay as they are");
    return;
  }
  state_.arrays().read_client_state();
  supported_ = supported_functions(gl_, capabilities_);
  stages_ = std::make_unique<Stages>(
      Environment{supported_, capabilities_, options_, ark_, state_, pending_error_, *share_, compilation_});
  const auto attributes = static_cast<GLuint>(capabilities_.max_vertex_attributes);
  ark_.tag_attribute = attributes - 1;
  ark_.discontinuity_attribute = attributes - 2;
  ark_.scalar_tag_attribute = attributes - 3;
}

void Context::change_options(ContextOptions wanted) {
  wanted.transparent = options_.transparent;
  wanted.roles = std::move(options_.roles);
  wanted.left_shaders = std::move(options_.left_shaders);
  wanted.read_counts = options_.read_counts;
  constexpr auto tension = static_cast<std::size_t>(Refinement::scalar_tagged_pn);
  wanted.shape_numbers[tension] = options_.shape_numbers[tension];  // a constant of the derived programs
  options_ = std::move(wanted);
  drop_wireframe_of_es(capabilities_, options_);
  update_refining();
}

void Context::release() {
  if (stages_ != nullptr) {
    stages_->release();
  }
}

void Context::frame_finished() {
  std::vector<GLuint> orphans;
  {
    const std::lock_guard lock(share_->mutex);
    orphans.swap(share_->orphaned_buffers);
  }
  if (!orphans.empty()) {
    gl_.DeleteBuffers(static_cast<GLsizei>(orphans.size()), orphans.data());
  }
  if (stages_ != nullptr) {
    stages_->frame_finished();
  }
}

void Context::program_changed(Program& program, GLuint name) { stages_->programs().changed(program, name); }

void Context::update_refining() {
  refining_ = capabilities_.refinable &&
              ((options_.transparent && !options_.live.paused) || (ark_.enabled && ark_.pool_level >= 0) ||
               state_.lists().cutting() || (stages_ != nullptr && stages_->feedback().watches_draws()));
}

}  // namespace glark::core
