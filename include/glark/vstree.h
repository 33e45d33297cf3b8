// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Volume-surface trees, and simplification of meshes and point sets by clustering. A tree is an octree over samples of
// a surface. Where the samples of a cell are a height field, the cell has a quadtree in a local frame instead. Link to
// glark-vstree.
//
//   glark::vstree::Tree tree({.positions = positions, .normals = normals}, {.threshold = 1e-4F});
//   for (const glark::vstree::Node& node : tree.nodes()) if (node.is_leaf()) ... tree.samples(node) ...
//
//   const auto coarse = glark::vstree::simplify({points, triangles}, {.target = 25000});
//
// Thresholds and errors of distance are root mean squares over samples, relative to the diagonal of their bounding box.
// So the result depends neither on the unit of length nor on the number of threads. Special samples:
//   - No samples give a tree without nodes; one sample, or equal samples, a tree of one leaf.
//   - Normals may have any length. A zero normal is missing; errors and height fields ignore it.
//   - If all normals are missing, estimate_normals() finds them first.
//
// Source: Boubekeur 2007, ch. 3.
#ifndef GLARK_VSTREE_H
#define GLARK_VSTREE_H

#include <glark/error.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glark::vstree {

enum class Element { option, array, point, triangle };

// An error in an argument, the element that has it, and the remedy.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// Samples of a surface. The caller owns the arrays; all but the positions may be empty.
struct PointSet {
  std::span<const float> positions = {};       // [3 * points], in any unit, at most 1e18
  std::span<const float> normals = {};         // [3 * points], towards the outside
  std::span<const std::uint8_t> colours = {};  // [3 * points], red green blue
  std::span<const float> texcoords = {};       // [2 * points]
};

// The error of a node as one cluster.
enum class Metric {
  l2,       // root mean square distance to the plane of the centroid and the mean normal
  l21,      // root mean square difference of the normals from the mean normal, 0 to sqrt(2), without unit
  qef,      // root mean square distance of the best point from the tangent planes of the samples
  density,  // the number of samples
};

struct Options {
  bool surface = true;  // false: a plain octree, for comparison
  Metric metric = Metric::l2;
  float threshold = 1e-4F;  // a node with this error or less is a leaf
  // The height-field indicator: the dot product of each normal with the mean normal is above delta_a, 0 to 1. The
  // distance of each sample from the mean plane, relative to the greatest distance from the centroid, is below delta_d,
  // 0 to 1.
  float delta_a = 0;
  float delta_d = 0.25F;            // 1/6 in the thesis; 0.25 makes the octree less deep
  std::uint32_t least_samples = 1;  // a node with this many samples or fewer is a leaf
  // If not 0, replaces the threshold: at most `most_leaves` leaves, with the least possible greatest error.
  std::uint32_t most_leaves = 0;
  unsigned threads = 0;  // the most threads; 0: as many as the machine has, 1: only the caller's
};

enum class Kind : std::uint8_t {
  volume,      // a cube of the octree
  transition,  // a cube whose samples are a height field over its frame; the root of a quadtree
  surface,     // a rectangle of a quadtree
};

inline constexpr std::uint32_t none = 0xFFFFFFFF;

struct Node {
  std::uint32_t begin = 0, end = 0;  // the range of its samples in Tree::order()
  // Children with samples follow one another, in the order of the bits of `children`. 0: a leaf.
  std::uint32_t first_child = 0;
  std::uint32_t frame = none;  // the transition node above, or the node itself
  float error = 0;             // the error in the tree's metric
  Kind kind = Kind::volume;
  std::uint8_t level = 0;     // the root has 0
  std::uint8_t children = 0;  // the octants (x + 2 y + 4 z) or quadrants (u + 2 v) that have samples, as bits
  // Pairs of quadrants that form one leaf, if the surface bends in one direction only. Bit 0 is for quadrants 0 and 1,
  // bit 1 for 2 and 3, bit 2 for 0 and 2, bit 3 for 1 and 3.
  std::uint8_t joined = 0;

  bool is_leaf() const { return first_child == 0; }
  unsigned child_count() const { return ones(children) - ones(joined); }
  // std::popcount would be a function call where the compiler may not use the instruction.
  static unsigned ones(std::uint8_t bits) {
    constexpr std::uint64_t of_four_bits = 0x4332322132212110;
    return static_cast<unsigned>((of_four_bits >> (4 * (bits & 15U))) & 15U) +
           static_cast<unsigned>((of_four_bits >> (4 * (bits >> 4U))) & 15U);
  }
  // Returns the child for an octant or quadrant that has samples.
  GLARK_EXPORT std::uint32_t child(unsigned which) const;
  std::uint32_t size() const { return end - begin; }
};

// The local frame of a transition node. Its normal is the mean of the samples' normals. Orthogonal to it, u and v are
// the main directions in which the normals vary. So the rectangle is aligned with the surface's curvature.
struct Frame {
  std::array<float, 3> origin;  // the centroid
  std::array<float, 3> u, v, normal;
  std::array<float, 2> low, size;  // the bounding rectangle of the samples over (u, v), from the origin
  std::uint32_t node = 0;
};

