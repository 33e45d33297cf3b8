// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a refined draw has to give, from what the same draw gives unrefined.
#pragma once

#include <functional>
#include <string>

#include "conformance/reference/pattern.h"
#include "conformance/support/capture.h"

namespace glark::conformance {

// The weights of captured vertices; the case ends as failed where they are none (11.R.5).
std::vector<reference::Weights> weights_of(Test& t, const std::vector<CapturedVertex>& vertices);
// By coarse triangle, where each has its own number; with `count` entries.
std::vector<std::vector<reference::Weights>> patterns_of(Test& t, const std::vector<CapturedVertex>& vertices,
                                                         std::size_t count);
// The depths of the edges of each coarse triangle of a mesh whose triangles are numbered.
std::vector<reference::Depths> depths_of(Test& t, std::size_t count, const std::function<void()>& draw);

std::string text_of(const reference::Depths& depths);

// Makes attribute at_tag that of the depth tag: a program that has it as an input says which tag each vertex had.
void use_readable_tags();

struct DrawVertex {
  Vec4 position;
  Vec4 colour;
  float tag;
  float instance;  // gl_InstanceID + 16 * an attribute at at_extra
};

// Captures DrawVertex: of position, colour, tag (at_tag) and at_extra.
GLuint draw_program(Test& t);

struct CoarseTriangle {
  std::array<DrawVertex, 3> corners;
  reference::Depths depths;
};
// That `draw`, captured, gives the refinement of these triangles: their number, vertices bit for bit, and area.
void expect_triangles(Test& t, const std::vector<CoarseTriangle>& coarse, const std::function<void()>& draw,
                      const std::string& what);

struct Expected {
  int pool_level = 3;
  int uniform_level = -1;  // of UNIFORM_DEPTH_ARK; -1: depth tags
};

// That `refined`, with ARK as it is, gives the refinement of the coarse triangles that `coarse` gives with ARK disabled: as many
// triangles, with these vertices, bit for bit, and this area. Both are captured; the program is draw_program(), the interior the
// minimum one.
void expect_refinement(Test& t, const Expected& expected, const std::function<void()>& coarse,
                       const std::function<void()>& refined, const std::string& what);
inline void expect_refined(Test& t, const Expected& expected, const std::function<void()>& draw,
                           const std::string& what) {
  expect_refinement(t, expected, draw, draw, what);
}

}  // namespace glark::conformance
