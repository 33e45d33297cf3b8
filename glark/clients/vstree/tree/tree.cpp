// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The class Tree of the public header.
#include <algorithm>

#include "glark/clients/common/points/point_set.h"
#include "glark/clients/vstree/tree/construction.h"
#include "glark/clients/vstree/tree/prune.h"
#include "glark/clients/vstree/validation.h"

namespace glark::vstree {
namespace {

// Returns options that divide deeply: a leaf of the result has about four parts.
Options finely(Options options, std::size_t points) {
  options.threshold = 0;
  const std::size_t each = points / (std::size_t{4} * options.most_leaves);
  options.least_samples = std::max(options.least_samples, static_cast<std::uint32_t>(each));
  return options;
}

}  // namespace

struct Tree::State {
  Cube cube;
  Nodes tree;
  std::vector<Frame> frames;
  std::vector<std::uint32_t> order;

  State(PointSet points, const Options& options);
};

Tree::State::State(PointSet points, const Options& options) {
  const Workers workers(options.threads);
  check(options);
  check(points, workers);
  std::vector<float> normals;
  if (points.normals.empty()) {
    normals = estimate_normals(points, {.threads = options.threads});
    points.normals = normals;
  }
  const std::size_t count = points.positions.size() / 3;
  cube = bounding_cube(points.positions, workers);
  tree = construct(points, cube, options.most_leaves == 0 ? options : finely(options, count), order, workers);
  if (options.most_leaves != 0) {
    const std::vector<float> errors = monotone_errors(tree.nodes);
    prune(tree, errors, LeafCounts::of(tree.nodes, errors).threshold_for(options.most_leaves));
  }
  tree.nodes.shrink_to_fit();
  for (std::size_t i = 0; i < tree.frames.size(); ++i)
    frames.push_back(tree.frames[i].in_space(cube, tree.frame_nodes[i]));
}

std::uint32_t Node::child(unsigned which) const {
  if (joined == 0) return first_child + static_cast<std::uint32_t>(std::popcount(children & ((1U << which) - 1)));
  const auto first_of_pair = [&](unsigned quadrant) {
    constexpr std::array<std::array<unsigned, 2>, 4> pairs{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
    for (unsigned i = 0; i < pairs.size(); ++i) {
      if ((joined & (1U << i)) != 0 && pairs[i][1] == quadrant) return pairs[i][0];
    }
    return quadrant;
  };
  std::uint32_t result = first_child;
  for (unsigned before = 0; before < first_of_pair(which); ++before)
    result += (children & (1U << before)) != 0 && first_of_pair(before) == before ? 1 : 0;
  return result;
}

Tree::Tree(const PointSet& points, const Options& options) : state_(std::make_unique<State>(points, options)) {}
Tree::~Tree() = default;
Tree::Tree(Tree&& other) noexcept = default;
Tree& Tree::operator=(Tree&& other) noexcept = default;

std::span<const Node> Tree::nodes() const { return state_->tree.nodes; }
std::span<const Frame> Tree::frames() const { return state_->frames; }
std::span<const std::uint32_t> Tree::order() const { return state_->order; }
std::span<const std::uint32_t> Tree::samples(const Node& node) const {
  return order().subspan(node.begin, node.size());
}

std::size_t Tree::leaf_count() const {
  return static_cast<std::size_t>(
      std::count_if(nodes().begin(), nodes().end(), [](const Node& node) { return node.is_leaf(); }));
}

std::size_t Tree::bytes() const {
  return nodes().size_bytes() + frames().size_bytes() + order().size_bytes() +
         frames().size() * (sizeof(LocalFrame) + sizeof(std::uint32_t));
}

float Tree::diagonal() const { return state_->cube.diagonal * state_->cube.side; }

std::uint32_t Tree::leaf_of(const std::array<float, 3>& position) const {
  const std::span<const Node> all = nodes();
  const Float4 point = state_->cube.inside(position.data());
  if (all.empty()) return none;
  for (int i = 0; i < 3; ++i) {
    if (!(point[i] >= 0 && point[i] <= 1.000001F)) return none;
  }
  const auto [x, y, z] = octree_cell(point);
  std::uint32_t at = 0;
  unsigned depth = 0;  // below the root of the octree, then of the quadtree
  std::array<std::uint32_t, 2> uv{};
  while (true) {
    const Node& node = all[at];
    if (node.kind == Kind::transition) {
      const LocalFrame& frame = state_->tree.frames[node.frame];
      uv = frame.cell(frame.inside(point));
      depth = 0;
    }
    if (node.is_leaf()) return at;
    unsigned which = 0;
    if (node.kind == Kind::volume) {
      const unsigned shift = octree_levels - 1 - depth;
      which = ((x >> shift) & 1) | (((y >> shift) & 1) << 1) | (((z >> shift) & 1) << 2);
    } else {
      const unsigned shift = quadtree_levels - 1 - depth;
      which = ((uv[0] >> shift) & 1) | (((uv[1] >> shift) & 1) << 1);
    }
    if ((node.children & (1U << which)) == 0) return at;
    at = node.child(which);
    ++depth;
  }
}

}  // namespace glark::vstree
