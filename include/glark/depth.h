// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags for the vertices of a triangle mesh, by metrics on the CPU: for glDepthTagPointerARK(GL_FLOAT, ...), or any attribute.
// Source: Boubekeur 2007, ch. 7.2.2: a tag may be set by any metric; these are the usual ones. C++20; no GL.
//
// Every array is the caller's. A vertex is three floats in `positions` and `normals`, one in `tags`; lengths must match the
// mesh. Tags are written as 0 to max_level, never as NaN; they may be fractions, which the extension rounds unless it morphs
// between levels (GL_GEOMORPH_ARK). A vertex without triangles has the tag 0 from metrics of edges and surfaces.
//
// Bad input throws Error, whose message names the element, before anything is written. After construction nothing allocates.
#pragma once

#include <glark/error.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace glark::tagging {

using Vector = std::array<float, 3>;

class Error : public ArgumentError {
 public:
  using ArgumentError::ArgumentError;
};

// Tags fall linearly from `finest` at `nearest` and before to `coarsest` at `farthest` and beyond, in the units of the mesh.
struct DistanceRange {
  Vector point{};  // the eye, or whatever deserves detail
  float nearest = 1;
  float farthest = 10;  // more than `nearest`
  float finest = 6;
  float coarsest = 0;
};

// How large things are on the screen: `pixels_at_one` is what a length of 1 covers at the distance 1 from the eye, which is
// height / (2 tan(field_of_view / 2)). What is nearer than `nearest` counts as if it were there. An edge counts as if it were
// seen from the side, so that tags do not change while it turns.
struct View {
  Vector eye{};
  float pixels_at_one = 1000;
  float nearest = 0.01F;
};

// A grid of heights over texture coordinates 0 to 1, sampled bilinearly and repeated; row by row, the first row at v = 0.
struct HeightMap {
  std::span<const float> heights;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

// Which depths the extension gives to edges. `rounded`: the mean, rounded down, of tags rounded to the nearest integer.
// `geomorph`: the mean rounded down to 1/64, and that up to the next integer; patterns are those of geomorphing.
enum class EdgeRule { rounded, geomorph };

struct Budget {
  float bias = 0;               // that was taken from every tag
  std::uint64_t triangles = 0;  // refined, with the tags as they are now
  bool kept = false;            // false: even the coarse mesh has more
};

class Tagger {
 public:
  // `triangles`: three vertices each; copied. Throws Error for a number that is not a multiple of three, an index that is no
  // vertex, or a level above 11. Triangles may be degenerate, repeated or non-manifold.
  Tagger(std::size_t vertices, std::span<const std::uint32_t> triangles, unsigned max_level);

  std::size_t vertices() const { return vertices_; }
  unsigned max_level() const { return max_level_; }

  // Tags as they were given, clamped.
  void manual(std::span<const float> wanted, std::span<float> tags) const;

  void by_distance(std::span<const float> positions, const DistanceRange& range, std::span<float> tags) const;

  // Deep enough that no segment of an edge is longer than that, in pixels.
  void by_edge_length(std::span<const float> positions, const View& view, float pixels, std::span<float> tags);

  // Deep enough that the segments of an edge keep closer than `tolerance`, in the units of the mesh, to the arc that has the
  // larger principal curvature of an end. `normals` of any length; where one is zero, or all are left out, it is that of the faces.
  void by_curvature(std::span<const float> positions, std::span<const float> normals, float tolerance,
                    std::span<float> tags);
  // The same with a tolerance in pixels.
  void by_curvature(std::span<const float> positions, std::span<const float> normals, const View& view, float pixels,
                    std::span<float> tags);

  // Deep enough that a height, halved at each level, keeps under `tolerance`: the root of the variance of `map` around the
  // triangles about the vertex, of what their linear interpolation does not already have. `coordinates`: two floats a vertex.
  void by_displacement(std::span<const float> coordinates, const HeightMap& map, float tolerance,
                       std::span<float> tags);

  // Principal curvatures, the greater first; positive where the surface bends away from its normal. 1 / units of the mesh.
  // Source: S. Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 2004, sections 3 and 4.
  void principal_curvatures(std::span<const float> positions, std::span<const float> normals, std::span<float> greater,
                            std::span<float> lesser);

  // tags = of both the greater, the lesser, or weight * other + (1 - weight) * tags; weight is 0 to 1.
  void take_greater(std::span<const float> other, std::span<float> tags) const;
  void take_lesser(std::span<const float> other, std::span<float> tags) const;
  void blend(std::span<const float> other, float weight, std::span<float> tags) const;

  // Triangles that the extension draws for these tags, exactly, with GL_MINIMUM_INTERIOR_ARK.
  std::uint64_t refined_triangles(std::span<const float> tags, EdgeRule rule = EdgeRule::rounded) const;
  // Takes as little as possible, to 1/256, from all tags that no more are drawn.
  Budget keep_budget(std::uint64_t triangles, std::span<float> tags, EdgeRule rule = EdgeRule::rounded) const;

 private:
  void check_tags(const char* what, std::span<const float> tags) const;
  void check_positions(std::span<const float> positions) const;
  void check_target(std::span<const float> tags) const;
  void check_normals(std::span<const float> normals) const;
  std::uint64_t refined_triangles(std::span<const float> tags, float bias, EdgeRule rule) const;
  void measure_rings(std::span<const float> positions);
  void find_normals(std::span<const float> positions, std::span<const float> normals);
  void find_areas(std::span<const float> positions);
  void find_frames(std::span<const float> positions);
  void add_tensor(std::span<const float> positions, std::size_t triangle);
  void find_tensors(std::span<const float> positions, std::span<const float> normals);
  float sagitta(std::size_t vertex) const;
  float limited(float tag) const;

  std::size_t vertices_;
  unsigned max_level_;
  std::vector<std::uint32_t> triangles_;
  // Scratch, a value for each vertex: the longest edge there, frames of the tangent planes, tensors in them, and areas.
  std::vector<float> longest_;
  std::vector<Vector> normals_;
  std::vector<Vector> first_axes_;
  std::vector<Vector> second_axes_;
  std::vector<Vector> tensors_;
  std::vector<float> areas_;
  std::vector<Vector> corner_areas_;  // of each triangle
};

}  // namespace glark::tagging
