// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How this GL cuts polygons into triangles, found out once for each mode and provoking vertex convention.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/polygons/decomposition.h"
#include "glark/core/programs/program_switch.h"
#include "glark/core/state/environment.h"

namespace glark::polygons {

class Decompositions {
 public:
  Decompositions(const core::Environment& environment, capture::DrawCapture& capture,
                 const core::ProgramSwitch& programs)
      : env_(environment), capture_(capture), programs_(programs) {}

  // `convention`: of the provoking vertex, while GL captures.
  // Returns nothing if polygons cannot be recovered from the triangles, or if GL captures nothing at the moment.
  std::optional<Decomposition> find(GLenum mode, GLenum convention);

 private:
  std::vector<float> probe(GLenum mode, GLenum convention);
  bool draw_probe(GLenum mode, const capture::CapturePlan& plan, std::vector<float>& corners);

  const core::Environment& env_;
  capture::DrawCapture& capture_;
  const core::ProgramSwitch& programs_;
  using Drawing = std::pair<GLenum, GLenum>;  // mode, provoking vertex convention
  std::map<Drawing, std::optional<Decomposition>> known_;
};

}  // namespace glark::polygons