class GLARK_EXPORT Tree {
 public:
  // Reads the arrays only during the call. Errors: Error for an array of the wrong size, a number that is not finite or
  // too large, an option out of its range, more than 2^31 samples.
  explicit Tree(const PointSet& points, const Options& options = {});
  ~Tree();
  Tree(Tree&& other) noexcept;
  Tree& operator=(Tree&& other) noexcept;

  // The tree owns these arrays. The root is the first node, and a parent comes before its children.
  std::span<const Node> nodes() const;
  std::span<const Frame> frames() const;
  std::span<const std::uint32_t> order() const;  // [samples]; the samples of a node follow one another
  std::span<const std::uint32_t> samples(const Node& node) const;  // indices of samples
  std::size_t leaf_count() const;
  std::size_t bytes() const;  // the size of all arrays
  float diagonal() const;     // the diagonal of the bounding box, in the positions' unit

  // Returns the leaf whose cell contains the position. If the cell has no sample, returns the last node on the path to
  // it. Returns none outside the root. A sample lies in its own leaf.
  std::uint32_t leaf_of(const std::array<float, 3>& position) const;

 private:
  struct GLARK_PRIVATE State;
  std::unique_ptr<State> state_;
};

struct NormalOptions {
  unsigned neighbours = 16;  // 3 to 256
  // The position of the scanner, to which normals point. Without it, normals agree with their neighbours, and each part
  // points up: at its highest place that is about level, or on the whole if it is an open sheet.
  const std::array<float, 3>* scanner = nullptr;
  unsigned threads = 0;  // as in Options
};

// Returns unit normals: [3 * points]. Normals in points.normals are kept. Each other normal is the direction in which
// the nearest neighbours extend least. Neighbours that are clearly beyond a thin wall or a sharp edge do not count.
// Samples at one position count once. With fewer than three positions, or positions on a line, the normal is zero.
// Source: H. Hoppe et al., Surface Reconstruction from Unorganized Points, 1992. Errors: as Tree.
GLARK_EXPORT std::vector<float> estimate_normals(const PointSet& points, const NormalOptions& options = {});

// The caller owns the arrays.
struct Mesh {
  PointSet points;
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles], indices of points; empty: a set of points
};

enum class Clustering {
  volume_surface,  // leaves of a volume-surface tree
  octree,          // leaves of a plain octree
  grid,            // cubes of one size
};

// The position of the point that represents a cluster.
enum class Representative {
  qef,       // the point nearest to the planes of the cluster's triangles or samples
  centroid,  // the mean of its samples
};

enum class Method {
  cluster,    // replaces clusters of points by one point each; fast
  collapse,   // collapses edges with meshoptimizer; nearer to the surface, in several times the time
  automatic,  // collapse with a max_error, below 200000 triangles, and where clusters tear walls; else cluster
};

struct SimplifyOptions {
  Clustering clustering = Clustering::volume_surface;
  Representative representative = Representative::qef;
  // The most triangles, or points of a point set. The result may have about 1 % less. 0: `threshold` is used instead.
  std::size_t target = 0;
  Metric metric = Metric::l2;
  float threshold = 1e-4F;  // for a tree, as in Options; for a grid, the side of a cube relative to the diagonal
  float delta_a = 0, delta_d = 0.25F;  // as in Options
  // Gives each sheet its own vertices where sheets of the result touch, so that edges have two triangles.
  bool cut = true;
  unsigned threads = 0;             // as in Options
  Method method = Method::cluster;  // points without triangles are always clustered
  float max_error = 0;  // of collapses, relative to the diagonal; 0: no limit with a target, else `threshold`
};

// The result has the attributes of the input, and always normals.
struct Simplified {
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;  // means over a cluster, as the normals
  std::vector<float> texcoords;  // from the sample nearest to the representative; a mean would mix charts of a texture
  std::vector<std::uint32_t> triangles;
  // [points of the input]: the vertex of each point; none if no triangle uses the vertex.
  std::vector<std::uint32_t> representatives;
  Method method = Method::cluster;  // the method that was used
  float error = 0;                  // collapse: meshoptimizer's estimate of the error, relative to the diagonal
};

// Clusters vertices. A triangle stays if its corners are in three clusters. Repeats are removed, and so are pairs of
// opposite orientation. The result has the vertices that its triangles use, or all clusters of a point set.
// Source: Boubekeur 2007, ch. 3.3; P. Lindstrom, Out-of-Core Simplification of Large Polygonal Models, 2000.
// Collapse (M. Garland, P. Heckbert, 1997) keeps points of the input with all their attributes. Boundaries and seams stay
// closed. It may leave more triangles than `target`. A target that is not below the input gives the whole input.
// Errors: as Tree; an index that is no point; max_error with cluster; collapse in a build without meshoptimizer.
GLARK_EXPORT Simplified simplify(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace glark::vstree

#endif  // GLARK_VSTREE_H
