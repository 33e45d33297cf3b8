// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar-tagged PN triangles: the tags of GL_SCALAR_TAGGED_PN_ARK for a mesh with hard edges, and the surface on the CPU. Link to
// glark-pn.
//
//   const glark::pn::TaggedMesh tagged = glark::pn::derive_tags({positions, triangles, normals});
//   // tagged.normals, tagged.discontinuities and tagged.tags go to vertex buffers; the vertex stage reads only the normals
//   glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
//   glVertexAttribPointer(discontinuity_attribute, 4, GL_FLOAT, GL_FALSE, 0, ...);
//   glVertexAttribPointer(scalar_tag_attribute, 3, GL_FLOAT, GL_FALSE, 0, ...);
//
// Indices count from 0, triangles are counter-clockwise seen from outside. Nothing here calls GL.
//
// Source: Boubekeur 2007, ch. 8.
#ifndef GLARK_PN_H
#define GLARK_PN_H

#include <glark/error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glark::pn {

enum class Element { vertex, triangle, crease, array, option };

// What is wrong with an argument, and with which element of it.
class Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays, which are read and not kept. Vertices at equal positions are one point of the surface.
struct Mesh {
  std::span<const float> positions;             // [3 * vertices]
  std::span<const std::uint32_t> triangles;     // [3 * triangles], vertices
  std::span<const float> normals = {};          // [3 * vertices], of any length; empty: from the triangles' planes
  std::span<const std::uint32_t> creases = {};  // [2 * creases], the two ends of edges that are to be sharp
};

struct Options {
  float crease_degrees =
      40;  // 0 to 180, without normals: edges whose planes differ by more are creases; with them, normals decide
  float sharpness = 1;  // 0 or more: 0 smooth, 1 as sharp as the mesh is
  float tension = 0;    // -1 to 1, of the vertices on creases
  float bias = 0;       // -1 to 1, of the vertices on creases
  bool split = true;    // in their middle, edges that their ends would make creases
};

// What the vertices carry. The first vertices are those of the mesh, in its order and at its positions; more follow where one vertex
// had to become several, or an edge had to be split.
struct TaggedMesh {
  std::vector<float> positions;          // [3 * vertices]
  std::vector<float> normals;            // [3 * vertices], of unit length
  std::vector<float> discontinuities;    // [4 * vertices]: Delta and the number of the crease
  std::vector<float> tags;               // [3 * vertices]: sharpness, tension, bias
  std::vector<std::uint32_t> triangles;  // [3 * triangles]
  // For other attributes: a vertex lies half-way between these two of the mesh, which are the same where it is one of them.
  std::vector<std::array<std::uint32_t, 2>> sources;
  std::vector<std::uint32_t> triangle_sources;  // [triangles], of the mesh
  std::size_t crease_vertices = 0;              // points with two normals, tagged by their discontinuity
  std::size_t corners = 0;  // points where more creases meet: one vertex for each normal, and tension 1
};

// Creases are the edges that `creases` names, those where the normals of the two triangles differ by more than 1 degree at either end
// or, without normals, those of Options::crease_degrees; and edges of more than two triangles, or of two that disagree on the
// orientation. A point on a crease gets the mean of the two normals and their difference, such that sharpness 1 gives both back; one
// where creases meet keeps all its normals, its tension holds the edges together. Edges between two tagged vertices that are no
// crease are split in the middle, because the ends alone do not tell (ch. 8.2.1).
//   - An isolated vertex keeps its normal, or gets (0, 0, 1).
//   - A triangle with two equal positions is kept, and has no say in anything.
//   - A normal that is zero or not finite counts as the one that the triangles have there.
// Every number that comes out is finite.
// Errors: Error for an array of a wrong size, an index that is no vertex, a position that is not finite, a crease that is no edge, an
// option out of its range.
TaggedMesh derive_tags(const Mesh& mesh, const Options& options = {});

struct Corner {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  std::array<float, 4> discontinuity = {0, 0, 0, 1};
  std::array<float, 3> tags = {0, 0, 0};
};

struct Sample {
  std::array<double, 3> position;
  std::array<double, 3> normal;
};

// A point of the triangle at barycentric coordinates (w, u, v), the weights of corners 0, 1 and 2, as 11.R.7 of the extension has it:
// what the GPU computes, in double precision.
Sample evaluate(const std::array<Corner, 3>& corners, const std::array<double, 3>& barycentric);

}  // namespace glark::pn

#endif
