// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pipeline.h"

#include <algorithm>
#include <string>
#include <utility>

#include "glark/core/context.h"
#include "glark/core/refine/fixed_function/state.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/shape.h"

namespace glark::core {
namespace {

capture::Language language_of(const Capabilities& capabilities) {
  switch (capabilities.api) {
    case Capabilities::Api::es: return capture::Language::es;
    case Capabilities::Api::core: return capture::Language::core;
    default: return capture::Language::compatibility;
  }
}

refine::BuilderTraits builder_traits(const Capabilities& capabilities, const ContextOptions& options) {
  refine::BuilderTraits traits;
  traits.language = language_of(capabilities);
  traits.roles = options.roles;
  traits.scalar_tags = constant_tags(options);
  traits.transparent = options.transparent;
  traits.glsl_version = capabilities.version * 10;
  traits.extensions = capabilities.extensions;
  traits.max_vertex_attributes = capabilities.max_vertex_attributes;
  traits.max_feedback_components = capabilities.max_feedback_components;
  traits.max_vertex_storage_blocks = capabilities.max_vertex_storage_blocks;
  traits.lattice_location = submit::lattice_location;
  traits.patch_location = submit::patch_location;
  traits.first_chunk_location = submit::first_chunk_location;
  return traits;
}

// Bytes that a glBegin..glEnd may capture: the number of its vertices is known only at its end.
constexpr std::uint64_t most_immediate_bytes = std::uint64_t{512} << 20;

}  // namespace

Pipeline::Pipeline(Context& context)
    : context_(context),
      gl_(context.supported()),
      capture_(context.supported(), language_of(context.capabilities()), context.capabilities().query_buffer),
      weld_(context.supported(), language_of(context.capabilities())),
      centroids_(context.supported()),
      measure_(context.supported(), language_of(context.capabilities())),
      bins_(context.supported(), language_of(context.capabilities())),
      ordered_(context.supported(), language_of(context.capabilities())),
      submit_(context.supported()),
      builder_(context.supported(), builder_traits(context.capabilities(), context.options())) {}

bool Pipeline::build_pool(unsigned max_level) {
  const Quiet quiet = context_.state().quiet();
  if (!pool_.build(gl_, max_level, geomorphs(context_.options(), context_.ark()))) {
    return false;
  }
  ++pools_built_;
  bins_ready_ = false;
  return true;
}

bool Pipeline::takes_in_order(const Plan& plan, const capture::CoarseTriangles& triangles) const {
  return (plan.morphing || !context_.ark().smooth_interior) && !plan.derived->stored() &&
         ordered_.takes(*plan.layout, triangles, plan.deepest);
}

depth::BinnedInstances Pipeline::sort(const Plan& plan, const Records& records) {
  const Bindings& b = context_.state().bindings();
  counted_on_gpu_ = true;
  const unsigned deepest = plan.coarse ? 0 : pool_.max_level();
  const depth::MeasureRequest measured{plan.layout,        records.triangles, plan.corner_program,
                                       plan.normal_offset, deepest,           plan.depth_steps()};
  depth::EdgeEnds ends;
  if (plan.measured) {
    ends = measure_.find_ends(measured, measure(), bins_.work_buffer(), b);
  }
  // The application's queries have counted what was captured in here, too.
  std::uint64_t captured = plan.corner_program != 0 ? records.triangles.count : 0;
  depth::BinnedInstances bins;
  if (takes_in_order(plan, records.triangles)) {
    bins = ordered_.sort({measured, ends, bins_.work_buffer(), records.tags_are_edge_depths}, b);
  } else {
    const pattern::Interior interior = plan.morphing                    ? pattern::Interior::morphing
                                       : context_.ark().smooth_interior ? pattern::Interior::smooth
                                                                        : pattern::Interior::minimum;
    depth::BinRequest request{plan.layout, records.triangles, 0, deepest, interior, records.tags_are_edge_depths, {}};
    if (plan.measured) {
      request.measured = measure_.measure(measured, b);
    }
    bins = bins_.sort(request, records.count_command->name(), b);
    captured += b.primitives_generated_query != 0 || b.primitives_written_query != 0 ? bins_.instances_of_last() : 0;
  }
  add_surplus(static_cast<std::int64_t>(captured));
  return bins;
}

void Pipeline::submit(const Plan& plan, const capture::CoarseTriangles& captured, const Keeping& keeping) {
  const Bindings& b = context_.state().bindings();
  copy_stale_uniforms(plan);
  if (b.primitive_restart) {
    gl_.Disable(GL_PRIMITIVE_RESTART);  // our indices are none of the application's, those that sort neither
  }
  const bool sorted = plan.keeps_bins() && keeping.filled;
  const Records records = sorted ? Records{captured} : records_of(plan, captured);
  const bool indirect = plan.adaptive || records.triangles.count_on_gpu;
  if (indirect && b.parameter_buffer != 0) {
    gl_.BindBuffer(GL_PARAMETER_BUFFER, 0);  // Mesa 22 takes the count of any indirect draw from it
  }
  depth::BinnedInstances bins;
  if (plan.adaptive) {
    bins = binned(plan, records, keeping);
  }
  if (storage_changed_ || (!sorted && (plan.adaptive || plan.polygons))) {
    restore_storage();  // the vertex stage may read it
  }
  raise_edge_flag();
  const bool captures = owns_feedback() && !b.transform_feedback_paused;
  if (captures && feedback_mode_ != GL_TRIANGLES) {
    capture_.set_feedback_mode(plan.capture_program, feedback_mode_, b);
  }
  use_derived(plan);
  if (captures) {
    gl_.ResumeTransformFeedback();
    feedback_begun_ = true;
  }
  set_modes(plan);
  const bool stored = plan.derived->stored();
  set_shape(context_, *plan.derived);
  if (stored) {
    const GLintptr first_word = plan.adaptive ? 0 : records.triangles.offset / 4;
    gl_.ProgramUniform1i(plan.derived->name, plan.derived->first_word, static_cast<GLint>(first_word));
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, refine::records_binding,
                       plan.adaptive ? bins.records : records.triangles.buffer);
  }
  if (plan.adaptive) {
    submit_.draw_binned(pool_, bins, {stored ? 0 : plan.layout->chunk_count(), plan.derived->numbered});
  } else {
    submit_.draw_uniform(pool_,
                         {records.triangles, plan.layout, stored, plan.level, plan.placed, records.count_command});
    statistics().refined_triangles +=
        records.triangles.count_on_gpu ? 0 : std::uint64_t{records.triangles.count} << (2 * plan.level);
  }
  reset_modes(plan);
  if (captures) {
    gl_.PauseTransformFeedback();
  }
  if (indirect && b.parameter_buffer != 0) {
    gl_.BindBuffer(GL_PARAMETER_BUFFER, b.parameter_buffer);
  }
  restore({.indirect = indirect, .storage = stored});
}

