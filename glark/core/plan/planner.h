// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Turns a draw call and the tracked state into a plan, or into the cause why the draw stays unrefined. The decisions
// are pure functions in the other files of this folder. The planner gathers their inputs, and the programs of the plan.
#pragma once

#include <memory>

#include "glark/core/meshes/mesh_watch.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/plan/feedback_in_use.h"
#include "glark/core/plan/polygons/polygon_capture.h"
#include "glark/core/programs/draw_programs.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class Planner {
 public:
  // Stages that a plan depends on.
  struct Parts {
    pattern::PoolInUse& pool;
    capture::DrawCapture& capture;
    DrawPrograms& programs;
    weld::WeldStage& weld;
    const FeedbackInUse& feedback;
    MeshWatch& meshes;
  };
  Planner(const Environment& environment, const Parts& parts);

  enum class Purpose { draw, feedback };  // feedback: what will be drawn is not known yet
  Decision plan(const DrawCall& call, Purpose purpose = Purpose::draw);
  // Returns whether the user's rules exempt a draw whose other state was planned before.
  bool exempts(const Program& program, std::uint64_t triangles) const {
    const std::lock_guard lock(program.mutex);
    return exempt(program, triangles).has_value();
  }
  // A draw whose plan would be the same as before. Notes it, and returns why it stays unrefined now: another pass over
  // its mesh does.
  std::optional<Cause> judge_repeated(const DrawCall& call, const Program& program) const;
  // Returns whether plans for this program depend on other passes over the mesh by more than judge_repeated() tells:
  // its stage reads no normals of its own.
  bool takes_normals_of_other_passes(const Program& program) const;
  // Why a draw by glBegin and glEnd stays unrefined although its plan was fine before its triangles were counted.
  std::optional<Cause> cause_when_counted(const DrawPlan& plan, std::uint64_t triangles) const;

  // The derived program for the current state, for GL_REFINEMENT_STATUS_ARK. Null if it cannot be built.
  std::shared_ptr<DerivedProgram> derive_for_status(Program& program, Program* owner);

 private:
  std::optional<Cause> decide(const DrawCall& call, Purpose purpose, DrawPlan& plan);
  std::optional<Cause> find_program(const DrawCall& call, DrawPlan& plan);
  std::optional<Cause> find_pipeline_programs(DrawPlan& plan);
  // Returns the cause if the user's rules exempt such a draw. `triangles`: 0 before they are counted.
  std::optional<Cause> exempt(const Program& program, std::uint64_t triangles) const;
  std::optional<Cause> choose_wanted(DrawPlan& plan) const;
  std::uint32_t instanced_inputs_of(const DrawCall& call, const Program& program) const;
  // Tells each note once for each program.
  void choose_depths(const DrawCall& call, DrawPlan& plan) const;
  bool changes_nothing(const DrawPlan& plan, Purpose purpose) const;
  std::optional<Cause> spend_budget(const DrawCall& call, DrawPlan& plan, Refinement chosen) const;
  std::optional<Cause> find_derived(const DrawCall& call, DrawPlan& plan);
  std::optional<Cause> find_capture(const DrawCall& call, const DerivedKey& key, const MeshWatch::ChosenNormal& normal,
                                    DrawPlan& plan);
  void choose_weld(DrawPlan& plan, DerivedKey& key, std::uint64_t triangles);
  std::optional<Cause> find_screen_program(DrawPlan& plan, const DerivedKey& key);
  bool can_measure(const Program& program, const PipelineObject* pipeline) const;
  bool smooth() const;
  void decide_again(const DrawCall& call, Purpose purpose, Decision& decision);
  std::shared_ptr<DerivedProgram> derived(const DrawPlan& plan, const DerivedKey& key);

  const Environment& env_;
  Parts parts_;
  PolygonCapture polygons_;
};

}  // namespace glark::core
