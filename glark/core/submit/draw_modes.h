// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sets the modes of GL that a refined draw needs, and resets them to the application's.
#pragma once

#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/core/state/environment.h"
#include "glark/core/submit/mode_changes.h"

namespace glark::submit {

class DrawModes {
 public:
  explicit DrawModes(const core::Environment& environment) : env_(environment) {}

  void set(const ModeChanges& changes, const refine::FixedFunctionState& state);
  void reset(const ModeChanges& changes, const refine::FixedFunctionState& state);

 private:
  void raise_edge_flag();
  bool draws_wireframe() const { return env_.options.wireframe && env_.gl.PolygonMode != nullptr; }
  void reset_polygon_mode() const;
  void set_point_size(bool by_program) const;

  const core::Environment& env_;
  bool edge_flag_raised_ = false;
};

}  // namespace glark::submit
