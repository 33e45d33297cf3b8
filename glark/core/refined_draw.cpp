// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refined_draw.h"

#include <algorithm>
#include <string>

#include "glark/core/objects/application_message.h"
#include "glark/core/passes/compile_ahead.h"
#include "glark/core/state/draw_state.h"

namespace glark::core {
namespace {

KeyFacts key_facts(const DrawPlan& plan, const pattern::PoolInUse& pool) {
  return {plan.capture,     plan.depth,   plan.polygons.has_value(), plan.cut.has_value(), plan.weld.on,
          plan.weld.crease, pool.number()};
}

// The plan of the same draw with its coarse triangles.
DrawPlan coarse(DrawPlan plan) {
  plan.depth.level = 0;
  plan.depth.coarse = plan.depth.adaptive;
  return plan;
}

void count_fallback(std::optional<RefinementFallback> fallback) {
  if (fallback) {
    ++statistics().fallen_back[static_cast<std::size_t>(*fallback)];
  }
}

void count_refined(const DrawPlan& plan) {
  ++statistics().draws_refined;
  ++plan.program->counters->draws_refined;
  count_fallback(plan.fallback);
}

bool is_empty(const DrawCall& call, Cause cause) {
  return cause == Cause::not_triangles && is_triangle_mode(call.mode) && call.triangles == 0;
}

}  // namespace

RefinedDraw::RefinedDraw(const Environment& environment, const Parts& parts)
    : env_(environment),
      parts_(parts),
      views_(environment, parts.kept),
      repeated_(environment),
      evaluation_(environment, {parts.pool, parts.capture.stage(), parts.kept, parts.programs.in_use()}),
      immediate_(environment, parts.planner, parts.meshes, parts.passes, parts.capture),
      submission_(environment, {parts.pool, parts.programs, parts.capture.stage(), parts.feedback_in_use}) {}

void RefinedDraw::run(const DrawCall& call) {
  ++statistics().draws_seen;
  const Quiet quiet = env_.state.quiet();
  if (draw_repeated(call, quiet)) {
    return;
  }
  const ConditionLifted lifted(env_.state.conditional_rendering(), env_.gl);
  parts_.feedback.take_over(call);
  const Decision decision = parts_.planner.plan(call);
  if (decision.cause == Cause::not_triangles && parts_.feedback.refuses(call.mode)) {
    env_.errors.raise(GL_INVALID_OPERATION);
    return;
  }
  if (decision.cause == Cause::mesh_waits) {
    compile_ahead(parts_.meshes, parts_.passes, call, decision.plan, call.triangles);
  }
  if (decision.cause || call.triangles == 0) {
    draw_as_asked(call, decision.plan, decision.cause.value_or(Cause::not_triangles), quiet);
    return;
  }
  const DrawPlan& plan = decision.plan;
  if (const std::optional<Cause> cause =
          parts_.passes.ensure_room(plan, {call.triangles, call.triangles, call.exact})) {
    parts_.meshes.judge(call, {.fields = &plan.program->fields}, cause);
    draw_as_asked(call, plan, *cause, quiet);
    return;
  }
  draw_refined(call, plan, quiet);
}

void RefinedDraw::draw_refined(const DrawCall& call, const DrawPlan& plan, const Quiet& quiet) {
  const KeyFacts facts = key_facts(plan, parts_.pool);
  KeptDraw kept = parts_.kept.find(call, facts);
  views_.follow(plan, kept);
  const HalfWindow half(env_, HalfWindow::splits(env_));
  draw_left_half(half, call, quiet);
  if (draw_kept_vertices(call, plan, kept)) {
    return;
  }
  const capture::CoarseTriangles triangles = capture(call, facts, kept, quiet);
  if (triangles.count == 0) {
    submission_.restore_after_capture();
    return;
  }
  const bool welded = !kept.filled && parts_.passes.weld(plan, triangles);
  {
    Watched watched;
    watch(watched, plan, std::nullopt, triangles.count);
    refine(plan, triangles, kept, welded);
  }
  count_refined(plan);
  count_class(plan, std::nullopt, triangles.count);
  parts_.capture.count_drawn(triangles, plan.depth.adaptive ? 0 : plan.depth.level);
}

void RefinedDraw::leave(const DrawCall& call, Cause cause) {
  env_.state.refresh();
  parts_.meshes.judge(call, {}, cause);
  pass(cause);
  Watched watched;
  watch(watched, {}, cause, call.triangles);
  issue_unrefined(call, cause);
}

void RefinedDraw::draw_as_asked(const DrawCall& call, const DrawPlan& plan, Cause cause, const Quiet& quiet) {
  pass_planned(plan, cause, call.triangles);
  const ConditionApplied condition(env_.state.conditional_rendering(), env_.gl);
  Watched watched;
  watch(watched, plan, cause, call.triangles);
  quiet.interrupt();
  issue_unrefined(call, cause);
  quiet.hush();
}

// What GL refuses captures nothing, and neither does an empty draw.
void RefinedDraw::issue_unrefined(const DrawCall& call, Cause cause) const {
  if (is_empty(call, cause) || cause == Cause::invalid_draw || !parts_.feedback.watches_draws()) {
    call.issue();
    return;
  }
  parts_.feedback.hand_back_for(call.mode);
  if (!parts_.feedback.awaits()) {
    call.issue();
    return;
  }
  ErrorScope errors(env_.errors);
  call.issue();
  if (const GLenum error = errors.take(); error != GL_NO_ERROR) {
    env_.errors.raise(error);
  } else {
    parts_.feedback.hand_back();
  }
}

void RefinedDraw::pass(Cause cause) {
  const Quiet quiet = env_.state.quiet();
  pass_planned({}, cause, 0);
}

// Debug output is switched off.
void RefinedDraw::pass_planned(const DrawPlan& plan, Cause cause, std::uint64_t triangles) {
  count_fallback(plan.fallback);
  const bool audible = env_.ark.enabled && !env_.options.transparent && env_.bindings().debug_output;
  const std::string message = passed_.count(cause, audible);
  if (!message.empty()) {
    const std::string reason = plan.program != nullptr ? plan.program->refinement_log : std::string();
    const DebugOutput application{env_.gl, env_.bindings().debug_output, true};
    application.send(MessageId::passed_draw, reason.empty() ? message : message + "\n" + reason);
  }
  count_class(plan, cause, triangles);
}

// For the statistics file only.
void RefinedDraw::count_class(const DrawPlan& plan, std::optional<Cause> cause, std::uint64_t triangles) {
  if (!env_.options.read_counts) {
    return;
  }
  classes_.count(class_of(plan, cause), triangles);
}

DrawClassKey RefinedDraw::class_of(const DrawPlan& plan, std::optional<Cause> cause) const {
  DrawClassKey key{.state = read_draw_state(env_, plan.program)};
  key.verdict.cause = cause;
  key.verdict.fallback = plan.fallback;
  if (!cause) {
    key.verdict.refinement = plan.derived->refinement;
    key.verdict.measured = plan.depth.measured;
    key.verdict.level = plan.depth.adaptive ? 0 : plan.depth.level;
  }
  return key;
}

void RefinedDraw::watch(Watched& watched, const DrawPlan& plan, std::optional<Cause> cause, std::uint64_t triangles,
                        bool kept) {
  if (env_.options.live.watches_draws()) {
    watched.emplace(env_, watch_, WatchedDraw::Draw{class_of(plan, cause), kept, triangles});
  }
}

// The refined draw then fills the right half.
void RefinedDraw::draw_left_half(const HalfWindow& half, const DrawCall& call, const Quiet& quiet) const {
  if (!half.on()) {
    return;
  }
  const ConditionApplied condition(env_.state.conditional_rendering(), env_.gl);
  half.select_left();
  quiet.interrupt();
  call.issue();
  quiet.hush();
  half.select_right();
}

void RefinedDraw::frame_finished() {
  classes_.frame_finished();
  watch_.frame_finished();
}

void RefinedDraw::release() {
  evaluation_.release();
  submission_.release();
}

capture::CoarseTriangles RefinedDraw::capture(const DrawCall& call, const KeyFacts& facts, KeptDraw& kept,
                                              const Quiet& quiet) {
  if (kept.filled) {
    ++statistics().captures_reused;
    return kept.entry->triangles;
  }
  ++statistics().captures_made;
  const capture::Count count = kept.entry != nullptr ? capture::Count::checked
                               : call.exact          ? capture::Count::known
                                                     : capture::Count::by_query;
  const std::optional<capture::CoarseTriangles> captured =
      parts_.capture.run(call, facts.capture, {count, KeptDraws::target_of(kept, facts)}, quiet);
  if (!captured) {  // GL rejects the draw
    kept = {};
    return {};
  }
  KeptDraws::keep_capture(kept, call, facts, *captured);
  return *captured;
}

// Draws the kept vertices of a draw without a plan, or leaves the draw unrefined. False: the draw must be planned.
bool RefinedDraw::draw_repeated(const DrawCall& call, const Quiet& quiet) {
  if (parts_.feedback.watches_draws()) {
    return false;
  }
  const RepeatedDraws::Planned* const planned = repeated_.find(call, parts_.programs.fixed_function().last());
  if (planned == nullptr || (env_.options.transparent && parts_.planner.exempts(*planned->program, call.triangles))) {
    return false;
  }
  ProgramCounters& counters = *planned->program->counters;
  ++counters.draws_seen;
  if (const std::optional<Cause> cause = parts_.planner.judge_repeated(call, *planned->program)) {
    DrawPlan left;
    left.fallback = planned->fallback;
    draw_as_asked(call, left, *cause, quiet);
    return true;
  }
  parts_.kept.reuse(*planned->entry);
  draw_vertices(*planned->entry);
  ++counters.draws_refined;
  ++statistics().draws_refined;
  count_fallback(planned->fallback);
  return true;
}

// False: no refined vertices are kept.
bool RefinedDraw::draw_kept_vertices(const DrawCall& call, const DrawPlan& plan, const KeptDraw& kept) {
  if (evaluation_.find(plan, kept) == nullptr) {
    return false;
  }
  const std::uint32_t triangles = kept.entry->triangles.count;
  {
    Watched watched;
    watch(watched, plan, std::nullopt, triangles, true);
    draw_vertices(*kept.entry);
  }
  count_refined(plan);
  count_class(plan, std::nullopt, triangles);
  note_repeated(call, plan, kept);
  return true;
}

void RefinedDraw::draw_vertices(const DrawCache::Entry& entry) {
  const ConditionApplied condition(env_.state.conditional_rendering(), env_.gl);
  submission_.draw_vertices(entry.vertices);
  Statistics& counts = statistics();
  ++counts.captures_reused;
  ++counts.draws_of_kept_vertices;
  counts.coarse_triangles += entry.triangles.count;
  counts.refined_triangles += static_cast<std::uint64_t>(entry.vertices.index_count) / 3;
}

// The next such draw needs no plan, unless the kept vertices depend on more than RepeatedDraws compares.
void RefinedDraw::note_repeated(const DrawCall& call, const DrawPlan& plan, const KeptDraw& kept) {
  const bool depends_on_more = plan.pipeline != nullptr || plan.depth.measured || plan.derived->height_map >= 0 ||
                               plan.capture.lent || !plan.program->refinement_source.empty() ||
                               parts_.feedback.watches_draws() ||
                               parts_.planner.takes_normals_of_other_passes(*plan.program);
  if (!depends_on_more) {
    repeated_.note(call, parts_.programs.fixed_function().last(), {plan.program, kept.entry, plan.fallback},
                   *plan.capture.inputs, parts_.kept.buffers_read());
  }
}

void RefinedDraw::refine(const DrawPlan& plan, const capture::CoarseTriangles& captured, const KeptDraw& kept,
                         bool welded) {
  const bool sorted = kept.filled && plan.depth.keeps_instances();
  std::optional<Compilation::Step> first_draw;
  if (!plan.derived->drawn) {
    plan.derived->drawn = true;
    first_draw.emplace(env_.compilation, Compilation::Step::Kind::first_draw);
  }
  submission_.begin(plan, plan.depth.adaptive || captured.count_on_gpu);
  submit::RefinedTriangles refined;
  const Records records = sorted ? Records{captured} : parts_.passes.split(plan, captured);
  refined.triangles = records.triangles;
  refined.count_command = records.count_command;
  if (plan.depth.adaptive) {
    refined.instances = sort(plan, records, kept);
    refined.numbers = parts_.passes.sorter().numbers();
  }
  refined.storage_changed = welded || (!sorted && (plan.depth.adaptive || plan.polygons));
  const ConditionApplied condition(env_.state.conditional_rendering(), env_.gl);
  submission_.draw(plan, refined);
}

depth::BinnedInstances RefinedDraw::sort(const DrawPlan& plan, const Records& records, const KeptDraw& kept) {
  const bool keeps = plan.depth.keeps_instances();
  if (keeps && kept.filled) {
    statistics().refined_triangles += kept.entry->refined_triangles;
    return kept.entry->bins;
  }
  if (plan.depth.measured && kept.filled && kept.entry->view.kept()) {
    statistics().refined_triangles += kept.entry->view.refined_triangles;
    return kept.entry->view.bins;
  }
  const depth::SortRequest request{.plan = plan.depth,
                                   .layout = *plan.capture.layout,
                                   .triangles = records.triangles,
                                   .count_command = records.count_command,
                                   .tags_are_edge_depths = records.tags_are_edge_depths,
                                   .stored = plan.derived->stored()};
  depth::InstanceSorter& sorter = parts_.passes.sorter();
  const depth::BinnedInstances sorted = sorter.sort(request);
  if (keeps && kept.entry != nullptr) {
    ErrorScope errors(env_.errors);
    parts_.kept.keep_instances(*kept.entry, sorted, sorter.extent(request, sorted), records.triangles);
  } else if (KeptViews::wants(plan, kept)) {
    ErrorScope errors(env_.errors);
    views_.keep(kept, sorted, sorter.extent(request, sorted));
  }
  return sorted;
}

std::uint64_t RefinedDraw::begin_immediate(GLenum mode, MaterialSet materials, std::uint64_t least) {
  ++statistics().draws_seen;
  const Quiet quiet = env_.state.quiet();
  env_.state.conditional_rendering().lift(env_.gl);  // until end_immediate()
  const auto nothing = [] {};
  parts_.feedback.take_over({.mode = mode, .whole_polygons = true, .materials = materials, .issue = nothing});
  std::optional<Cause> cause;
  const std::uint64_t room = immediate_.begin(mode, materials, least, cause);
  if (cause) {
    env_.state.conditional_rendering().apply(env_.gl);
    parts_.feedback.hand_back_at_begin(mode);
    pass_planned(immediate_.plan(), *cause, 0);
    watch(open_, {}, cause, 0);
  }
  return room;
}

void RefinedDraw::end_unrefined(std::uint64_t triangles) {
  open_.reset();
  parts_.meshes.loose_ended(triangles);
}

void RefinedDraw::refine_in_parts(const DrawPlan& plan, const ImmediateCapture::Captured& captured, bool welded) {
  const int triangle_bytes = 4 * plan.capture.layout->triangle_words();
  capture::CoarseTriangles part = captured.triangles;
  for (std::uint32_t left = captured.triangles.count; left > 0; left -= part.count) {
    part.count = std::min(left, captured.most_at_once);
    refine(plan, part, {}, welded);
    part.offset += static_cast<GLintptr>(part.count) * triangle_bytes;
  }
}

void RefinedDraw::end_immediate(std::uint64_t triangles) {
  const Quiet quiet(env_.gl, env_.bindings().debug_output);  // while our feedback is bound, bindings are not read again
  const ConditionLifted lifted(env_.state.conditional_rendering(), env_.gl);
  ImmediateCapture::Captured captured = immediate_.end(triangles);
  ++statistics().captures_made;
  if (captured.triangles.count == 0) {
    submission_.restore_after_capture();
    return;
  }
  const bool welded = parts_.passes.weld(captured.plan, captured.triangles);
  if (captured.cause) {
    pass_planned(captured.plan, *captured.cause, captured.triangles.count);
  } else {
    count_refined(captured.plan);
    count_class(captured.plan, std::nullopt, captured.triangles.count);
  }
  const HalfWindow half(env_, !captured.cause && HalfWindow::splits(env_));
  if (half.on()) {
    half.select_left();
    refine_in_parts(coarse(captured.plan), captured, welded);
    half.select_right();
  }
  {
    Watched watched;
    watch(watched, captured.plan, captured.cause, captured.triangles.count);
    refine_in_parts(captured.plan, captured, welded);
  }
  statistics().coarse_triangles += captured.triangles.count;
}

}  // namespace glark::core
