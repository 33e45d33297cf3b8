// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Before a draw: whether it can be refined, by which program, and with room for its triangles.
#include <algorithm>
#include <string>

#include "glark/core/context.h"
#include "glark/core/input_slots.h"
#include "glark/core/pipeline.h"
#include "glark/core/refine/fixed_function/state.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/shape.h"

namespace glark::core {

bool Pipeline::ensure_pool() {
  if (pool_.built() && pool_.nested() == geomorphs(context_.options(), context_.ark())) {
    return true;
  }
  if (pool_failed_) {
    return false;
  }
  ErrorScope errors(context_.pending_error());
  pool_failed_ =
      !build_pool(pool_.built() ? pool_.max_level() : std::max(context_.options().max_level, context_.options().level));
  return !pool_failed_;
}

void Pipeline::count_passed(Cause cause) {
  if (cause != Cause::not_triangles && cause != Cause::invalid_draw) {
    hand_back_feedback();
  }
  const auto index = static_cast<std::size_t>(cause);
  ++statistics().passed_through[index];
  if (!logged_[index]) {
    logged_.set(index);
    const CauseText& text = text_of(cause);
    const bool expected = cause == Cause::not_triangles || cause == Cause::level_zero ||
                          cause == Cause::rasterizer_discard || cause == Cause::invalid_draw;
    log(expected ? LogLevel::debug : LogLevel::info,
        "draws stay as the application asked: " + std::string(text.explanation) +
            "; to change that: " + std::string(text.remedy));
  }
}

void Pipeline::count_refined(const Plan& plan) {
  ++statistics().draws_refined;
  ++plan.program->counters->draws_refined;
}

Cause Pipeline::check_state(const DrawCall& call, bool for_feedback) const {
  const Bindings& b = context_.state().bindings();
  const bool transparent = context_.options().transparent;
  if (!is_triangle_mode(call.mode)) {
    return Cause::not_triangles;
  }
  if (b.render_mode != GL_RENDER) {
    return Cause::render_mode;
  }
  if (b.transform_feedback_active && !b.transform_feedback_paused && !owns_feedback()) {
    return Cause::transform_feedback;
  }
  // Counting our own triangles would need the query that the application has open.
  if ((transparent && b.primitive_queries > 0) ||
      (!call.exact && b.primitives_written_query != 0 && b.primitives_generated_query != 0)) {
    return Cause::primitive_query;
  }
  if (transparent && b.polygon_mode != GL_FILL) {
    return Cause::polygon_mode;
  }
  // A count of refined triangles is a result, even where nothing is rasterised.
  if (b.rasterizer_discard && !owns_feedback() && !for_feedback && b.primitives_generated_query == 0) {
    return Cause::rasterizer_discard;
  }
  if (context_.capabilities().api == Capabilities::Api::core && b.vertex_array == 0) {
    return Cause::invalid_draw;
  }
  return Cause::count_;
}

refine::FragmentReads Pipeline::fragment_reads(const Program* fragment) const {
  std::string text;
  if (fragment != nullptr) {
    for (const StageSource& stage : fragment->stages) {
      text += *stage.source;
    }
  } else if (gl_.GetProgramStringARB != nullptr && gl_.IsEnabled(GL_FRAGMENT_PROGRAM_ARB) != GL_FALSE) {
    GLint length = 0;
    gl_.GetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
    text.resize(static_cast<std::size_t>(length));
    gl_.GetProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_STRING_ARB, text.data());
  } else {
    return {};
  }
  return refine::fragment_reads(text);
}

Program* Pipeline::fixed_function_program(Program* fragment) {
  const GLuint fragment_name = fragment != nullptr ? fragment->name : 0;
  if (context_.state().fixed_function_stale() || fixed_function_fragment_ != fragment_name) {
    context_.state().fixed_function_read();
    fixed_function_fragment_ = fragment_name;
    fixed_function_state_ =
        refine::read_fixed_function_state(gl_, fragment_reads(fragment), context_.capabilities().fog_distance);
  }
  std::shared_ptr<Program>& slot = fixed_function_[{fixed_function_state_, fragment_name}];
  if (slot == nullptr) {
    ErrorScope errors(context_.pending_error());
    slot = builder_.fixed_function(fixed_function_state_, fragment);
    slot->refinement_source = fixed_function_refinement_;
  }
  return slot.get();
}

