// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The expected result of a refined draw, from the unrefined result of the same draw.
#pragma once

#include <functional>
#include <string>

#include "conformance/reference/pattern.h"
#include "conformance/support/capture.h"

namespace glark::conformance {

// The weights of captured vertices. The case fails and ends if they are no weights (11.R.5).
std::vector<reference::Weights> weights_of(Test& t, const std::vector<CapturedVertex>& vertices);
// Sorts weights by coarse triangle. Each triangle has a number below `count`.
std::vector<std::vector<reference::Weights>> patterns_of(Test& t, const std::vector<CapturedVertex>& vertices,
                                                         std::size_t count);
// The edge depths of each coarse triangle of a mesh with numbered triangles.
std::vector<reference::Depths> depths_of(Test& t, std::size_t count, const std::function<void()>& draw);

std::string text_of(const reference::Depths& depths);

// Makes at_tag the attribute of the depth tag, so that a program can read each vertex's tag.
void use_readable_tags();

struct DrawVertex {
  Vec4 position;
  Vec4 colour;
  float tag;
  float instance;  // gl_InstanceID + 16 * an attribute at at_extra
};

// A program that writes DrawVertex. Its inputs are position, colour, at_tag and at_extra.
GLuint draw_program(Test& t);

struct CoarseTriangle {
  std::array<DrawVertex, 3> corners;
  reference::Depths depths;
};
// Captures `draw` and expects the refinement of these triangles: their number, their vertices by bits, and their area.
void expect_triangles(Test& t, const std::vector<CoarseTriangle>& coarse, const std::function<void()>& draw,
                      const std::string& what);

struct Expected {
  int pool_level = 3;
  int uniform_level = -1;  // of UNIFORM_DEPTH_ARK; -1: depth tags
};

// Captures `coarse` with ARK disabled and `refined` with ARK as it is. Expects the latter to be the refinement of the
// former: the number of triangles, their vertices by bits, and the area. The program is draw_program(), the interior
// the minimum one.
void expect_refinement(Test& t, const Expected& expected, const std::function<void()>& coarse,
                       const std::function<void()>& refined, const std::string& what);
inline void expect_refined(Test& t, const Expected& expected, const std::function<void()>& draw,
                           const std::string& what) {
  expect_refinement(t, expected, draw, draw, what);
}

}  // namespace glark::conformance
