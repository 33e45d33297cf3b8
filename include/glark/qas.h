// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Quadratic approximation of subdivision surfaces (QAS) in real time. One limit step of Loop's scheme on the CPU gives
// six points and normals of the limit surface for every triangle of a coarse mesh. A refinement shader
// (GL_ARK_adaptive_refinement) fits a quadratic patch to these six and evaluates it at the refined vertices. Link to
// glark-qas.
//
//   glark::qas::Surface surface({vertex_count, triangles});        // once: the topology
//   std::vector<glark::qas::Corner> corners(surface.corner_count());
//   glRefinementShaderSourceARK(program, 1, &source, nullptr);     // refinement_shader(inputs).c_str()
//   surface.update(positions);                                     // every frame in which the mesh moves
//   surface.write_corners(corners);                                // to a buffer, for glDrawArrays(GL_TRIANGLES, ...)
//
// Space and units are those of the positions. Indices count from 0, triangles are counter-clockwise seen from outside.
//
// All meshes are accepted. These edges are creases: edges in Mesh::creases, edges of one triangle or of more than two,
// and edges of two triangles with different orientations. So every vertex is smooth, lies on a crease of two edges, or
// is a corner that does not move.
//   - An isolated vertex is its own limit.
//   - A triangle with two equal indices is ignored, and drawn as a point.
//   - A triangle with the vertices of an earlier triangle is drawn as the earlier one. Its normals are reversed if its
//     orientation is reversed.
//   - Where the limit surface has no normal, it gets the mean normal of the coarse triangles. If the mean is zero, it
//     gets (0, 0, 1).
// All results are finite, and all normals have unit length.
//
// Source: Boubekeur 2007, ch. 9.
#ifndef GLARK_QAS_H
#define GLARK_QAS_H

#include <glark/error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace glark::qas {

enum class Element { mesh, vertex, triangle, crease, array };

// An error in an argument, and the element that has it.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays; only constructors read them.
struct Mesh {
  std::size_t vertex_count = 0;
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles], vertices
  std::span<const std::uint32_t> creases =
      {};  // [2 * creases], the ends of edges across which the surface is not smooth
};

enum class Scheme {
  loop,                // approximates the coarse mesh
  modified_butterfly,  // interpolates it; creases have the four-point rule
};

struct Options {
  Scheme scheme = Scheme::loop;
  // 0: one patch for each triangle, as in the thesis. 1: four patches, after one more step of the scheme. Four patches
  // cost about four times as much, and the error is a fifth. They are drawn one level less deep.
  unsigned splits = 0;
  unsigned threads = 0;  // the most threads; 0: as many as the machine has, 1: only the caller's
};

struct alignas(16) Vector {
  float x, y, z, w;  // w: 1 for a position, 0 for a normal
};

// The indices of six positions and normals: at corners 0, 1, 2, then in the middles of the edges 01, 12, 20.
struct Patch {
  std::array<std::uint32_t, 6> positions;
  std::array<std::uint32_t, 6> normals;
};

// A corner of a patch in the form that the vertex stage reads, and the middle of the edge to the next corner.
struct Corner {
  std::array<float, 3> position;
  std::array<float, 3> edge_position;
  std::array<float, 3> normal;
  std::array<float, 3> edge_normal;
};

// A corner of a coarse triangle in the form that the vertex stage reads, for a surface with splits 1. It consists of
// two matrices, by columns.
// points: x y z of the corner, and of the points at 1/4, 2/4 and 3/4 of the edge to the next corner. The fourth
// components of columns 0, 1 and 2 are the x y z of the inner point next to the corner. Its barycentric coordinates
// are 2/4, 1/4 and 1/4.
// normals: the normals at the same points.
struct QuarticCorner {
  std::array<std::array<float, 4>, 4> points;
  std::array<std::array<float, 4>, 4> normals;
};

// A point of a surface and its unit normal.
struct Sample {
  std::array<float, 3> position;
  std::array<float, 3> normal;
};

// The limit step. Only one thread at a time may call update(); the const functions are safe from several threads.
class GLARK_EXPORT Surface {
 public:
  // Errors: Error for an array that is not made of whole triangles or creases, an index beyond the vertices, a crease
  // that is no edge, more than 2^26 triangles, splits above 1, or more than 2^22 vertices with more than 256 for each
  // index in `triangles`.
  explicit Surface(const Mesh& mesh, const Options& options = {});
  ~Surface();
  Surface(Surface&& other) noexcept;
  Surface& operator=(Surface&& other) noexcept;

