// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags for the vertices of a triangle mesh, computed by metrics on the CPU. The tags go to
// glDepthTagPointerARK(GL_FLOAT, ...), or to any vertex attribute. The library does not call GL. Link to glark-depth.
// Source: Boubekeur 2007, ch. 7.2.2: any metric may set a tag. This library has the usual metrics.
//
// The caller owns all arrays. A vertex has three floats in `positions` and `normals`, and one in `tags`. Lengths must
// match the mesh. Tags are from 0 to max_level, and never NaN. They may be fractions. The extension rounds fractions,
// unless it morphs between levels (GL_GEOMORPH_ARK). Metrics of edges and surfaces give the tag 0 to vertices without
// triangles.
//
// Bad input throws Error before anything is written. The message names the element. Nothing allocates memory after
// construction.
#pragma once

#include <glark/error.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace glark::depth {

using Vector = std::array<float, 3>;

class GLARK_EXPORT Error : public ArgumentError {
 public:
  using ArgumentError::ArgumentError;
};

// Tags fall linearly from `finest` to `coarsest` between the distances `nearest` and `farthest`, in the units of the
// mesh. Outside this range they are constant.
struct DistanceRange {
  Vector point{};  // the eye, or another place that needs detail
  float nearest = 1;
  float farthest = 10;  // more than `nearest`
  float finest = 6;
  float coarsest = 0;
};

// The scale of lengths on the screen. A length of 1 at the distance 1 from the eye covers `pixels_at_one` pixels:
// height / (2 tan(field_of_view / 2)). Distances below `nearest` are raised to `nearest`. Edges are measured as if they
// were seen from the side. So tags do not change while an edge turns.
struct View {
  Vector eye{};
  float pixels_at_one = 1000;
  float nearest = 0.01F;
};

// A grid of heights over texture coordinates 0 to 1, row by row, the first row at v = 0. It is sampled bilinearly and
// repeated.
struct HeightMap {
  std::span<const float> heights;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

// How the extension computes the depth of an edge.
// `rounded`: each tag is rounded to the nearest integer. The depth is their mean, rounded down.
// `geomorph`: the depth is the mean of the tags, rounded down to 1/64, then up to the next integer. The patterns are
// those of geomorphing.
enum class EdgeRule { rounded, geomorph };

struct Budget {
  float bias = 0;               // subtracted from every tag
  std::uint64_t triangles = 0;  // the number of refined triangles with the new tags
  bool kept = false;            // false: even the coarse mesh exceeds the budget
};

class GLARK_EXPORT Tagger {
 public:
  // triangles: three vertices each. They are copied. Throws Error for a number of indices that is not a multiple of
  // three, more than 2^28 vertices, an index beyond the vertices, or a level above 11. Triangles may be degenerate,
  // repeated or non-manifold.
  Tagger(std::size_t vertices, std::span<const std::uint32_t> triangles, unsigned max_level);
  ~Tagger();
  Tagger(const Tagger& other);
  Tagger& operator=(const Tagger& other);
  Tagger(Tagger&& other) noexcept;
  Tagger& operator=(Tagger&& other) noexcept;

  std::size_t vertices() const { return vertices_; }
  unsigned max_level() const { return max_level_; }

  // Copies the wanted tags, clamped.
  void manual(std::span<const float> wanted, std::span<float> tags) const;

  void by_distance(std::span<const float> positions, const DistanceRange& range, std::span<float> tags) const;

  // The tags are deep enough that no segment of an edge is longer than `pixels`.
  void by_edge_length(std::span<const float> positions, const View& view, float pixels, std::span<float> tags);

  // The tags are deep enough that the segments of an edge are closer than `tolerance`, in the units of the mesh, to an
  // arc. The arc has the larger principal curvature at an end of the edge. Normals may have any length. The normals of
  // the faces replace zero normals and an empty array.
  void by_curvature(std::span<const float> positions, std::span<const float> normals, float tolerance,
                    std::span<float> tags);
  // As above, with a tolerance in pixels.
  void by_curvature(std::span<const float> positions, std::span<const float> normals, const View& view, float pixels,
                    std::span<float> tags);

  // The tags are deep enough that a height is below `tolerance`. The height halves with each level. It is the root mean
  // square difference between the map and its linear interpolation on the triangles around a vertex. `coordinates`: two
  // floats for each vertex.
  void by_displacement(std::span<const float> coordinates, const HeightMap& map, float tolerance,
                       std::span<float> tags);

  // The principal curvatures, in 1 / units of the mesh. They are positive where the surface bends away from its normal.
  // Source: S. Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 2004, sections 3 and 4.
  void principal_curvatures(std::span<const float> positions, std::span<const float> normals, std::span<float> greater,
                            std::span<float> lesser);

  // Each function combines the tags with other tags: the greater of both, the lesser, or weight * other + (1 - weight)
  // * tags. The weight is from 0 to 1.
  void take_greater(std::span<const float> other, std::span<float> tags) const;
  void take_lesser(std::span<const float> other, std::span<float> tags) const;
  void blend(std::span<const float> other, float weight, std::span<float> tags) const;

  // Returns the exact number of triangles that the extension draws for these tags, with GL_MINIMUM_INTERIOR_ARK.
  std::uint64_t refined_triangles(std::span<const float> tags, EdgeRule rule = EdgeRule::rounded) const;
  // Subtracts a bias from all tags, so that at most `triangles` triangles are drawn. It is the least bias in steps of
  // 1/256.
  Budget keep_budget(std::uint64_t triangles, std::span<float> tags, EdgeRule rule = EdgeRule::rounded) const;

 private:
  struct GLARK_PRIVATE State;

  float clamped(float tag) const;
  std::uint64_t count_refined(std::span<const float> tags, float bias, EdgeRule rule) const;

  std::size_t vertices_;
  unsigned max_level_;
  std::unique_ptr<State> state_;
};

}  // namespace glark::depth

// Deprecated: the former name of the namespace.
namespace glark {
namespace tagging = depth;
}  // namespace glark
