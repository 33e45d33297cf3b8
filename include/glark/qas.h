// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// QAS: subdivision surfaces in real time. One limit step of Loop's scheme on the CPU gives six points and normals of the limit
// surface for every triangle of a coarse mesh; a refinement shader (GL_ARK_adaptive_refinement) fits a quadratic patch to each
// six and evaluates it at the refined vertices. Link to glark-qas.
//
//   glark::qas::Surface surface({vertex_count, triangles});        // once: the topology
//   std::vector<glark::qas::Corner> corners(surface.corner_count());
//   glRefinementShaderSourceARK(program, 1, &source, nullptr);     // refinement_shader(inputs).c_str()
//   surface.update(positions);                                     // every frame in which the mesh moves
//   surface.write_corners(corners);                                // to a buffer; drawn by glDrawArrays(GL_TRIANGLES, ...)
//
// Space and units are those of the positions. Indices count from 0, triangles are counter-clockwise seen from outside.
//
// Meshes of any kind are taken. Edges of one triangle, of more than two, or of two that disagree on the orientation are creases,
// beside those that are named; so every vertex is smooth, on a crease of two edges, or a corner that stays where it is.
//   - An isolated vertex is its own limit.
//   - A triangle with two equal indices is ignored, and drawn as a point.
//   - A triangle with the vertices of an earlier one is drawn as that one; its normals are reversed if its orientation is.
//   - Where the limit surface has no normal, the mean normal of the coarse triangles stands for it, and (0, 0, 1) if that is zero.
// Every number that comes out is finite, and every normal has unit length.
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

// What is wrong with an argument, and with which element of it.
class Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays; they are read by the constructors only.
struct Mesh {
  std::size_t vertex_count = 0;
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles], vertices
  std::span<const std::uint32_t> creases =
      {};  // [2 * creases], the two ends of edges across which the surface is not smooth
};

enum class Scheme {
  loop,                // approximates the coarse mesh
  modified_butterfly,  // interpolates it; creases have the four-point rule
};

struct Options {
  Scheme scheme = Scheme::loop;
  // 0: one patch for each triangle, as in the thesis. 1: four, after one more step of the scheme, which costs about four times
  // as much and is five times as exact; the patches are drawn one level less deep.
  unsigned splits = 0;
  unsigned threads = 0;  // at most; 0: as many as the machine has, 1: none but the caller's
};

struct alignas(16) Vector {
  float x, y, z, w;  // w: 1 for a position, 0 for a normal
};

// Six positions and normals by index: at corners 0, 1, 2, and in the middle of the edges 01, 12, 20.
struct Patch {
  std::array<std::uint32_t, 6> positions;
  std::array<std::uint32_t, 6> normals;
};

// A corner of a patch as the vertex stage reads it, with the edge to the next corner.
struct Corner {
  std::array<float, 3> position;
  std::array<float, 3> edge_position;
  std::array<float, 3> normal;
  std::array<float, 3> edge_normal;
};

// A corner of a coarse triangle of a surface of splits 1 as the vertex stage reads it: two matrices, by columns. points: the corner,
// and the points at 1/4, 2/4 and 3/4 of the edge to the next corner, x y z each; the fourth components of columns 0, 1 and 2 are the
// x y z of the inner point next to the corner, whose weights are 2/4, 1/4 and 1/4. normals: the same of the normals.
struct QuarticCorner {
  std::array<std::array<float, 4>, 4> points;
  std::array<std::array<float, 4>, 4> normals;
};

// A point of a surface and its normal, of unit length.
struct Sample {
  std::array<float, 3> position;
  std::array<float, 3> normal;
};

// The limit step. One thread at a time may call update(); the others are const and safe then.
class Surface {
 public:
  // Errors: Error for an array that is not made of whole triangles or creases, an index that is no vertex, a crease that is no
  // edge, more than 2^26 triangles, splits above 1.
  explicit Surface(const Mesh& mesh, const Options& options = {});
  ~Surface();
  Surface(Surface&& other) noexcept;
  Surface& operator=(Surface&& other) noexcept;

