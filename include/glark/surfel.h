// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfel stripping: draws a cloud of points as triangle strips that interpolate it, without reconstructing a surface.
// No point is moved, added or filtered. Strips are indices of the caller's points, so that all attributes of the points
// can be drawn. Link to glark-surfel.
//
//   glark::surfel::Strips strips({positions, normals});   // once; indices() go to a GL_ELEMENT_ARRAY_BUFFER
//   glark::surfel::Frame frame;
//   strips.select({.clip_from_object = matrix, .width = 1920, .height = 1080}, frame);  // every frame
//   glMultiDrawElements(GL_TRIANGLE_STRIP, frame.counts.data(), GL_UNSIGNED_INT, frame.offsets.data(), frame.draws());
//   glDrawElements(GL_POINTS, frame.points.size(), GL_UNSIGNED_INT, frame.points.data());  // parts as small as a pixel
//
// The library makes no GL calls. Space and units are those of the positions. Triangles are counter-clockwise when seen
// from the side that the normals point to. Strips contain degenerate triangles, which join their parts.
//
// All clouds are accepted: empty ones, few points, points on a line, duplicates. Only the first of several points at
// one position is drawn. Points without neighbours within reach have no triangles. Parts that are so noisy that they
// show no surface have no triangles either: their points are drawn as points. Zero normals are ignored. If all
// normals are missing, planes are fitted to the positions. Then strips have no common orientation, and back faces are
// not culled.
//
// The result does not depend on the number of threads.
// Based on: Boubekeur 2007, ch. 5.
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

// Names the wrong element of an argument, and the fault.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The caller owns the arrays. The library reads them during the call only.
struct Cloud {
  std::span<const float> positions = {};  // [3 * points], x y z
  std::span<const float> normals = {};    // [3 * points], of any length; or empty
};

struct Options {
  // The most points in a leaf of the stripping tree, 8 to 1024. The thesis has 20 to 40. Larger leaves share fewer
  // points with their neighbours and have longer strips. So building is faster and strips have fewer indices, but
  // culling is coarser.
  unsigned leaf_points = 192;
  // The height-field indicator of chapter 3.2.2. Leaves are split if the cosine between a point's normal and the leaf's
  // normal is less than delta_a, or if a point is farther from the leaf's plane than delta_d, in radii of the leaf.
  float delta_a = 0.0F;
  float delta_d = 0.6F;
  // The distance within which a leaf takes in points of its neighbours, in mean spacings of its own points, 0.5 to 8.
  float inflation = 1.6F;
  // The longest edge of a triangle, 1 to 100, in units of the triangle's spacing. The spacing is the median of the
  // distances of its three points to their neighbours. Isolated points have no triangles.
  float reach = 5.0F;
  // Edges within a leaf may be flipped where this saves indices. The triangles must be flat: normals differ by less
  // than 26 degrees. The angles opposite to the new edge must be less than 130 degrees on average.
  bool turn_edges = true;
  unsigned levels = 1;   // levels of detail, 1 to 16; each has about a quarter of the points of the previous one
  unsigned threads = 0;  // the most threads; 0: as many as the machine has, 1: the caller's only
};

// A node of the stripping tree of one level of detail.
struct Node {
  std::array<float, 3> low, high;  // the box of all triangles below; low > high where there are none
  std::array<float, 3> cone_axis;  // unit length; the normals of the triangles lie within the cone about the axis
  // A point behind the planes of all triangles, if the sine is below 1; always finite. An eye at e with dot(apex - e, axis) > sine * |apex - e| sees only
  // backs.
  std::array<float, 3> cone_apex;
  float cone_sine;               // sine of the cone's half-angle; 2 for 90 degrees or more
  std::uint32_t left, right;     // child nodes; `none` for a leaf
  std::uint32_t first, count;    // a leaf's strip, in indices()
  std::uint32_t representative;  // the point nearest to the mean of the points below; `none` if there are none
};