bool Pipeline::selects_back_colors(const Plan& plan) const {
  return plan.program->fixed_function && fixed_function_state_.two_sided && !context_.state().bindings().two_side;
}

// Fixed-function lighting adds the separate specular colour by itself, a vertex shader only with GL_COLOR_SUM.
bool Pipeline::adds_specular_colors(const Plan& plan) const {
  return plan.program->fixed_function && plan.owner == nullptr && fixed_function_state_.lighting &&
         fixed_function_state_.separate_specular && !fixed_function_state_.color_sum;
}

// Fixed function attenuates points by itself, a vertex shader says their size only with GL_PROGRAM_POINT_SIZE.
bool Pipeline::sets_point_size(const Plan& plan) const {
  return plan.program->fixed_function && fixed_function_state_.point_size != fixed_function_state_.program_point_size;
}

void Pipeline::set_point_size(bool by_program) {
  by_program ? gl_.Enable(GL_PROGRAM_POINT_SIZE) : gl_.Disable(GL_PROGRAM_POINT_SIZE);
}

// The current one; our vertex arrays have no array of them.
void Pipeline::raise_edge_flag() {
  if (!takes_edge_flags() && !(context_.is_compatibility() && context_.options().wireframe)) {
    return;
  }
  const CurrentValue* known = context_.state().current_values().find(edge_flag_slot);
  if (known == nullptr) {
    GLboolean flag = GL_TRUE;
    gl_.GetBooleanv(GL_EDGE_FLAG, &flag);
    const auto set = [](const gl::Dispatch& gl, GLuint, const void* components) {
      gl.EdgeFlag(*static_cast<const GLboolean*>(components));
    };
    context_.state().current_values().set(edge_flag_slot, set, 0, &flag, sizeof(flag));
    known = context_.state().current_values().find(edge_flag_slot);
  }
  edge_flag_raised_ = std::all_of(known->components.begin(), known->components.begin() + known->bytes,
                                  [](unsigned char part) { return part == 0; });
  if (edge_flag_raised_) {
    gl_.EdgeFlag(GL_TRUE);
  }
}