  // Moves the mesh. positions: [3 * vertex_count], x y z of every vertex; read, not kept. Allocates nothing.
  // Errors: Error for an array of another size, or a coordinate that is not finite or above 1e37. After an error,
  // nothing has changed.
  void update(std::span<const float> positions);

  // The results of update(), owned by the surface; all zero before the first update.
  std::span<const Vector> limit_positions() const;
  std::span<const Vector> limit_normals() const;
  // In the order of the triangles. With splits 1, each triangle has three patches at its corners, then the middle one.
  std::span<const Patch> patches() const;

  // Three corners for each patch.
  std::size_t corner_count() const;
  // Allocates nothing. Errors: Error if `corners` has another size than corner_count(). After an error, nothing is
  // written.
  void write_corners(std::span<Corner> corners) const;
  // [corner_count()], for attributes of the coarse vertices such as texture coordinates and depth tags. Each corner
  // lies half-way between two vertices. At a coarse vertex, the two are the same.
  std::span<const std::array<std::uint32_t, 2>> corner_vertices() const;

  // Evaluates a patch at barycentric coordinates (w, u, v) of corners 0, 1, 2, each 0 to 1, with the sum 1. The
  // computation is the same as in the refinement shader.
  // Errors: Error for a patch that does not exist, or coordinates outside the triangle.
  Sample evaluate(std::size_t patch, std::array<float, 3> barycentric) const;

  // With splits 1, one quartic can replace the four quadratic patches of each coarse triangle. It goes through the same
  // 15 points and normals. Its error is a tenth where the surface is smooth, and half near extraordinary vertices.
  // There are three corners for each coarse triangle, in the order of Mesh::triangles. Without splits there are none.
  std::size_t quartic_corner_count() const;
  // Errors: as write_corners(), for quartic_corner_count().
  void write_quartic_corners(std::span<QuarticCorner> corners) const;
  // As evaluate(), for a coarse triangle. Errors: Error also without splits.
  Sample evaluate_quartic(std::size_t triangle, std::array<float, 3> barycentric) const;

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

// Loop's limit surface itself, evaluated at any parameter. It is the reference for Surface, and a slow refinement.
// Source: Boubekeur 2007, ch. 7.5; J. Stam, Evaluation of Loop Subdivision Surfaces, 1999.
class GLARK_EXPORT LoopSurface {
 public:
  // Errors: as Surface.
  explicit LoopSurface(const Mesh& mesh);
  ~LoopSurface();
  LoopSurface(LoopSurface&& other) noexcept;
  LoopSurface& operator=(LoopSurface&& other) noexcept;

  // As Surface::update().
  void update(std::span<const float> positions);
  // Errors: as Surface::evaluate(), for a triangle.
  Sample evaluate(std::size_t triangle, std::array<float, 3> barycentric) const;
  // Evaluates all triangles at the vertices of the uniform pattern of `level`, 0 to 11: [triangles * (2^level + 1) *
  // (2^level + 2) / 2]. For i = 0 .. 2^level and j = 0 .. 2^level - i, (w, u, v) = (2^level - i - j, i, j) / 2^level.
  // Errors: Error for another size or level. After an error, nothing is written.
  void refine(unsigned level, std::span<Sample> samples, unsigned threads = 0) const;

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

// The vertex inputs that the refinement shader reads, with three or more components. The vertex stage gets position and
// normal. All inputs must be active in the vertex stage, so pairs are best: `in mat2x3 point` has the position in
// column 0 and the edge's position in column 1. A matrix takes a location, and an array, for each column.
// A depth-only pass has no normal (""). Its positions have the same bits.
struct ShaderInputs {
  std::string position = "point[0]";
  std::string edge_position = "point[1]";
  std::string normal = "normal[0]";
  std::string edge_normal = "normal[1]";
};

// Returns GLSL for glRefinementShaderSourceARK, for version 1.20 and later. Points on an edge are computed only from
// the three points of the edge, and symmetrically in its ends. So patches that share an edge meet bit by bit, for any
// depths inside.
GLARK_EXPORT std::string refinement_shader(const ShaderInputs& inputs = {});

// As refinement_shader(), for the corners of write_quartic_corners(). The inputs are two mat4. The vertex stage reads
// column 0. Without normals (""), the positions have the same bits.
GLARK_EXPORT std::string quartic_refinement_shader(const std::string& points = "points",
                                                   const std::string& normals = "normals");

}  // namespace glark::qas

#endif  // GLARK_QAS_H
