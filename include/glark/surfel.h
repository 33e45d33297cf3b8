// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfel stripping: a cloud of points drawn as triangle strips that interpolate it, without reconstructing a surface. No point is
// moved, added or filtered: strips are indices of the caller's points, so that whatever attributes these have are drawn as they are.
// Link to glark-surfel.
//
//   glark::surfel::Strips strips({positions, normals});              // once; indices() go to a GL_ELEMENT_ARRAY_BUFFER
//   glark::surfel::Frame frame;
//   strips.select({.clip_from_object = matrix, .width = 1920, .height = 1080}, frame);          // every frame
//   glMultiDrawElements(GL_TRIANGLE_STRIP, frame.counts.data(), GL_UNSIGNED_INT, frame.offsets.data(), frame.draws());
//   glDrawElements(GL_POINTS, frame.points.size(), GL_UNSIGNED_INT, frame.points.data());       // what is a pixel small
//
// The library makes no GL calls. Space and units are those of the positions. Triangles are counter-clockwise seen from where the normals
// point; strips contain triangles without area, which join their parts.
//
// Clouds of any kind are taken: of no points or few, on a line, with points many times. Of points at one place, the one of the lowest
// index is drawn. Points without neighbours within reach have no triangles. A zero normal says nothing. Without normals the
// planes of leaves are fitted to the positions: then strips have no common orientation, and no back faces to cull.
//
// The result is the same for any number of threads. Source: Boubekeur 2007, ch. 5.
#ifndef GLARK_SURFEL_H
#define GLARK_SURFEL_H

#include <glark/error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glark::surfel {

inline constexpr std::uint32_t none = 0xFFFFFFFFU;

enum class Element { cloud, point, normal, option, view };

// What is wrong with an argument, and with which element of it.
class Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays; they are read during the call only.
struct Cloud {
  std::span<const float> positions = {};  // [3 * points], x y z
  std::span<const float> normals = {};    // [3 * points], of any length; or none
};

struct Options {
  // At most in a leaf of the stripping tree, 8 to 1024. The thesis has 20 to 40; with more, fewer points are in several leaves, and strips
  // are longer: they are made faster and have fewer indices, but are culled less finely.
  unsigned leaf_points = 192;
  // The height-field indicator of chapter 3.2.2, by which leaves are split: the least cosine between a point's normal and the leaf's,
  // and the greatest distance of a point from the leaf's plane, in radii of the leaf.
  float delta_a = 0.0F;
  float delta_d = 0.6F;
  float inflation = 1.6F;  // how far a leaf takes in points of others, in its mean distance of points; 0.5 to 8
  // The longest edge of a triangle, in the distance to neighbours of that of its points whose distance is neither least nor greatest; 1 to
  // 100. Isolated points have no triangles.
  float reach = 5.0F;
  // Whether edges within a leaf may turn to the other diagonal of their two triangles, where that saves indices, the triangles are flat
  // (their normals differ by less than 26 degrees) and good enough (angles opposite to the edge of less than 130 degrees on average).
  bool turn_edges = true;
  unsigned levels = 1;   // of detail, 1 to 16; each has about a quarter of the points of the one before
  unsigned threads = 0;  // at most; 0: as many as the machine has, 1: none but the caller's
};

// Of the stripping tree, or of that of a coarser level of detail.
struct Node {
  std::array<float, 3> low, high;  // the box of all triangles below; low > high where there are none
  std::array<float, 3> cone_axis;  // of unit length; the triangles' normals lie within the cone about it
  // Behind the planes of all triangles: from e with dot(apex - e, axis) > sine * |apex - e| their backs are seen.
  std::array<float, 3> cone_apex;
  float cone_sine;               // of its half-angle; 2 where it has 90 degrees or more
  std::uint32_t left, right;     // nodes; `none` for a leaf
  std::uint32_t first, count;    // a leaf's strip, in indices()
  std::uint32_t representative;  // the point nearest to the mean of those below; `none` where there are none
};

// The classes of triangles of chapter 5.2.2, and how many the leaves' triangulations had of each. `dual`: others are drawn where leaves
// disagree; `valid`: what is drawn.
struct Counts {
  std::size_t outer = 0, redundant = 0, dual = 0, valid = 0;
  std::size_t out_of_reach = 0;  // with an edge longer than Options::reach allows
  std::size_t turned = 0;        // edges, by Options::turn_edges
  std::size_t strips = 0;        // leaves that have triangles
  std::size_t indices = 0;       // of all strips
};

struct View {
  std::array<float, 16>
      clip_from_object{};          // projection times model-view, column-major as GL has it; w > 0 before the eye
  unsigned width = 0, height = 0;  // of the viewport, in pixels
  bool cull_frustum = true;
  bool cull_back_faces = true;  // with GL_CULL_FACE the picture is the same with and without
  float point_pixels = 1.0F;    // what is not larger than that is drawn as a point; 0: nothing is
  // The coarsest level of detail whose points are at most so many pixels apart is drawn; 0: the finest.
  float level_pixels = 1.0F;
};

// What to draw. Kept from frame to frame, it is not allocated again.
struct Frame {
  std::vector<std::int32_t> counts;  // for glMultiDrawElements(GL_TRIANGLE_STRIP, ...)
  std::vector<const void*> offsets;  // in bytes from the beginning of indices()
  std::vector<std::uint32_t>
      points;  // for glDrawElements(GL_POINTS, ...): representatives of what is too small for strips
  unsigned level = 0;
  std::size_t indices = 0, strips = 0;                          // drawn
  std::size_t visited = 0, out_of_frustum = 0, back_faces = 0;  // nodes
  std::int32_t draws() const { return static_cast<std::int32_t>(counts.size()); }
};

// Of indices(), to be uploaded again.
struct Range {
  std::size_t first, count;
};

// One thread at a time may call update(); the others are const and safe then.
class Strips {
 public:
  // Errors: Error for an array that is not made of whole points, a normal array of another size, a coordinate that is not finite
  // or above 1e18, 2^32 - 1 points or more, an option out of its range.
  explicit Strips(const Cloud& cloud, const Options& options = {});
  ~Strips();
  Strips(Strips&& other) noexcept;
  Strips& operator=(Strips&& other) noexcept;

  std::size_t point_count() const;
  // Strips of all levels, points of the cloud; between them is what updates left over.
  std::span<const std::uint32_t> indices() const;
  unsigned level_count() const;
  // The root is the first; there is one at least. Errors: Error for a level that there is not.
  std::span<const Node> nodes(unsigned level = 0) const;
  Counts counts(unsigned level = 0) const;

  // The stripping tree from top to bottom: culling by boxes and cones, points for what is small, strips for the rest, each a
  // draw of the multi-draw. Errors: Error for a view without size, or a matrix that is not finite.
  void select(const View& view, Frame& frame) const;

  // Points that moved or whose normals changed: `moved` are their indices, and `cloud` has the same points otherwise, or more, which
  // are new; nothing but the moved and the new is read of it. Only leaves that they touch are made anew; the tree grows where they have
  // moved to. Returns what changed in indices(), sorted; it may have grown, beyond what its buffer holds. A level of detail keeps its points.
  // Errors: as the constructor, for fewer points than before, an index that is no point; nothing has changed then.
  std::vector<Range> update(const Cloud& cloud, std::span<const std::uint32_t> moved);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace glark::surfel

#endif  // GLARK_SURFEL_H
