// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The GPU passes between capture and submission. They split and weld triangles, sort them into instances, and make the
// room that a draw needs.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/depth/instance_sorter.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/polygons/centroid_split.h"
#include "glark/core/polygons/quad_cut.h"
#include "glark/core/report/cause.h"
#include "glark/core/state/environment.h"
#include "glark/core/weld/draw_weld.h"

namespace glark::core {

// The triangles that will be drawn: the captured ones, or those about the centroids of their polygons.
struct Records {
  capture::CoarseTriangles triangles;
  const GpuBuffer* count_command = nullptr;
  bool tags_are_edge_depths = false;
};

// How many triangles a draw has.
struct RoomOfDraw {
  std::uint64_t captured = 0;  // at most
  std::uint64_t refined = 0;   // that the passes take at once
  bool exact = false;          // `refined` is their number, no bound
};

class TrianglePasses {
 public:
  TrianglePasses(const Environment& environment, const pattern::PoolInUse& pool, capture::DrawCapture& capture);

  weld::WeldStage& weld_stage() { return weld_.stage(); }
  depth::InstanceSorter& sorter() { return sorter_; }

  // Makes room for a draw. Returns the cause if there is no memory, or if passes are not compiled yet.
  std::optional<Cause> ensure_room(const DrawPlan& plan, const RoomOfDraw& room);
  // Compiles what a later frame will need. Returns whether everything is compiled, or will
  // be compiled at once.
  bool compile(const DrawPlan& plan, std::uint64_t triangles, bool exact);
  // Cuts captured quads if the plan asks for it, and welds the captured triangles. Returns whether storage buffer bindings
  // have changed.
  bool weld(const DrawPlan& plan, const capture::CoarseTriangles& captured);
  // Splits polygons if the plan asks for it, and welds the edges of the result.
  Records split(const DrawPlan& plan, const capture::CoarseTriangles& captured);
  void release();

 private:
  bool has_room(const DrawPlan& plan, std::uint32_t triangles, bool exact) const;
  bool reserve(const DrawPlan& plan, std::uint32_t triangles, bool exact);
  bool cut(const DrawPlan& plan, const capture::CoarseTriangles& captured);
  bool ensure_split_room(const DrawPlan& plan, const polygons::SplitRequest& request);

  const Environment& env_;
  const pattern::PoolInUse& pool_;
  capture::DrawCapture& capture_;
  polygons::CentroidSplit centroids_;
  polygons::QuadCut cuts_;
  weld::DrawWeld weld_;
  depth::InstanceSorter sorter_;
  bool split_failed_ = false;
};

}  // namespace glark::core
