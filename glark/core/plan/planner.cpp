// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/planner.h"

#include <cstring>
#include <string>

#include "glark/core/plan/depths/budget_choice.h"
#include "glark/core/plan/depths/depth_choice.h"
#include "glark/core/plan/facets.h"
#include "glark/core/plan/inputs/instanced_inputs.h"
#include "glark/core/plan/programs/compile_choice.h"
#include "glark/core/plan/programs/derived_key.h"
#include "glark/core/plan/programs/program_choice.h"
#include "glark/core/plan/refinement_choice.h"
#include "glark/core/plan/tell_notes.h"
#include "glark/core/plan/unrefined/draw_rules.h"
#include "glark/core/plan/unrefined/exemptions.h"
#include "glark/core/plan/unrefined/state_check.h"
#include "glark/core/plan/vertex_keeping.h"
#include "glark/core/refine/attribute_locations.h"
#include "glark/core/shape.h"
#include "glark/core/state/draw_state.h"

namespace glark::core {
namespace {

double current_tag(const Environment& environment) {
  const GLuint attribute = environment.ark.tag_attribute;
  const CurrentValue* value = environment.state.arrays().current_values().find(static_cast<int>(attribute));
  if (value != nullptr && value->again == set_tag) {
    GLuint tag = 0;
    std::memcpy(&tag, value->components.data(), sizeof(tag));
    return tag;
  }
  GLfloat current[4] = {0, 0, 0, 0};
  environment.gl.GetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, current);
  return current[0];
}

KeyState key_state(const Environment& environment) {
  return {environment.options, environment.ark, environment.bindings(), environment.capabilities};
}

RefinementChoice refinement_choice(const Environment& environment, const Program& program,
                                   const refine::StageVariation& variation, Refinement wanted,
                                   int normal = own_normal) {
  RefinementFacts facts{.wanted = wanted,
                        .transparent = environment.options.transparent,
                        .stage = program.traits,
                        .variation = variation,
                        .inputs = program.input_traits};
  // Displacement adds a normal to the record of a fixed-function draw, also where lighting is off.
  facts.inputs.can_curve |= program.fixed_function && displaces(environment.options, environment.ark);
  facts.inputs.can_curve |= normal != own_normal;
  facts.made_normal = normal == made_normal;
  facts.flat_shaded = shows_facets(environment, program);
  return choose_refinement(facts);
}

}  // namespace

Planner::Planner(const Environment& environment, const Parts& parts)
    : env_(environment), parts_(parts), polygons_(environment, parts.capture, parts.programs.in_use()) {}

Decision Planner::plan(const DrawCall& call, Purpose purpose) {
  env_.state.refresh();
  const std::shared_ptr<Program> current = env_.state.programs().current();
  const auto lock = current != nullptr ? std::unique_lock(current->mutex) : std::unique_lock<std::recursive_mutex>();
  env_.compilation.begin_draw(compile_pace(env_.options, env_.ark, env_.compilation.has_shown_frame()));
  Decision decision;
  decision.cause = decide(call, purpose, decision.plan);
  if (env_.compilation.refused()) {
    decide_again(call, purpose, decision);
  }
  const bool spends = spends_on_curves(env_.options, env_.ark, decision.plan.wanted, decision.plan.depth);
  if (purpose == Purpose::draw && (smooth() || spends)) {
    const MeshWatch::Inputs inputs{decision.plan.inputs(), decision.plan.capture.lent.has_value()};
    const std::optional<Cause> verdict = parts_.meshes.judge(call, inputs, decision.cause);
    decision.cause = smooth() ? verdict : decision.cause;
  }
  if (smooth() && !decision.cause) {
    env_.compilation.set_pace(CompilePace::at_once);  // the mesh is curved in all passes
  }
  return decision;
}

// Programs of the draw are not compiled. If other passes over the mesh are curved already, they are compiled now.
void Planner::decide_again(const DrawCall& call, Purpose purpose, Decision& decision) {
  decision.cause = Cause::compiling;
  if (smooth() && parts_.meshes.is_curved(call, decision.plan.program->fields)) {
    env_.compilation.begin_draw(CompilePace::at_once);
    decision.plan = {};
    decision.cause = decide(call, purpose, decision.plan);
  }
}

