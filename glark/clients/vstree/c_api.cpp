// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/vstree.h>
#include <glark/vstree.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
using glark::c::span_of;
namespace vstree = glark::vstree;

struct glark_vstree_tree {
  vstree::Tree tree;
};
struct glark_vstree_simplified {
  vstree::Simplified mesh;
};

namespace {

// Nodes and frames are given out as they are.
static_assert(sizeof(glark_vstree_node) == sizeof(vstree::Node));
static_assert(offsetof(glark_vstree_node, error) == offsetof(vstree::Node, error));
static_assert(offsetof(glark_vstree_node, joined) == offsetof(vstree::Node, joined));
static_assert(sizeof(glark_vstree_frame) == sizeof(vstree::Frame));
static_assert(offsetof(glark_vstree_frame, low) == offsetof(vstree::Frame, low));
static_assert(offsetof(glark_vstree_frame, node) == offsetof(vstree::Frame, node));
static_assert(static_cast<int>(vstree::Metric::density) == GLARK_VSTREE_DENSITY);
static_assert(static_cast<int>(vstree::Kind::surface) == GLARK_VSTREE_SURFACE);
static_assert(static_cast<int>(vstree::Clustering::grid) == GLARK_VSTREE_GRID);
static_assert(static_cast<int>(vstree::Representative::centroid) == GLARK_VSTREE_CENTROID);
static_assert(static_cast<int>(vstree::Method::automatic) == GLARK_VSTREE_AUTOMATIC);
static_assert(static_cast<int>(vstree::Element::triangle) == GLARK_VSTREE_TRIANGLE);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<vstree::Error>(error, step);
}

vstree::PointSet points_of(const glark_vstree_point_set& points) {
  return {.positions = span_of(points.positions, "positions"),
          .normals = span_of(points.normals, "normals"),
          .colours = span_of(points.colours, "colours"),
          .texcoords = span_of(points.texcoords, "texcoords")};
}

// C may pass any number as an enumeration.
template <class Enumeration>
Enumeration checked(int value, Enumeration last, const char* name) {
  if (value < 0 || value > static_cast<int>(last)) {
    throw vstree::Error(vstree::Element::option, 0,
                        std::string(name) + " is " + std::to_string(value) + "; use a value of its enumeration");
  }
  return static_cast<Enumeration>(value);
}

vstree::Options options_of(const glark_vstree_options& options) {
  return {.surface = options.surface,
          .metric = checked(options.metric, vstree::Metric::density, "metric"),
          .threshold = options.threshold,
          .delta_a = options.delta_a,
          .delta_d = options.delta_d,
          .least_samples = options.least_samples,
          .most_leaves = options.most_leaves,
          .threads = options.threads};
}

vstree::SimplifyOptions options_of(const glark_vstree_simplify_options& options) {
  return {.clustering = checked(options.clustering, vstree::Clustering::grid, "clustering"),
          .representative = checked(options.representative, vstree::Representative::centroid, "representative"),
          .target = options.target,
          .metric = checked(options.metric, vstree::Metric::density, "metric"),
          .threshold = options.threshold,
          .delta_a = options.delta_a,
          .delta_d = options.delta_d,
          .cut = options.cut,
          .threads = options.threads,
          .method = checked(options.method, vstree::Method::automatic, "method"),
          .max_error = options.max_error};
}

}  // namespace

glark_vstree_options glark_vstree_default_options(void) {
  const vstree::Options options;
  return {options.surface,     static_cast<glark_vstree_metric>(options.metric),
          options.threshold,   options.delta_a,
          options.delta_d,     options.least_samples,
          options.most_leaves, options.threads};
}

glark_code glark_vstree_tree_create(const glark_vstree_point_set* points, const glark_vstree_options* options,
                                    glark_vstree_tree** tree, glark_error* error) {
  return guarded(error, [&] {
    const vstree::PointSet given = points_of(needed(points, "points"));
    glark_vstree_tree*& result = needed(tree, "tree");
    const vstree::Options wanted = options == nullptr ? vstree::Options{} : options_of(*options);
    result = std::make_unique<glark_vstree_tree>(glark_vstree_tree{vstree::Tree(given, wanted)}).release();
  });
}

void glark_vstree_tree_free(glark_vstree_tree* tree) { std::unique_ptr<glark_vstree_tree>{tree}; }

