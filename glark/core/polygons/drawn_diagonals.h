// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Along which diagonal GL cuts the quads that it draws. OpenGL 4.6 compatibility, 10.1, leaves this to the
// implementation, and quads that transform feedback captures may be cut along the other one. glark finds it out at the
// first draw of each kind: it draws one pixel of a quad whose corners have two values, and discards the fragment.
#pragma once

#include <array>
#include <optional>

#include "glark/core/polygons/decomposition.h"
#include "glark/core/programs/program_switch.h"
#include "glark/core/state/environment.h"

namespace glark::polygons {

enum class QuadSource { immediate, arrays, elements, list };

class DrawnDiagonals {
 public:
  DrawnDiagonals(const core::Environment& environment, const core::ProgramSwitch& programs)
      : env_(environment), programs_(programs) {}

  // `mode`: GL_QUADS or GL_QUAD_STRIP, filled and smoothly shaded, under the current provoking vertex convention.
  // Returns nothing if GL draws nothing at the moment (conditional rendering), or if a query would count the probe.
  std::optional<Diagonal> find(GLenum mode, QuadSource source);

 private:
  std::optional<Diagonal> probe(GLenum mode, QuadSource source);
  bool can_probe() const;
  void draw(GLuint program, GLuint result, GLenum mode, QuadSource source) const;

  const core::Environment& env_;
  const core::ProgramSwitch& programs_;
  std::array<std::optional<Diagonal>, 16> known_;  // by mode, convention and source
  GLuint program_ = 0;                             // 0 again once a diagonal was found
  bool broken_ = false;                            // the program does not compile: nothing is ever found
};

}  // namespace glark::polygons