// A program that calls the extension says itself what is a surface.
bool Planner::smooth() const { return env_.options.transparent && env_.options.smooth && !env_.ark.enabled; }

std::optional<Cause> Planner::decide(const DrawCall& call, Purpose purpose, DrawPlan& plan) {
  const DrawConditions conditions{.bindings = env_.bindings(),
                                  .transparent = env_.options.transparent,
                                  .core_profile = env_.capabilities.api == Capabilities::Api::core,
                                  .feedback_is_ours = parts_.feedback.ours(),
                                  .plans_feedback = purpose == Purpose::feedback};
  if (const std::optional<Cause> cause = check_state(call, conditions)) {
    return cause;
  }
  if (const std::optional<Cause> cause = find_program(call, plan)) {
    return cause;
  }
  if (const std::optional<Cause> cause = exempt(*plan.program, call.triangles)) {
    return cause;
  }
  if (const std::optional<Cause> cause = choose_wanted(plan)) {
    return cause;
  }
  parts_.programs.in_use().read_subroutines(plan.owner, plan.pipeline);
  choose_depths(call, plan);
  polygons_.choose_split(call, plan);
  if (changes_nothing(plan, purpose)) {
    return Cause::level_zero;
  }
  if (!parts_.pool.ensure()) {
    return Cause::out_of_memory;
  }
  return find_derived(call, plan);
}

std::optional<Cause> Planner::find_program(const DrawCall& call, DrawPlan& plan) {
  Program* const current = env_.state.programs().current().get();
  const ProgramChoice choice = choose_program(
      env_.bindings(), current,
      {.is_compatibility = env_.capabilities.is_compatibility(), .transparent = env_.options.transparent});
  if (choice.cause) {
    return choice.cause;
  }
  if (choice.stage == VertexStage::program_pipeline) {
    return find_pipeline_programs(plan);
  }
  plan.owner = current;
  if (choice.stage == VertexStage::assembly) {
    plan.assembly = &parts_.programs.assembly().find(current);
    plan.program = plan.assembly->program.get();
  } else {
    plan.program =
        choice.stage == VertexStage::program ? current : parts_.programs.fixed_function().find(current, call.materials);
  }
  if (plan.program == nullptr) {
    return Cause::assembly_program;
  }
  parts_.programs.derived().prepare(*plan.program);
  ++plan.program->counters->draws_seen;
  return plan.program->cause;
}

std::optional<Cause> Planner::find_pipeline_programs(DrawPlan& plan) {
  const PipelineObject& object = env_.state.programs().pipelines().object(env_.bindings().pipeline);
  if (const std::optional<Cause> cause = check_stages(object)) {
    return cause;
  }
  for (const GLuint name : object.programs) {
    const std::shared_ptr<Program> program = name != 0 ? env_.state.programs().known(name) : nullptr;
    if (name != 0 && (program == nullptr || !program->linked)) {
      return Cause::program_gone;
    }
    if (name == object.vertex()) {
      plan.program = plan.owner = program.get();
    }
  }
  plan.pipeline = &object;
  parts_.programs.derived().prepare(*plan.program);
  return plan.program->cause;
}

std::optional<Cause> Planner::exempt(const Program& program, std::uint64_t triangles) const {
  const ContextOptions& options = env_.options;
  if (!options.transparent || env_.ark.enabled || (options.left_draws == 0 && options.left_shaders.empty())) {
    return std::nullopt;
  }
  ExemptionFacts facts{.rules = options.left_draws,
                       .bindings = env_.bindings(),
                       .depth_buffer = env_.state.framebuffers().bound_has_depth(env_.gl, env_.errors),
                       .left_alone = program.left_alone,
                       .conventional = program.conventional_projection && env_.capabilities.is_compatibility(),
                       .triangles = triangles};
  if (needs_matrices(facts)) {
    facts.matrices = env_.state.fixed_function().matrices().traits(env_.gl);
  }
  return exemption(facts);
}