  // Moves the mesh. positions: [3 * vertex_count], x y z of every vertex; read, not kept. Allocates nothing.
  // Errors: Error for an array of another size, or a coordinate that is not finite or above 1e37; nothing has changed then.
  void update(std::span<const float> positions);

  // What update() found, owned by the surface; all zero before the first.
  std::span<const Vector> limit_positions() const;
  std::span<const Vector> limit_normals() const;
  // In the order of the triangles; of splits 1: the three at the corners, then the middle one.
  std::span<const Patch> patches() const;

  // Three for each patch.
  std::size_t corner_count() const;
  // Errors: Error if `corners` has another size than corner_count(); nothing is written then. Allocates nothing.
  void write_corners(std::span<Corner> corners) const;
  // [corner_count()], for attributes of the coarse vertices such as texture coordinates and depth tags: the corner lies half-way
  // between the two, which are the same at a coarse vertex.
  std::span<const std::array<std::uint32_t, 2>> corner_vertices() const;

  // The patch at barycentric coordinates (w, u, v), 0 to 1 with the sum 1, that belong to corners 0, 1, 2: what the refinement
  // shader computes. Errors: Error if there is no such patch, or the coordinates are no such.
  Sample evaluate(std::size_t patch, std::array<float, 3> barycentric) const;

  // Of splits 1, in place of four quadratic patches: one quartic for each coarse triangle, through the same 15 points and normals.
  // Where the surface is smooth it is ten times as exact, about extraordinary vertices twice.
  // Three for each coarse triangle, in the order of Mesh::triangles; 0 without splits.
  std::size_t quartic_corner_count() const;
  // Errors: as write_corners(), for quartic_corner_count().
  void write_quartic_corners(std::span<QuarticCorner> corners) const;
  // As evaluate(), for a coarse triangle. Errors: Error without splits, too.
  Sample evaluate_quartic(std::size_t triangle, std::array<float, 3> barycentric) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Loop's limit surface itself, evaluated at any parameter: the reference for Surface, and a slow refinement.
// Source: Boubekeur 2007, ch. 7.5; J. Stam, Evaluation of Loop Subdivision Surfaces, 1999.
class LoopSurface {
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
  // All triangles at the vertices of the uniform pattern of `level`, 0 to 11: [triangles * (2^level + 1) * (2^level + 2) / 2], for
  // i = 0 .. 2^level the j = 0 .. 2^level - i, at (w, u, v) = (2^level - i - j, i, j) / 2^level. Errors: Error for another size or
  // level; nothing is written then.
  void refine(unsigned level, std::span<Sample> samples, unsigned threads = 0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The vertex inputs that the refinement shader reads, of three components or more; position and normal are what the vertex stage
// gets. All of them have to be active in it, so that pairs are best: `in mat2x3 point` with the position in column 0 and that of the
// edge in column 1. A matrix takes a location, and an array, for each column. Without a normal (""), as in a depth-only pass, the
// positions are the same bits.
struct ShaderInputs {
  std::string position = "point[0]";
  std::string edge_position = "point[1]";
  std::string normal = "normal[0]";
  std::string edge_normal = "normal[1]";
};

// GLSL for glRefinementShaderSourceARK, from 1.20 on. What lies on an edge is computed from the edge's three points alone, and
// alike from both ends: patches that share them meet bit by bit, whatever their depths inside.
std::string refinement_shader(const ShaderInputs& inputs = {});

// As refinement_shader(), for the corners of write_quartic_corners(): inputs are two mat4, of which the vertex stage reads column 0.
// Without normals (""), the positions are the same bits.
std::string quartic_refinement_shader(const std::string& points = "points", const std::string& normals = "normals");

}  // namespace glark::qas

#endif  // GLARK_QAS_H