// The numbers of triangles in the leaves' triangulations, for each class of chapter 5.2.2. Leaves disagree on `dual`
// triangles, so these are replaced. Only `valid` triangles are drawn.
struct Counts {
  std::size_t outer = 0, redundant = 0, dual = 0, valid = 0;
  std::size_t out_of_reach = 0;  // triangles with an edge that is longer than Options::reach allows
  std::size_t turned = 0;        // edges that were flipped, see Options::turn_edges
  std::size_t strips = 0;        // leaves that have triangles
  std::size_t indices = 0;       // the indices of all strips
  std::size_t loose_points = 0;  // points in parts without a surface; they have no triangles and are drawn as points
};

struct View {
  std::array<float, 16>
      clip_from_object{};          // projection times model-view, column-major as in GL; w > 0 in front of the eye
  unsigned width = 0, height = 0;  // the size of the viewport, in pixels
  bool cull_frustum = true;
  bool cull_back_faces = true;  // does not change the picture where GL_CULL_FACE is enabled
  float point_pixels = 1.0F;    // nodes of at most this size are drawn as points; 0: never
  // The largest distance of points on the screen, in pixels. The coarsest level within this limit is drawn; 0: the
  // finest level.
  float level_pixels = 1.0F;
};

// The strips and points that a frame draws. A frame that is used again needs no new memory.
struct Frame {
  std::vector<std::int32_t> counts;  // for glMultiDrawElements(GL_TRIANGLE_STRIP, ...)
  std::vector<const void*> offsets;  // in bytes from the beginning of indices()
  // For glDrawElements(GL_POINTS, ...): representatives of nodes that are too small for strips, and the points of parts
  // without a surface.
  std::vector<std::uint32_t> points;
  unsigned level = 0;
  std::size_t indices = 0, strips = 0;                          // drawn indices and strips
  std::size_t visited = 0, out_of_frustum = 0, back_faces = 0;  // numbers of nodes
  std::int32_t draws() const { return static_cast<std::int32_t>(counts.size()); }
};

// A part of indices() that must be uploaded again.
struct Range {
  std::size_t first, count;
};

// Only one thread at a time may call update(). All other functions are const; threads may call them together while none
// calls update().
class GLARK_EXPORT Strips {
 public:
  // Errors: Error for arrays that are not three coordinates for each point, coordinates that are not finite or above
  // 1e18, 2^32 - 1 points or more, options out of range.
  explicit Strips(const Cloud& cloud, const Options& options = {});
  ~Strips();
  Strips(Strips&& other) noexcept;
  Strips& operator=(Strips&& other) noexcept;

  std::size_t point_count() const;
  // The strips of all levels, as points of the cloud. After updates there are unused indices between strips.
  std::span<const std::uint32_t> indices() const;
  unsigned level_count() const;
  // The root is the first; there is at least one node. Errors: Error for a level that does not exist.
  std::span<const Node> nodes(unsigned level = 0) const;
  Counts counts(unsigned level = 0) const;

  // Walks the stripping tree from the root. Culls nodes by boxes and cones, draws small nodes as points, and draws the
  // strips of the other leaves. Errors: Error for a view without size, a matrix that is not finite, or pixels below 0.
  void select(const View& view, Frame& frame) const;

  // Updates strips after points moved or their normals changed. `moved` are the indices of these points. The other
  // points of `cloud` must be the same as before. Points beyond the old ones are new. Only moved and new points are
  // read, and only leaves around these points are processed again. Levels of detail keep their points.
  // Returns the sorted ranges of indices() that changed. indices() may have grown beyond the size of its buffer.
  // Errors: as for the constructor, and for fewer points than before or an index beyond the points. After an error,
  // nothing has changed.
  std::vector<Range> update(const Cloud& cloud, std::span<const std::uint32_t> moved);

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

}  // namespace glark::surfel

#endif  // GLARK_SURFEL_H
