// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The vertices on an edge, by 11.R.14. The vertex stage's outputs are polynomials. At places that are multiples of 1/32
// up to 4, their values and those of (11.R.8) are exact in single precision, so cases compare bits.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/support/surface.h"

namespace glark::conformance {

struct MorphVertex {
  Vec4 position;  // gl_Position
  Vec2 place;     // the input at at_texture
  Vec4 bend;      // bend_of(place), once executed
};
// The program's inputs are position, normal and place.
GLuint morph_program(Test& t);
Vec4 bend_of(const Vec2& place);

// One triangle with the places (0, 0), (3, 1) and (1, 4).
Mesh morph_triangle(const std::array<float, 3>& tags);
// Tags that give the edges these depths. No depth may exceed the sum of the other two.
std::array<float, 3> tags_for(const std::array<double, 3>& depths);

std::vector<MorphVertex> capture_morph(Test& t, const Mesh& mesh, GLenum mode = GL_TRIANGLES);

using PlaceAndBend = std::array<float, 6>;
std::set<PlaceAndBend> found_on_edge(const std::vector<MorphVertex>& vertices, const Vec2& from, const Vec2& to);
// The expected vertices of an edge with this depth, which is a multiple of 1/64.
std::set<PlaceAndBend> expected_on_edge(const Vec2& from, const Vec2& to, double depth);
bool expect_edge(Test& t, const std::vector<MorphVertex>& vertices, const Vec2& from, const Vec2& to, double depth,
                 const std::string& what);
// Expects the edges of the triangle with these corners.
void expect_edges(Test& t, const std::vector<MorphVertex>& vertices, const Mesh& mesh,
                  const std::array<double, 3>& depths, const std::string& what);

// Calls ARKinit, chooses depth tags, and sets GEOMORPH_ARK.
void morph_by_tags(GLuint pool_level, GLenum refinement = GL_LINEAR_INPUTS_ARK);

}  // namespace glark::conformance
