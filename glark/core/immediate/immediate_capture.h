// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw by glBegin and glEnd: its vertices go straight into a capture. Their number is known only at the end.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/meshes/mesh_watch.h"
#include "glark/core/passes/triangle_passes.h"
#include "glark/core/plan/planner.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class ImmediateCapture {
 public:
  ImmediateCapture(const Environment& environment, Planner& planner, MeshWatch& meshes, TrianglePasses& passes,
                   capture::DrawCapture& capture)
      : env_(environment), planner_(planner), meshes_(meshes), passes_(passes), capture_(capture) {}

  // Begins a capture for at least `least` triangles and returns how many fit. 0: the draw stays unrefined, because of
  // `cause`.
  std::uint64_t begin(GLenum mode, MaterialSet materials, std::uint64_t least, std::optional<Cause>& cause);

  // The plan that the last begin() made. end() gives it away.
  const DrawPlan& plan() const { return plan_; }

  struct Captured {
    DrawPlan plan;
    capture::CoarseTriangles triangles;
    std::optional<Cause> cause;  // the triangles are drawn coarse
    // For lack of memory, the triangles are drawn in parts of this many, and not welded.
    std::uint32_t most_at_once = std::numeric_limits<std::uint32_t>::max();
  };
  // The cause of a small draw is known only when its triangles are counted. Its capture is then drawn at level 0.
  Captured end(std::uint64_t triangles);

 private:
  std::uint64_t room() const;
  bool make_room(std::uint64_t triangles);
  std::uint64_t limited(std::uint64_t triangles);

  const Environment& env_;
  Planner& planner_;
  MeshWatch& meshes_;
  TrianglePasses& passes_;
  capture::DrawCapture& capture_;
  DrawPlan plan_;
  bool exact_ = true;                              // the number of triangles is known without a query
  std::uint64_t bytes_ = std::uint64_t{16} << 20;  // size of a capture; grows when a strip or fan did not fit
};

}  // namespace glark::core