Cause Pipeline::find_program(Plan& plan) {
  const Bindings& b = context_.state().bindings();
  Program* current = context_.state().programs().current().get();
  if (b.program != 0 && current == nullptr) {
    return Cause::no_program;
  }
  if (b.program == 0 && b.pipeline != 0) {
    return find_pipeline_program(plan);
  }
  if (current != nullptr && (!current->linked || current->cause == Cause::program_gone)) {
    return Cause::program_gone;
  }
  if (current != nullptr && (current->stages.empty() || current->has_stage(GL_VERTEX_SHADER))) {
    plan.program = plan.owner = current;
  } else {
    if (!context_.is_compatibility()) {
      return Cause::no_program;
    }
    if (b.vertex_program) {
      return Cause::assembly_program;
    }
    plan.owner = current;
    plan.program = fixed_function_program(current);
  }
  if (!plan.program->prepared) {
    ErrorScope errors(context_.pending_error());
    builder_.prepare(*plan.program);
    const auto& left = context_.options().left_shaders;
    plan.program->left_alone = std::find(left.begin(), left.end(), plan.program->hash) != left.end();
  }
  ++plan.program->counters->draws_seen;
  return plan.program->cause;
}

// OpenGL 4.6 compatibility, 13.4: quads may keep their last vertex as the provoking one under GL_FIRST_VERTEX_CONVENTION. They
// are then captured under the last vertex convention, whose triangles end with it.
bool Pipeline::captures_last_vertex(GLenum mode) const {
  return context_.state().bindings().provoking_vertex == GL_FIRST_VERTEX_CONVENTION &&
         !context_.capabilities().quads_follow_convention && (mode == GL_QUADS || mode == GL_QUAD_STRIP);
}

DerivedKey Pipeline::key_of(GLenum mode, bool tagged, bool placed) const {
  DerivedKey key;
  key.refinement = context_.options().transparent ? context_.options().refinement : context_.ark().refinement;
  const bool first =
      context_.state().bindings().provoking_vertex == GL_FIRST_VERTEX_CONVENTION && !captures_last_vertex(mode);
  key.provoking_corner = first ? 0 : 2;
  key.flat_colors = context_.is_compatibility() && context_.state().bindings().shade_model == GL_FLAT;
  key.clamp_colors = context_.is_compatibility() && context_.state().bindings().clamp_vertex_color;
  key.tagged = tagged;
  key.welded = context_.options().transparent ? context_.options().weld : context_.ark().weld;
  key.placed = placed;
  add_shape(context_, key);
  return key;
}

Cause Pipeline::plan_draw(const DrawCall& call, Plan& plan) {
  context_.state().refresh();
  if (const Cause cause = check_state(call, plan.for_feedback); cause != Cause::count_) {
    return cause;
  }
  const std::shared_ptr<Program> current = context_.state().programs().current();
  const std::unique_lock lock =
      current != nullptr ? std::unique_lock(current->mutex) : std::unique_lock<std::recursive_mutex>();
  if (const Cause cause = find_program(plan); cause != Cause::count_) {
    return cause;
  }
  if (leaves_draws()) {
    if (const Cause cause = exemption(*plan.program, call.triangles); cause != Cause::count_) {
      return cause;
    }
  }
  read_subroutines(plan);
  plan_depth(call, plan);
  plan.last_vertex_convention = captures_last_vertex(call.mode);
  if (splits_at_centroid(call, plan)) {
    plan.polygons = decomposition_for(call.mode, plan.last_vertex_convention);
    if (call.polygon_sides != nullptr) {
      plan.polygon_sides = *call.polygon_sides;
    }
  }
  const bool reshapes = displaces(context_) || plan.polygons ||
                        (plan.for_feedback && splits_polygons(context_.options(), context_.ark()));
  if (!plan.adaptive && plan.level == 0 && plan.program->refinement_source.empty() && !owns_feedback() && !reshapes) {
    return Cause::level_zero;
  }
  if (!ensure_pool()) {
    return Cause::out_of_memory;
  }
  // What is split has nothing that depends on the provoking corner, and may be captured among triangles.
  plan.morphing = plan.adaptive && geomorphs(context_.options(), context_.ark());
  plan.placed = plan.adaptive || plan.level > static_cast<unsigned>(pattern::deepest_uniform);
  return find_derived(call, plan);
}