glark_vstree_nodes glark_vstree_tree_nodes(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  const auto nodes = tree->tree.nodes();
  return {reinterpret_cast<const glark_vstree_node*>(nodes.data()), nodes.size()};
}
glark_vstree_frames glark_vstree_tree_frames(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  const auto frames = tree->tree.frames();
  return {reinterpret_cast<const glark_vstree_frame*>(frames.data()), frames.size()};
}
glark_indices glark_vstree_tree_order(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  return array_of(tree->tree.order());
}
size_t glark_vstree_tree_leaf_count(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  return tree->tree.leaf_count();
}
size_t glark_vstree_tree_bytes(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  return tree->tree.bytes();
}
float glark_vstree_tree_diagonal(const glark_vstree_tree* tree) {
  if (tree == nullptr) return {};
  return tree->tree.diagonal();
}
uint32_t glark_vstree_tree_leaf_of(const glark_vstree_tree* tree, const float position[3]) {
  if (tree == nullptr || position == nullptr) return vstree::none;
  return tree->tree.leaf_of({position[0], position[1], position[2]});
}

glark_vstree_normal_options glark_vstree_default_normal_options(void) {
  const vstree::NormalOptions options;
  return {options.neighbours, nullptr, options.threads};
}

glark_code glark_vstree_estimate_normals(const glark_vstree_point_set* points,
                                         const glark_vstree_normal_options* options, glark_float_output normals,
                                         glark_error* error) {
  return guarded(error, [&] {
    const vstree::PointSet given = points_of(needed(points, "points"));
    const std::span<float> result = span_of(normals, "normals");
    if (result.size() != given.positions.size()) {
      throw vstree::Error(vstree::Element::array, 0,
                          "normals has " + std::to_string(result.size()) + " numbers for " +
                              std::to_string(given.positions.size()) + " in positions; give it as many");
    }
    vstree::NormalOptions wanted;
    std::array<float, 3> scanner{};
    if (options != nullptr) {
      wanted.neighbours = options->neighbours;
      wanted.threads = options->threads;
      if (options->scanner != nullptr) {
        std::copy_n(options->scanner, 3, scanner.begin());
        wanted.scanner = &scanner;
      }
    }
    std::ranges::copy(vstree::estimate_normals(given, wanted), result.begin());
  });
}

glark_vstree_simplify_options glark_vstree_default_simplify_options(void) {
  const vstree::SimplifyOptions options;
  return {static_cast<glark_vstree_clustering>(options.clustering),
          static_cast<glark_vstree_representative>(options.representative),
          options.target,
          static_cast<glark_vstree_metric>(options.metric),
          options.threshold,
          options.delta_a,
          options.delta_d,
          options.cut,
          options.threads,
          static_cast<glark_vstree_method>(options.method),
          options.max_error};
}

glark_code glark_vstree_simplify(const glark_vstree_mesh* mesh, const glark_vstree_simplify_options* options,
                                 glark_vstree_simplified** simplified, glark_error* error) {
  return guarded(error, [&] {
    const glark_vstree_mesh& given = needed(mesh, "mesh");
    glark_vstree_simplified*& result = needed(simplified, "simplified");
    const vstree::SimplifyOptions wanted = options == nullptr ? vstree::SimplifyOptions{} : options_of(*options);
    result = std::make_unique<glark_vstree_simplified>(
                 glark_vstree_simplified{vstree::simplify(
                     {.points = points_of(given.points), .triangles = span_of(given.triangles, "triangles")}, wanted)})
                 .release();
  });
}

void glark_vstree_simplified_free(glark_vstree_simplified* simplified) {
  std::unique_ptr<glark_vstree_simplified>{simplified};
}

glark_floats glark_vstree_simplified_positions(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.positions);
}
glark_floats glark_vstree_simplified_normals(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.normals);
}
glark_bytes glark_vstree_simplified_colours(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.colours);
}
glark_floats glark_vstree_simplified_texcoords(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.texcoords);
}
glark_indices glark_vstree_simplified_triangles(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.triangles);
}
glark_indices glark_vstree_simplified_representatives(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return array_of(simplified->mesh.representatives);
}
glark_vstree_method glark_vstree_simplified_method(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return GLARK_VSTREE_CLUSTER;
  return static_cast<glark_vstree_method>(simplified->mesh.method);
}
float glark_vstree_simplified_error(const glark_vstree_simplified* simplified) {
  if (simplified == nullptr) return {};
  return simplified->mesh.error;
}