std::optional<Cause> Planner::cause_when_counted(const DrawPlan& plan, std::uint64_t triangles) const {
  const std::optional<Cause> cause = exempt(*plan.program, triangles);
  return !cause && smooth() && is_one_polygon(triangles) ? std::optional(Cause::no_surface) : cause;
}

// The user's rules choose the refinement of draws by their state.
std::optional<Cause> Planner::choose_wanted(DrawPlan& plan) const {
  plan.wanted = wanted_refinement(env_.options, env_.ark);
  if (!env_.options.transparent || env_.ark.enabled || env_.options.rules.empty()) {
    return std::nullopt;
  }
  const DrawRule* rule = find_rule(env_.options.rules, read_draw_state(env_, plan.program));
  // `smooth`: a flat pass needs a cause, so that its mesh stays flat.
  if (rule != nullptr && (!rule->refinement || (smooth() && !traits_of(*rule->refinement).curves_positions))) {
    return Cause::rule;
  }
  plan.wanted = rule != nullptr ? *rule->refinement : plan.wanted;
  return std::nullopt;
}

bool Planner::can_measure(const Program& program, const PipelineObject* pipeline) const {
  return core::can_measure(edge_measure(env_.options, env_.ark), program, pipeline,
                           !env_.state.programs().subroutines().choice().empty());
}

void Planner::choose_depths(const DrawCall& call, DrawPlan& plan) const {
  const FeedbackInUse& feedback = parts_.feedback;
  DepthFacts facts{.options = env_.options, .ark = env_.ark, .measurable = can_measure(*plan.program, plan.pipeline)};
  if (takes_tags(facts)) {
    const auto tag_slot = static_cast<int>(env_.ark.tag_attribute);
    facts.tags_vary = call.tags_vary || feedback.tagged() || env_.state.arrays().attribute_source(tag_slot).enabled;
    facts.current_tag = facts.tags_vary ? 0 : current_tag(env_);
  }
  // The feedback's program must also draw the triangles that the application wants coarse.
  facts.coarse = feedback.ours() && !env_.options.transparent && !env_.ark.enabled;
  plan.depth = core::choose_depths(facts);
  plan.placed = plan.depth.adaptive || plan.depth.level > static_cast<unsigned>(pattern::deepest_uniform);
}

// Returns whether the refined draw would equal the original one.
bool Planner::changes_nothing(const DrawPlan& plan, Purpose purpose) const {
  const bool may_split = purpose == Purpose::feedback && splits_polygons(env_.options, env_.ark);
  const bool reshapes = displaces(env_.options, env_.ark) || plan.polygons || may_split;
  return !plan.depth.adaptive && plan.depth.level == 0 && plan.program->refinement_source.empty() &&
         !parts_.feedback.ours() && !reshapes;
}

std::shared_ptr<DerivedProgram> Planner::derived(const DrawPlan& plan, const DerivedKey& key) {
  return parts_.programs.derived().find(*plan.program, plan.owner, key);
}

std::optional<Cause> Planner::spend_budget(const DrawCall& call, DrawPlan& plan, Refinement chosen) const {
  if (!spends_on_curves(env_.options, env_.ark, plan.wanted, plan.depth)) {
    return std::nullopt;
  }
  Framebuffers& framebuffers = env_.state.framebuffers();
  const VisibilityFacts facts{.bindings = env_.bindings(),
                              .depth_buffer = framebuffers.bound_has_depth(env_.gl, env_.errors),
                              .color_buffer = framebuffers.bound_has_colors(env_.gl, env_.errors),
                              .others_write_depth = parts_.meshes.any_wrote_depth(),
                              .mesh_writes_depth = parts_.meshes.mesh_wrote_depth(call, plan.program->fields)};
  if (!traits_of(chosen).curves_positions || is_background(facts)) {
    return Cause::budget;
  }
  plan.depth.budget = {.curves_only = true, .counted = draws_colors(facts)};
  return std::nullopt;
}

