// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Volume-surface trees: an octree over samples of a surface down to where each cell holds a height field, quadtrees in local frames
// below. And what they are good for: simplification of meshes and point sets by clustering. Link to glark-vstree.
//
//   glark::vstree::Tree tree({.positions = positions, .normals = normals}, {.threshold = 1e-4F});
//   for (const glark::vstree::Node& node : tree.nodes()) if (node.is_leaf()) ... tree.samples(node) ...
//
//   const auto coarse = glark::vstree::simplify({points, triangles}, {.target = 25000});
//
// Thresholds and errors of distance are relative to the diagonal of the samples' bounding box, and per sample: the root of the mean
// of the squares. So the result does not depend on the unit of length; it does not depend on the number of threads either.
//
// Samples as they come:
//   - None at all give a tree without nodes, one sample or equal ones a tree of one leaf.
//   - A normal need not have unit length. One of length zero is missing: it has no say in errors and height fields.
//   - Without any normals, estimate_normals() finds them first.
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

// What is wrong with an argument, with which element of it, and what to do about it.
class Error : public ElementError<Element> {
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

// How far the samples of a node are from what one cluster stands for.
enum class Metric {
  l2,       // root mean square distance to the plane of the centroid and the mean normal
  l21,      // root mean square difference of the normals from the mean normal, 0 to sqrt(2), without unit
  qef,      // root mean square distance of the best point from the tangent planes of the samples
  density,  // the number of samples
};

struct Options {
  bool surface = true;  // false: a plain octree, to compare with
  Metric metric = Metric::l2;
  float threshold = 1e-4F;  // a node with this error or less is a leaf
  // The height-field indicator: each normal has a dot product with the mean normal above delta_a, 0 to 1, and each sample a distance from
  // the mean plane below delta_d, 0 to 1, of the greatest distance from the centroid.
  float delta_a = 0;
  float delta_d = 0.25F;            // the thesis has 1/6; this divides the octree less deep
  std::uint32_t least_samples = 1;  // a node with this many samples or fewer is a leaf
  std::uint32_t most_leaves = 0;    // not 0: instead of the threshold, the leaves with the least greatest error
  unsigned threads = 0;             // at most; 0: as many as the machine has, 1: none but the caller's
};

enum class Kind : std::uint8_t {
  volume,      // a cube of the octree
  transition,  // a cube whose samples are a height field over its frame; the root of a quadtree
  surface,     // a rectangle of a quadtree
};

inline constexpr std::uint32_t none = 0xFFFFFFFF;

struct Node {
  std::uint32_t begin = 0, end = 0;  // its samples, in Tree::order()
  std::uint32_t first_child = 0;  // children with samples follow one another, as the bits of `children` do; 0: a leaf
  std::uint32_t frame = none;     // of the transition node that it is or lies under
  float error = 0;                // by the tree's metric
  Kind kind = Kind::volume;
  std::uint8_t level = 0;     // the root has 0
  std::uint8_t children = 0;  // which octants (x + 2 y + 4 z) or quadrants (u + 2 v) have samples
  // Quadrants that are one leaf, two by two, where the surface bends one way only: bit 0 for 0 and 1, bit 1 for 2 and 3, bit 2 for
  // 0 and 2, bit 3 for 1 and 3.
  std::uint8_t joined = 0;

