// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/reconstruct.h>
#include <glark/reconstruct.h>

#include <memory>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
using glark::c::span_of;
using glark::reconstruct::Reconstructed;
using glark::reconstruct::ReconstructOptions;

struct glark_reconstruct_mesh {
  Reconstructed mesh;
};

namespace {

ReconstructOptions options_of(const glark_reconstruct_options& options) {
  return {.threshold = options.threshold,
          .error = options.error,
          .levels = options.levels,
          .node_samples = options.node_samples,
          .delta_a = options.delta_a,
          .delta_d = options.delta_d,
          .least_part = options.least_part,
          .gap_edges = options.gap_edges,
          .threads = options.threads};
}

}  // namespace

glark_reconstruct_options glark_reconstruct_default_options(void) {
  const ReconstructOptions options;
  return {options.threshold, options.error,      options.levels,    options.node_samples, options.delta_a,
          options.delta_d,   options.least_part, options.gap_edges, options.threads};
}

glark_code glark_reconstruct(const glark_vstree_point_set* points, const glark_reconstruct_options* options,
                             glark_reconstruct_mesh** mesh, glark_error* error) {
  return glark::c::guarded<glark::vstree::Error>(error, [&] {
    const glark_vstree_point_set& given = needed(points, "points");
    glark_reconstruct_mesh*& result = needed(mesh, "mesh");
    const glark::vstree::PointSet samples{.positions = span_of(given.positions, "positions"),
                                          .normals = span_of(given.normals, "normals"),
                                          .colours = span_of(given.colours, "colours"),
                                          .texcoords = span_of(given.texcoords, "texcoords")};
    result = std::make_unique<glark_reconstruct_mesh>(
                 glark_reconstruct_mesh{glark::reconstruct::reconstruct(
                     samples, options == nullptr ? ReconstructOptions{} : options_of(*options))})
                 .release();
  });
}

void glark_reconstruct_mesh_free(glark_reconstruct_mesh* mesh) { std::unique_ptr<glark_reconstruct_mesh>{mesh}; }

glark_floats glark_reconstruct_positions(const glark_reconstruct_mesh* mesh) {
  if (mesh == nullptr) return {};
  return array_of(mesh->mesh.positions);
}
glark_floats glark_reconstruct_normals(const glark_reconstruct_mesh* mesh) {
  if (mesh == nullptr) return {};
  return array_of(mesh->mesh.normals);
}
glark_bytes glark_reconstruct_colours(const glark_reconstruct_mesh* mesh) {
  if (mesh == nullptr) return {};
  return array_of(mesh->mesh.colours);
}
glark_indices glark_reconstruct_triangles(const glark_reconstruct_mesh* mesh) {
  if (mesh == nullptr) return {};
  return array_of(mesh->mesh.triangles);
}

glark_reconstruct_counts glark_reconstruct_mesh_counts(const glark_reconstruct_mesh* mesh) {
  if (mesh == nullptr) return {};
  const Reconstructed& made = mesh->mesh;
  return {made.base_vertices, made.base_triangles, made.levels,        made.node_side,
          made.noise,         made.left_out,       made.area_left_out, made.outliers};
}
