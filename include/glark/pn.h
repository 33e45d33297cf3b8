// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar-tagged PN triangles: the tags of GL_SCALAR_TAGGED_PN_ARK for a mesh with hard edges, and the surface on the
// CPU.
// Link to glark-pn.
//
//   const glark::pn::TaggedMesh tagged = glark::pn::derive_tags({positions, triangles, normals});
//   // tagged.normals, tagged.discontinuities and tagged.tags go to vertex buffers
//   // the vertex stage reads only the normals
//   glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
//   glVertexAttribPointer(discontinuity_attribute, 4, GL_FLOAT, GL_FALSE, 0, ...);
//   glVertexAttribPointer(scalar_tag_attribute, 3, GL_FLOAT, GL_FALSE, 0, ...);
//
// Indices count from 0. Triangles are counter-clockwise seen from outside. The library makes no GL calls.
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

// An error in an argument, and the element that has it.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays; they are read only during the call. Vertices at equal positions are one point of the
// surface.
struct Mesh {
  std::span<const float> positions;          // [3 * vertices]
  std::span<const std::uint32_t> triangles;  // [3 * triangles], vertices
  std::span<const float> normals = {};  // [3 * vertices], of any length; empty: the normals of the triangles' planes
  std::span<const std::uint32_t> creases = {};  // [2 * creases], the two ends of each sharp edge
};

struct Options {
  float crease_degrees = 40;  // 0 to 180; only without normals: edges whose planes differ by more are creases
  float sharpness = 1;        // 0 or more: 0 is smooth, 1 as sharp as the mesh
  float tension = 0;          // -1 to 1, for the vertices on creases
  float bias = 0;             // -1 to 1, for the vertices on creases
  bool split = true;          // divides smooth edges whose ends would make them creases
};

// The attributes of the vertices. The first vertices are those of the mesh, in the same order and at the same
// positions. More vertices follow where a vertex was copied or an edge was split.
struct TaggedMesh {
  std::vector<float> positions;          // [3 * vertices]
  std::vector<float> normals;            // [3 * vertices], of unit length
  std::vector<float> discontinuities;    // [4 * vertices]: Delta and the number of the crease
  std::vector<float> tags;               // [3 * vertices]: sharpness, tension, bias
  std::vector<std::uint32_t> triangles;  // [3 * triangles]
  // For other attributes: each vertex lies half-way between these two vertices of the mesh, which may be the same.
  std::vector<std::array<std::uint32_t, 2>> sources;
  std::vector<std::uint32_t> triangle_sources;  // [triangles], the original triangle in the mesh
  std::size_t crease_vertices = 0;              // points with two normals, tagged by their discontinuity
  std::size_t corners = 0;  // points where several creases meet: one vertex for each normal, and tension 1
};

// These edges are creases:
// - the edges in `creases`;
// - edges where the normals of the two triangles differ by more than 1 degree at either end;
// - without normals, edges whose planes differ by more than Options::crease_degrees;
// - edges of more than two triangles, or of two triangles with different orientations.
//
// A point on one crease gets the mean of its two normals, and their difference. So sharpness 1 restores both normals. A
// point where creases meet keeps all its normals, and its tension holds the edges together. The tags at the ends of an
// edge cannot tell that the edge is smooth. So a smooth edge between two tagged vertices is split in the middle (ch.
// 8.2.1).
//
// Special input:
// - An isolated vertex keeps its normal, or gets (0, 0, 1).
// - A triangle with two equal positions is kept, but otherwise ignored.
// - The mean normal of the triangles replaces a normal that is zero or not finite.
//
// All results are finite.
// Errors: Error for an array of the wrong size, an index beyond the vertices, a position that is not finite, a crease
// that is no edge, or an option out of its range.
GLARK_EXPORT TaggedMesh derive_tags(const Mesh& mesh, const Options& options = {});

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

// Evaluates the triangle at barycentric coordinates (w, u, v), the weights of corners 0, 1 and 2. This is the
// computation of the GPU (11.R.7 of the extension), in double precision.
GLARK_EXPORT Sample evaluate(const std::array<Corner, 3>& corners, const std::array<double, 3>& barycentric);

}  // namespace glark::pn

#endif