std::optional<Cause> Planner::find_derived(const DrawCall& call, DrawPlan& plan) {
  const depth::DepthPlan& depth = plan.depth;
  const bool curves = env_.options.transparent && !env_.ark.enabled && traits_of(plan.wanted).curves_positions;
  const MeshWatch::ChosenNormal normal =
      curves ? parts_.meshes.choose_normal(call, plan.program->fields) : MeshWatch::ChosenNormal{};
  const std::uint32_t instanced = instanced_inputs_of(call, *plan.program);
  const refine::StageVariation& variation = parts_.programs.derived().variation(*plan.program, instanced);
  const RefinementChoice choice = refinement_choice(env_, *plan.program, variation, plan.wanted, normal.attribute);
  plan.fallback = choice.fallback;
  if (smooth() && choice.fallback) {
    tell_notes(env_, *plan.program, {.fallback = choice.fallback, .transparent = true, .left = true});
    return Cause::no_surface;
  }
  if (const std::optional<Cause> cause = spend_budget(call, plan, choice.refinement)) {
    return cause;
  }
  // The outputs of split polygons do not depend on the provoking vertex.
  DerivedKey key = derived_key(key_state(env_), *plan.program,
                               {.refinement = choice.refinement,
                                .mode = plan.polygons ? GL_TRIANGLES : call.mode,
                                .tagged = depth.adaptive && !depth.measured,
                                .placed = plan.placed,
                                .morphing = depth.morphing});
  key.provoking_corner = plan.provoking_corner.value_or(key.provoking_corner);
  key.normal_attribute = normal.attribute;
  key.instanced = instanced;
  add_welded_words(
      key, depth.measured && (depth.measure.degrees > 0 || depth.measure.error > 0 || depth.budget.curves_only));
  plan.derived = derived(plan, key);
  choose_weld(plan, key, call.triangles);
  if (plan.derived == nullptr) {
    return Cause::program_not_derived;
  }
  tell_notes(env_, *plan.program,
             {.refinement = choice.refinement,
              .fallback = choice.fallback,
              .transparent = env_.options.transparent,
              .ignores_shader = plan.program->traits.corners_only() && !plan.program->refinement_source.empty(),
              .undisplaced = key.displaced && plan.derived->height_map < 0});
  return find_capture(call, key, normal, plan);
}

// What captures the inputs of the derived program, unless something else needs what the draw would take.
std::optional<Cause> Planner::find_capture(const DrawCall& call, const DerivedKey& key,
                                           const MeshWatch::ChosenNormal& normal, DrawPlan& plan) {
  if (smooth() && key.welded && !plan.weld.on) {
    return Cause::too_many_attributes;  // another pass over the mesh may be welded: its shape would differ
  }
  if (parts_.feedback.captures(env_.bindings()) && plan.derived != parts_.feedback.program) {
    return Cause::transform_feedback;
  }
  if (plan.derived->stored() && plan.pipeline != nullptr) {
    return Cause::too_many_attributes;  // other stages of the program pipeline may need the storage binding
  }
  plan.capture.layout = &plan.derived->layout;
  if (!parts_.feedback.ours()) {
    polygons_.follow_drawn_diagonal(call, plan);
  }
  if (const std::optional<Cause> cause = find_screen_program(plan, key)) {
    return cause;
  }
  const CapturePrograms::Entry& capture = parts_.programs.capture().find(plan.derived);
  plan.capture.program = capture.name;
  plan.capture.inputs = &capture.inputs;
  if (normal.lent) {
    plan.capture.lent = {*normal.lent, static_cast<GLuint>(normal.attribute)};
  }
  plan.keeps_vertices = keeps_vertices(plan, env_.options, parts_.feedback.captures(env_.bindings()));
  return capture.name == 0 ? std::optional(Cause::program_not_derived) : std::nullopt;
}

// An attribute with a divisor is the same at all corners of a triangle. That may make a stage sound.
std::uint32_t Planner::instanced_inputs_of(const DrawCall& call, const Program& program) const {
  if (!env_.options.transparent || !call.from_arrays || program.traits.variation.is_affine()) {
    return 0;
  }
  return instanced_inputs(program.fields, [&](int location) {
    const AttributeSource& source = env_.state.arrays().attribute_source(location);
    return source.enabled && source.divisor != 0;
  });
}