void Pipeline::reset_edge_flag() {
  if (std::exchange(edge_flag_raised_, false)) {
    gl_.EdgeFlag(GL_FALSE);
  }
}

void Pipeline::set_modes(const Plan& plan) {
  if (selects_back_colors(plan)) {
    gl_.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  if (adds_specular_colors(plan)) {
    gl_.Enable(GL_COLOR_SUM);
  }
  if (sets_point_size(plan)) {
    set_point_size(fixed_function_state_.point_size);
  }
  if (context_.options().wireframe && gl_.PolygonMode != nullptr) {
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  }
}

void Pipeline::reset_modes(const Plan& plan) {
  reset_edge_flag();
  const Bindings& b = context_.state().bindings();
  if (context_.options().wireframe && gl_.PolygonMode != nullptr) {
    if (context_.is_compatibility()) {
      gl_.PolygonMode(GL_FRONT, b.front_polygon_mode);
      gl_.PolygonMode(GL_BACK, b.back_polygon_mode);
    } else {
      gl_.PolygonMode(GL_FRONT_AND_BACK, b.front_polygon_mode);
    }
  }
  if (selects_back_colors(plan)) {
    gl_.Disable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  if (adds_specular_colors(plan)) {
    gl_.Disable(GL_COLOR_SUM);
  }
  if (sets_point_size(plan)) {
    set_point_size(fixed_function_state_.program_point_size);
  }
  if (b.primitive_restart) {
    gl_.Enable(GL_PRIMITIVE_RESTART);
  }
}

void Pipeline::restore(const Changed& changed) {
  const Bindings& b = context_.state().bindings();
  gl_.BindVertexArray(b.vertex_array);
  use_application_program();
  if (changed.indirect) {
    gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, b.draw_indirect_buffer);
  }
  if (changed.storage) {
    restore_storage();
  }
}

void Pipeline::restore_storage() {
  storage_changed_ = false;
  const Bindings& b = context_.state().bindings();
  for (GLuint i = 0; i < b.storage.size(); ++i) {
    const IndexedBuffer& binding = b.storage[i];
    if (binding.size > 0 && binding.buffer != 0) {
      gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, i, binding.buffer, binding.offset, binding.size);
    } else {
      gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, binding.buffer);
    }
  }
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, b.storage_buffer);
}

void Pipeline::draw(const DrawCall& call) {
  ++statistics().draws_seen;
  const Quiet quiet = context_.state().quiet();
  take_awaited_feedback();
  Plan plan;
  Cause cause = plan_draw(call, plan);
  if (cause == Cause::count_ && call.triangles > 0) {
    cause = ensure_room(plan, call.triangles);
  }
  if (cause == Cause::not_triangles && feedback_refuses(call.mode)) {
    context_.raise(GL_INVALID_OPERATION);
    return;
  }
  if (cause != Cause::count_ || call.triangles == 0) {
    count_passed(cause != Cause::count_ ? cause : Cause::not_triangles);
    quiet.interrupt();
    call.issue();
    quiet.hush();
    return;
  }
  Keeping keeping = look_up(call, plan);
  const capture::CoarseTriangles triangles = capture_draw(call, plan, keeping, quiet);
  if (triangles.count == 0) {
    restore({});
    return;
  }
  submit(plan, triangles, keeping);
  count_refined(plan);
  if (triangles.count_on_gpu) {
    uncounted_capture_ = true;
    uncounted_level_ = plan.adaptive ? 0 : plan.level;
  } else {
    statistics().coarse_triangles += triangles.count;
  }
}