  bool is_leaf() const { return first_child == 0; }
  unsigned child_count() const { return ones(children) - ones(joined); }
  // std::popcount is a call where the compiler may not use the instruction.
  static unsigned ones(std::uint8_t bits) {
    constexpr std::uint64_t of_four_bits = 0x4332322132212110;
    return static_cast<unsigned>((of_four_bits >> (4 * (bits & 15U))) & 15U) +
           static_cast<unsigned>((of_four_bits >> (4 * (bits >> 4U))) & 15U);
  }
  // Of an octant or quadrant with samples.
  std::uint32_t child(unsigned which) const;
  std::uint32_t size() const { return end - begin; }
};

// Of a transition node. The normal is the mean of the samples' normals; u and v, orthogonal to it, are the main directions of the
// normals' variation, so that the rectangle lies along the surface's curvature.
struct Frame {
  std::array<float, 3> origin;  // the centroid
  std::array<float, 3> u, v, normal;
  std::array<float, 2> low, size;  // the bounding rectangle of the samples over (u, v), from the origin
  std::uint32_t node = 0;
};

class Tree {
 public:
  // Reads the arrays, keeps none. Errors: Error for an array of the wrong size, a number that is not finite or too large, an option
  // out of its range, more than 2^31 samples.
  explicit Tree(const PointSet& points, const Options& options = {});
  ~Tree();
  Tree(Tree&& other) noexcept;
  Tree& operator=(Tree&& other) noexcept;

  // Owned by the tree; the root is first, and a parent comes before its children.
  std::span<const Node> nodes() const;
  std::span<const Frame> frames() const;
  std::span<const std::uint32_t> order() const;                    // [samples], so that those of a node are neighbours
  std::span<const std::uint32_t> samples(const Node& node) const;  // indices of samples
  std::size_t leaf_count() const;
  std::size_t bytes() const;  // of all arrays
  float diagonal() const;     // of the bounding box, in the positions' unit

  // The leaf whose cell holds the position; the last node on the way there if the cell has no sample; none outside the root.
  // A sample lies in its own leaf.
  std::uint32_t leaf_of(const std::array<float, 3>& position) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct NormalOptions {
  unsigned neighbours = 16;  // 3 to 256
  // Where the samples were seen from: normals point there. Otherwise they agree with their neighbours' over a minimum spanning
  // tree, and point out at the highest sample of each part.
  const std::array<float, 3>* scanner = nullptr;
  unsigned threads = 0;  // as Options
};

// [3 * points], of unit length: where points.normals has one, its direction, otherwise that of the least extent of the nearest
// neighbours, where samples at one place count once. Where there is no such direction (fewer than three places, or on a line) it is zero.
// Source: H. Hoppe et al., Surface Reconstruction from Unorganized Points, 1992. Errors: as Tree.
std::vector<float> estimate_normals(const PointSet& points, const NormalOptions& options = {});

// The caller owns the arrays.
struct Mesh {
  PointSet points;
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles], points; none: a set of points
};

enum class Clustering {
  volume_surface,  // leaves of a volume-surface tree
  octree,          // of a plain octree
  grid,            // cubes of one size
};

// Where the one point lies that stands for a cluster.
enum class Representative {
  qef,       // nearest to the planes of the cluster's triangles or samples
  centroid,  // the mean of its samples
};

struct SimplifyOptions {
  Clustering clustering = Clustering::volume_surface;
  Representative representative = Representative::qef;
  // No more triangles than this, or points of a set; as many as that allows (about 1 % less may come out). 0: by `threshold` instead.
  std::size_t target = 0;
  Metric metric = Metric::l2;
  float threshold = 1e-4F;  // of a tree as in Options; of a grid the side of a cube by the diagonal
  float delta_a = 0;        // as in Options
  float delta_d = 0.25F;
  // Cut vertices in which sheets of the result touch into one for each sheet, so that edges have two triangles.
  bool cut = true;
  unsigned threads = 0;  // as in Options
};

// Arrays for what the input has, and normals always.
struct Simplified {
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;  // the means of a cluster, as the normals
  std::vector<float>
      texcoords;  // those of the sample nearest to the representative: a mean would mix charts of a texture
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t>
      representatives;  // [points of the input]: which stands for each; none where no triangle uses it
};

// Clusters vertices; the triangles whose corners are in three clusters stay, each once, and without pairs that face each other.
// Vertices of the result are those that its triangles use, or all clusters of a set of points.
// Source: Boubekeur 2007, ch. 3.3; P. Lindstrom, Out-of-Core Simplification of Large Polygonal Models, 2000.
// Errors: Error as from Tree, and for an index that is no point.
Simplified simplify(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace glark::vstree

#endif  // GLARK_VSTREE_H