// A draw stays unwelded if its tables would be too large, or if its record with welded words would have to be stored
// and cannot be. It is still refined.
void Planner::choose_weld(DrawPlan& plan, DerivedKey& key, std::uint64_t triangles) {
  if (plan.derived == nullptr || !key.welded) {
    return;
  }
  plan.weld.edges_later = plan.polygons.has_value();
  plan.weld.makes_normals = key.normal_attribute == made_normal;
  plan.weld.crease = crease_of(env_.options);
  const auto can_hold = [&] { return parts_.weld.can_hold(plan.weld, plan.derived->layout, triangles); };
  bool fits = can_hold();
  const auto has_no_place = [&] { return !fits || (plan.derived->stored() && plan.pipeline != nullptr); };
  if (plan.derived->layout.displaced() && has_no_place()) {
    key.border = false;
    plan.derived = derived(plan, key);
    if (plan.derived == nullptr) {
      return;
    }
    fits = can_hold();
  }
  if (plan.derived->layout.joins_edges() && has_no_place()) {
    key.welded = false;
    key.turns = key.turns && fits;
    plan.derived = derived(plan, key);
    plan.weld.on = plan.derived != nullptr && plan.derived->layout.joins_edges();
    return;
  }
  const capture::Layout& layout = plan.derived->layout;
  plan.weld.on = fits && (layout.joins_edges() ||
                          (layout.tagged && capture::find_role(layout.fields, capture::Role::position) != nullptr));
}

// `key`: of the derived program. Programs that give several points of a triangle refine their inputs as it does.
std::optional<Cause> Planner::find_screen_program(DrawPlan& plan, const DerivedKey& key) {
  const EdgeMeasure& wanted = plan.depth.measure;
  if (!plan.depth.measured) {
    return std::nullopt;
  }
  if (wanted.degrees > 0) {
    plan.depth.normal_offset = capture::normal_offset(plan.capture.layout->fields);
  }
  if (measures_screen(wanted, *plan.program, plan.pipeline)) {
    DerivedKey at_points = key;
    at_points.at_points = true;
    at_points.morphing = false;
    plan.corners = derived(plan, wanted.error > 0 ? at_points : DerivedKey{.at_corner = true});
    if (plan.corners == nullptr) {
      return Cause::program_not_derived;
    }
    plan.depth.screen = {.name = plan.corners->name};
    if (wanted.error > 0) {
      plan.depth.screen = {.name = plan.corners->name,
                           .points = has_cubic_edges(*plan.program, *plan.derived) ? depth::points_of_cubics
                                                                                   : depth::points_of_any_curve,
                           .lattice = refine::lattice_location,
                           .first_chunk = refine::first_chunk_location,
                           .first_word = plan.corners->first_word,
                           .records_binding = refine::records_binding};
    }
  }
  return std::nullopt;
}

std::shared_ptr<DerivedProgram> Planner::derive_for_status(Program& program, Program* owner) {
  const std::lock_guard lock(program.mutex);
  const Quiet quiet = env_.state.quiet();
  ErrorScope errors(env_.errors);
  env_.compilation.begin_draw(CompilePace::at_once);
  parts_.programs.derived().prepare(program);
  if (program.cause) {
    program.refinement_log = std::string(text_of(*program.cause).explanation);
    return nullptr;
  }
  const bool tagged = !env_.options.transparent && env_.ark.depth_source == DepthSource::tag;
  const bool placed = tagged || can_measure(program, nullptr);
  const Refinement wanted = wanted_refinement(env_.options, env_.ark);
  return parts_.programs.derived().find(
      program, owner,
      derived_key(key_state(env_), program,
                  {.refinement = refinement_choice(env_, program, program.traits.variation, wanted).refinement,
                   .mode = GL_TRIANGLES,
                   .tagged = tagged,
                   .placed = placed,
                   .morphing = placed && geomorphs(env_.options, env_.ark)}));
}

}  // namespace glark::core