// What the query of the last inexact capture has counted.
void Pipeline::read_uncounted() {
  if (!uncounted_capture_) {
    return;
  }
  uncounted_capture_ = false;
  const std::uint64_t coarse = capture_.counted(context_.state().bindings());
  statistics().coarse_triangles += coarse;
  statistics().refined_triangles += uncounted_level_ > 0 ? coarse << (2 * uncounted_level_) : 0;
}

void Pipeline::read_counts() {
  if (!context_.options().read_counts) {
    return;
  }
  ErrorScope errors(context_.pending_error());
  read_uncounted();
  if (counted_on_gpu_) {
    statistics().refined_triangles += bins_.take_refined_triangles();
    counted_on_gpu_ = false;
  }
}

std::uint64_t Pipeline::begin_immediate(GLenum mode) {
  const auto nothing = [] {};
  const DrawCall call{.mode = mode,
                      .tags_vary = !context_.options().transparent && context_.ark().depth_source == DepthSource::tag,
                      .whole_polygons = true,
                      .issue = nothing};
  ++statistics().draws_seen;
  const Quiet quiet = context_.state().quiet();
  immediate_plan_ = Plan{};
  Cause cause = plan_draw(call, immediate_plan_);
  std::uint64_t capacity = 0;
  if (cause == Cause::count_) {
    capacity = immediate_bytes_ / static_cast<std::uint64_t>(immediate_plan_.layout->triangle_words() * 4);
    cause = ensure_room(immediate_plan_, capacity);
  }
  if (cause != Cause::count_) {
    count_passed(cause);
    return 0;
  }
  // glArrayElement may restart the primitive.
  immediate_exact_ = !context_.state().bindings().primitive_restart && !context_.state().immediate().elements_restart;
  begin_capture(immediate_plan_, immediate_exact_ ? capture::Count::known : capture::Count::by_query, nullptr);
  return capacity;
}

void Pipeline::end_immediate(std::uint64_t triangles) {
  const Quiet quiet(
      gl_, context_.state().bindings().debug_output);  // while our feedback is bound, bindings are not read again
  const std::uint64_t capacity =
      immediate_bytes_ / static_cast<std::uint64_t>(immediate_plan_.layout->triangle_words() * 4);
  if (triangles > capacity) {
    log(LogLevel::warning,
        "glBegin..glEnd of " + std::to_string(triangles) + " joined triangles exceeds the " + std::to_string(capacity) +
            " that are captured at once; the rest is not drawn this time; use vertex arrays for meshes of this size");
    immediate_bytes_ = std::min(2 * immediate_bytes_, most_immediate_bytes);
    triangles = capacity;
  }
  const capture::CoarseTriangles captured = end_capture(immediate_plan_, triangles, immediate_exact_);
  ++statistics().captures_made;
  if (triangles == 0) {
    restore({});
    return;
  }
  // Their number is known only now: what would have been left alone is drawn as it was captured, at level 0.
  const Cause cause =
      leaves_draws() && !immediate_plan_.adaptive ? exemption(*immediate_plan_.program, triangles) : Cause::count_;
  if (cause != Cause::count_) {
    immediate_plan_.level = 0;
    count_passed(cause);
  } else {
    count_refined(immediate_plan_);
  }
  submit(immediate_plan_, captured, {});
  immediate_plan_ = Plan{};  // what it was derived from may go
  statistics().coarse_triangles += triangles;
}

void Pipeline::frame_finished() {
  const Quiet quiet(gl_, context_.state().bindings().debug_output);
  read_counts();
  measure_.frame_finished();
  kept_.frame_finished(gl_);
}

void Pipeline::release() {
  const Quiet quiet(gl_, context_.state().bindings().debug_output);
  ErrorScope errors(context_.pending_error());
  read_counts();
  for (auto& [key, program] : fixed_function_) {
    discard_fixed_function(key.second, *program);
  }
  fixed_function_.clear();
  kept_.release(gl_);
  capture_.release();
  capture_programs_.clear();
  weld_.release();
  centroids_.release();
  measure_.release();
  bins_.release();
  ordered_.release();
  submit_.release();
  context_.state().programs().pipelines().release();
  pool_.release(gl_);
  bins_ready_ = false;
}

}  // namespace glark::core