std::shared_ptr<DerivedProgram> Pipeline::derived_program(const Plan& plan, const DerivedKey& key) {
  const auto found = plan.program->derived.find(key);
  if (found != plan.program->derived.end()) {
    return found->second;
  }
  ErrorScope errors(context_.pending_error());
  const capture::FeedbackAside aside(gl_, capture_, context_.state().bindings());
  std::shared_ptr<DerivedProgram> derived = builder_.derive(*plan.program, plan.owner, key);
  context_.state().programs().mirror_from_now_on();
  return derived;
}

Cause Pipeline::find_derived(const DrawCall& call, Plan& plan) {
  const bool tagged = plan.adaptive && !plan.measured;
  DerivedKey key = key_of(plan.polygons ? GL_TRIANGLES : call.mode, tagged, plan.placed);
  key.morphing = plan.morphing;
  key.turns = key.welded && plan.measured && measure().degrees > 0;
  key.border = key.welded && key.displaced;
  plan.derived = derived_program(plan, key);
  plan_weld(plan, key, call.triangles);
  if (plan.derived == nullptr) {
    return Cause::program_not_derived;
  }
  if (owns_feedback() && !context_.state().bindings().transform_feedback_paused && plan.derived != feedback_program_) {
    return Cause::transform_feedback;
  }
  if (plan.derived->stored() && plan.pipeline != nullptr) {
    return Cause::too_many_attributes;  // other programs of the pipeline may need the storage binding
  }
  plan.layout = &plan.derived->layout;
  if (plan.measured) {
    if (const Cause cause = plan_measure(plan); cause != Cause::count_) {
      return cause;
    }
  }
  const CaptureProgram& capture_program = capture_program_for(plan.derived);
  plan.capture_program = capture_program.name;
  plan.inputs = &capture_program.inputs;
  return plan.capture_program == 0 ? Cause::program_not_derived : Cause::count_;
}

const Pipeline::CaptureProgram& Pipeline::capture_program_for(const std::shared_ptr<DerivedProgram>& derived) {
  const auto found = capture_programs_.find(derived);
  if (found != capture_programs_.end()) {
    return found->second;
  }
  std::erase_if(capture_programs_, [](const auto& entry) { return entry.first.expired(); });
  ErrorScope errors(context_.pending_error());
  const capture::FeedbackAside aside(gl_, capture_, context_.state().bindings());
  const GLuint tag_attribute = context_.ark().tag_attribute;
  CaptureProgram program{capture_.program_for(derived->layout, tag_attribute),
                         input_slots(derived->layout, tag_attribute)};
  return capture_programs_.emplace(derived, std::move(program)).first->second;
}

bool Pipeline::ensure_bins(const Plan& plan, std::uint32_t triangles) {
  const capture::FeedbackAside aside(gl_, capture_, context_.state().bindings());
  bins_ready_ = bins_ready_ || bins_.prepare(pool_);
  ordered_.reserve(*plan.layout, triangles);  // without it, all goes through the bins
  return bins_ready_ && bins_.reserve(*plan.layout, triangles, plan.deepest) &&
         (!plan.measured || measure_.reserve(triangles)) &&
         (!plan.derived->numbered || submit_.number(bins_.capacity()));
}

bool Pipeline::has_adaptive_room(const Plan& plan, std::uint64_t triangles) const {
  const auto count = static_cast<std::uint32_t>(triangles);
  return bins_ready_ && ordered_.has_room(*plan.layout, count) && bins_.has_room(*plan.layout, count, plan.deepest) &&
         (!plan.measured || measure_.has_room(count)) &&
         (!plan.derived->numbered || submit_.has_numbers(bins_.capacity()));
}

