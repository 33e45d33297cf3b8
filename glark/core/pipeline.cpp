// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pipeline.h"

#include <algorithm>
#include <string>

#include "glark/core/context.h"
#include "glark/core/refine/fixed_function_state.h"
#include "glark/core/refine/uniform_copy.h"

namespace glark::core {
namespace {

capture::Language language_of(const Capabilities& capabilities) {
  switch (capabilities.api) {
    case Capabilities::Api::es: return capture::Language::es;
    case Capabilities::Api::core: return capture::Language::core;
    default: return capture::Language::compatibility;
  }
}

refine::BuilderTraits builder_traits(const Capabilities& capabilities) {
  refine::BuilderTraits traits;
  traits.language = language_of(capabilities);
  traits.glsl_version = capabilities.version * 10;
  traits.extensions = capabilities.extensions;
  traits.max_vertex_attributes = capabilities.max_vertex_attributes;
  traits.max_feedback_components = capabilities.max_feedback_components;
  traits.lattice_location = submit::lattice_location;
  traits.patch_location = submit::patch_location;
  traits.first_chunk_location = submit::first_chunk_location;
  return traits;
}

// Bytes that a glBegin..glEnd may capture: the number of its vertices is known only at its end.
constexpr std::uint64_t immediate_bytes = std::uint64_t{32} << 20;

}  // namespace

Pipeline::Pipeline(Context& context)
    : context_(context),
      gl_(context.supported),
      capture_(context.supported, language_of(context.capabilities), context.capabilities.query_buffer),
      centroids_(context.supported),
      bins_(context.supported, language_of(context.capabilities)),
      submit_(context.supported),
      builder_(context.supported, builder_traits(context.capabilities)) {}

bool Pipeline::build_pool(unsigned max_level) {
  if (!pool_.build(gl_, max_level)) {
    return false;
  }
  ++pools_built_;
  bins_ready_ = false;
  return true;
}

depth::BinnedInstances Pipeline::sort(const Plan& plan, const Records& records) {
  const Bindings& b = context_.bindings;
  const depth::BinRequest request{plan.layout, records.triangles, 0, context_.ark.smooth_interior,
                                  records.tags_are_edge_depths};
  const depth::BinnedInstances bins = bins_.sort(request, records.count_command->name(), b);
  counted_on_gpu_ = true;
  // The application's queries have counted the reordering too.
  for (const GLuint query : {b.primitives_generated_query, b.primitives_written_query}) {
    if (query != 0) {
      context_.query_surplus[query] += bins_.instances_of_last();
    }
  }
  return bins;
}

void Pipeline::submit(const Plan& plan, const capture::CoarseTriangles& captured, const Keeping& keeping) {
  const Bindings& b = context_.bindings;
  copy_stale_uniforms(plan);
  const bool sorted = plan.adaptive && keeping.filled;
  const Records records = sorted ? Records{captured} : records_of(plan, captured);
  const bool indirect = plan.adaptive || records.triangles.count_on_gpu;
  if (indirect && b.parameter_buffer != 0) {
    gl_.BindBuffer(GL_PARAMETER_BUFFER, 0);  // Mesa 22 takes the count of any indirect draw from it
  }
  depth::BinnedInstances bins;
  if (plan.adaptive) {
    bins = binned(plan, records, keeping);
  }
  gl_.UseProgram(plan.derived->name);
  if (owns_feedback()) {
    gl_.ResumeTransformFeedback();
  }
  set_modes(plan);
  if (plan.adaptive) {
    submit_.draw_binned(pool_, bins, *plan.layout);
  } else {
    submit_.draw_uniform(pool_, {records.triangles, plan.layout, plan.level, plan.placed, records.count_command});
    statistics().refined_triangles +=
        records.triangles.count_on_gpu ? 0 : std::uint64_t{records.triangles.count} << (2 * plan.level);
  }
  reset_modes(plan);
  if (owns_feedback()) {
    gl_.PauseTransformFeedback();
  }
  if (indirect && b.parameter_buffer != 0) {
    gl_.BindBuffer(GL_PARAMETER_BUFFER, b.parameter_buffer);
  }
  restore({.indirect = indirect, .storage = !sorted && (plan.adaptive || plan.polygons)});
}

bool Pipeline::selects_back_colors(const Plan& plan) const {
  return plan.program->fixed_function && fixed_function_state_.two_sided && !context_.bindings.two_side;
}

// Fixed-function lighting adds the separate specular colour by itself, a vertex shader only with GL_COLOR_SUM.
bool Pipeline::adds_specular_colors(const Plan& plan) const {
  return plan.program->fixed_function && plan.owner == nullptr && fixed_function_state_.lighting &&
         fixed_function_state_.separate_specular && !fixed_function_state_.color_sum;
}

void Pipeline::set_modes(const Plan& plan) {
  if (context_.bindings.primitive_restart) {
    gl_.Disable(GL_PRIMITIVE_RESTART);
  }
  if (selects_back_colors(plan)) {
    gl_.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  if (adds_specular_colors(plan)) {
    gl_.Enable(GL_COLOR_SUM);
  }
  if (context_.options.wireframe && gl_.PolygonMode != nullptr) {
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  }
}

void Pipeline::reset_modes(const Plan& plan) {
  const Bindings& b = context_.bindings;
  if (context_.options.wireframe && gl_.PolygonMode != nullptr) {
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
  if (b.primitive_restart) {
    gl_.Enable(GL_PRIMITIVE_RESTART);
  }
}

void Pipeline::restore(const Changed& changed) {
  const Bindings& b = context_.bindings;
  gl_.BindVertexArray(b.vertex_array);
  gl_.UseProgram(b.program);
  if (changed.indirect) {
    gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, b.draw_indirect_buffer);
  }
  if (changed.storage) {
    restore_storage();
  }
}

void Pipeline::restore_storage() {
  const Bindings& b = context_.bindings;
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
  Plan plan;
  Cause cause = plan_draw(call, plan);
  if (cause == Cause::count_ && call.triangles > 0) {
    cause = ensure_room(plan, call.triangles);
  }
  if (cause != Cause::count_ || call.triangles == 0) {
    count_passed(cause != Cause::count_ ? cause : Cause::not_triangles);
    call.issue();
    return;
  }
  Keeping keeping = look_up(call, plan);
  const capture::CoarseTriangles triangles = capture_draw(call, plan, keeping);
  submit(plan, triangles, keeping);
  ++statistics().draws_refined;
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
  const std::uint64_t coarse = capture_.counted(context_.bindings);
  statistics().coarse_triangles += coarse;
  statistics().refined_triangles += uncounted_level_ > 0 ? coarse << (2 * uncounted_level_) : 0;
}

void Pipeline::read_counts() {
  if (!context_.options.read_counts) {
    return;
  }
  ErrorScope errors(context_);
  read_uncounted();
  if (counted_on_gpu_) {
    statistics().refined_triangles += bins_.take_refined_triangles();
    counted_on_gpu_ = false;
  }
}

bool Pipeline::begin_immediate(GLenum mode) {
  const auto nothing = [] {};
  const DrawCall call{.mode = mode,
                      .tags_vary = !context_.options.transparent && context_.ark.depth_source == DepthSource::tag,
                      .whole_polygons = true,
                      .issue = nothing};
  ++statistics().draws_seen;
  immediate_plan_ = Plan{};
  Cause cause = plan_draw(call, immediate_plan_);
  if (cause == Cause::count_) {
    const std::uint64_t capacity =
        immediate_bytes / static_cast<std::uint64_t>(immediate_plan_.layout->triangle_words() * 4);
    cause = ensure_room(immediate_plan_, capacity);
  }
  if (cause != Cause::count_) {
    count_passed(cause);
    return false;
  }
  begin_capture(immediate_plan_, capture::Count::known, nullptr);
  return true;
}

void Pipeline::end_immediate(GLenum mode, std::uint64_t vertices, bool tags_vary) {
  (void)tags_vary;
  const std::uint64_t capacity =
      immediate_bytes / static_cast<std::uint64_t>(immediate_plan_.layout->triangle_words() * 4);
  std::uint64_t triangles = triangles_of(mode, vertices);
  if (triangles > capacity) {
    log(LogLevel::warning,
        "glBegin..glEnd of " + std::to_string(triangles) + " triangles exceeds the " + std::to_string(capacity) +
            " that are captured at once; the rest is not drawn; use vertex arrays for meshes of this size");
    triangles = capacity;
  }
  const capture::CoarseTriangles captured = end_capture(immediate_plan_, triangles, true);
  ++statistics().captures_made;
  if (triangles == 0) {
    restore({});
    return;
  }
  submit(immediate_plan_, captured, {});
  ++statistics().draws_refined;
  statistics().coarse_triangles += triangles;
}

bool Pipeline::begin_feedback(GLenum mode) {
  const auto nothing = [] {};
  Plan plan;
  plan.for_feedback = true;
  const bool tagged = context_.ark.depth_source == DepthSource::tag;
  const DrawCall call{.mode = GL_TRIANGLES, .tags_vary = tagged, .issue = nothing};
  if (mode != GL_TRIANGLES || plan_draw(call, plan) != Cause::count_) {
    return false;
  }
  gl_.UseProgram(plan.derived->name);
  gl_.BeginTransformFeedback(mode);
  gl_.PauseTransformFeedback();
  gl_.UseProgram(context_.bindings.program);
  feedback_program_ = plan.derived;
  return true;
}

void Pipeline::frame_finished() {
  read_counts();
  kept_.frame_finished(gl_);
}

void Pipeline::release() {
  ErrorScope errors(context_);
  read_counts();
  for (auto& [key, program] : fixed_function_) {
    builder_.discard(*program);
    gl_.DeleteProgram(program->name);
  }
  fixed_function_.clear();
  kept_.release(gl_);
  capture_.release();
  centroids_.release();
  bins_.release();
  submit_.release();
  pool_.release(gl_);
  bins_ready_ = false;
}

}  // namespace glark::core
