// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What does not change is refined once. The vertex inputs of a kept draw are evaluated at its refined vertices, by one
// transform feedback. From then on the application's own program, or its fixed function, draws them as a static mesh:
// no derived program, no instances, nothing evaluated again.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "glark/core/capture/capture.h"
#include "glark/core/evaluate/evaluation_programs.h"
#include "glark/core/evaluate/grid_indices.h"
#include "glark/core/evaluate/piece_batches.h"
#include "glark/core/evaluate/piece_pattern.h"
#include "glark/core/evaluate/vertex_format.h"
#include "glark/core/keep/kept_draws.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/programs/program_switch.h"
#include "glark/core/submit/submit.h"

namespace glark::evaluate {

class Evaluation {
 public:
  struct Parts {
    const pattern::PoolInUse& pool;
    capture::CaptureStage& capture;
    core::KeptDraws& kept;
    const core::ProgramSwitch& programs;
  };
  Evaluation(const core::Environment& environment, const Parts& parts)
      : env_(environment), parts_(parts), programs_(environment), points_(environment.gl) {}

  // Returns the refined vertices of the draw, and makes them once the draw has repeated often enough. Null: they are not
  // kept.
  const core::RefinedVertices* find(const core::DrawPlan& plan, const core::KeptDraw& kept);
  void release();

 private:
  // Nothing: something that the vertices depend on may change unseen.
  std::optional<core::RefinedVerticesKey> key_of(const core::DrawPlan& plan, const core::DrawCache::Entry& entry) const;
  bool find_heights(core::HeightMap& heights) const;
  bool may_evaluate() const;
  bool make(const core::DrawPlan& plan, core::DrawCache::Entry& entry);
  struct Mesh {
    VertexFormat format;
    GLuint indices = 0;
    std::uint64_t index_count = 0;
  };
  bool make_grids(const core::DrawPlan& plan, core::DrawCache::Entry& entry, Mesh& mesh);
  bool make_pieces(const core::DrawPlan& plan, core::DrawCache::Entry& entry, Mesh& mesh);
  void set_uniforms(const core::DrawPlan& plan, const EvaluationProgram& program) const;
  bool evaluate(const core::DrawPlan& plan, const core::DrawCache::Entry& entry,
                std::span<const submit::PointDraw> draws);

  const core::Environment& env_;
  Parts parts_;
  EvaluationPrograms programs_;
  GridIndices grids_;
  PiecePatterns patterns_;
  submit::SubmitStage points_;
};

}  // namespace glark::evaluate