Cause Pipeline::ensure_room(const Plan& plan, std::uint64_t triangles) {
  if (!capture_.can_reserve(*plan.layout, triangles)) {
    return Cause::out_of_memory;
  }
  const auto count = static_cast<std::uint32_t>(triangles);
  if (capture_.has_room(*plan.layout, triangles) && (!plan.welded || weld_.has_room(*plan.layout, count)) &&
      (!plan.adaptive || has_adaptive_room(plan, triangles))) {
    return Cause::count_;
  }
  ErrorScope errors(context_.pending_error());
  if (!capture_.reserve(*plan.layout, triangles) || (plan.welded && !weld_.reserve(*plan.layout, count))) {
    return Cause::out_of_memory;
  }
  if (plan.adaptive && !ensure_bins(plan, count)) {
    return Cause::out_of_memory;
  }
  return Cause::count_;
}

void Pipeline::copy_stale_uniforms(const Plan& plan) {
  if (plan.owner == nullptr) {
    return;
  }
  const std::lock_guard lock(plan.owner->mutex);
  if (plan.owner->uniforms_stale) {
    ErrorScope errors(context_.pending_error());
    for (const UniformMirror& mirror : plan.owner->mirrors) {
      refine::copy_uniform_values(gl_, plan.owner->name, *mirror.derived);
    }
    plan.owner->uniforms_stale = false;
  }
}

std::shared_ptr<DerivedProgram> Pipeline::derived_for(Program& program, Program* owner) {
  const std::lock_guard lock(program.mutex);
  const Quiet quiet = context_.state().quiet();
  ErrorScope errors(context_.pending_error());
  context_.state().refresh();
  if (!program.prepared) {
    builder_.prepare(program);
  }
  if (program.cause != Cause::count_) {
    program.refinement_log = std::string(text_of(program.cause).explanation);
    return nullptr;
  }
  context_.state().programs().mirror_from_now_on();
  const bool tagged = !context_.options().transparent && context_.ark().depth_source == DepthSource::tag;
  const bool placed = tagged || can_measure(program);
  DerivedKey key = key_of(GL_TRIANGLES, tagged, placed);
  key.morphing = placed && geomorphs(context_.options(), context_.ark());
  return builder_.derive(program, owner, key);
}

Program* Pipeline::program_for_refinement(GLuint name) {
  if (name == 0) {
    return context_.is_compatibility() ? fixed_function_program(nullptr) : nullptr;
  }
  const std::lock_guard lock(context_.share().mutex);
  const auto found = context_.share().programs.find(name);
  return found != context_.share().programs.end() ? found->second.get() : nullptr;
}

void Pipeline::set_fixed_function_refinement(std::string source) {
  fixed_function_refinement_ = std::move(source);
  for (auto& [key, program] : fixed_function_) {
    discard(*program);
    program->refinement_source = fixed_function_refinement_;
  }
}

void Pipeline::tag_attribute_changed() {
  for (auto& [key, program] : fixed_function_) {
    discard(*program);
  }
  std::vector<std::shared_ptr<Program>> programs;
  {
    const std::lock_guard lock(context_.share().mutex);
    for (auto& [name, program] : context_.share().programs) {
      programs.push_back(program);
    }
  }
  for (const std::shared_ptr<Program>& program : programs) {
    discard(*program);
  }
}

void Pipeline::discard(Program& program) {
  context_.share().program_epoch.fetch_add(1, std::memory_order_relaxed);
  builder_.discard(program);
}

// The fragment program lives on where another context shares it: what mirrors its uniforms must be known to be gone.
void Pipeline::discard_fixed_function(GLuint fragment, Program& program) {
  if (const std::shared_ptr<Program> owner = context_.state().programs().find(fragment)) {
    const std::lock_guard lock(owner->mutex);
    std::erase_if(owner->mirrors, [&](const UniformMirror& mirror) {
      return std::any_of(program.derived.begin(), program.derived.end(),
                         [&](const auto& entry) { return entry.second.get() == mirror.derived; });
    });
  }
  builder_.discard(program);
  gl_.DeleteProgram(program.name);
}

void Pipeline::forget_program(GLuint name) {
  context_.share().program_epoch.fetch_add(1, std::memory_order_relaxed);
  for (auto entry = fixed_function_.begin(); entry != fixed_function_.end();) {
    if (entry->first.second == name && name != 0) {
      discard_fixed_function(name, *entry->second);
      entry = fixed_function_.erase(entry);
    } else {
      ++entry;
    }
  }
}

}  // namespace glark::core
