// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mesh from samples of a surface: from scans that are noisy, uneven, in layers, and of any genus. Link to glark-reconstruct.
//
//   const auto mesh = glark::reconstruct::reconstruct({.positions = positions, .normals = normals});
//   use(mesh.positions, mesh.normals, mesh.triangles);  // and mesh.colours, where the samples have .colours
//
// Each edge has two triangles that run against each other, or one where the samples end: gaps of about a transition node close, larger
// ones stay open. The mesh is semi-regular: each triangle of a coarse mesh divided into four, `levels` times. The result depends neither
// on the unit of length nor on the number of threads.
//
// Samples as they come: none, one or equal ones give no triangles, those on a line none or a narrow strip, coplanar ones an open sheet. Samples without a
// normal (zero) have no say; without any normals, estimate_normals() finds them first.
//
// Source: Boubekeur 2007, ch. 3.4. What differs is in docs/reference/points.md.
#ifndef GLARK_RECONSTRUCT_H
#define GLARK_RECONSTRUCT_H

#include <glark/vstree.h>

#include <cstdint>
#include <vector>

namespace glark::reconstruct {

struct ReconstructOptions {
  // What is finer than this is noise, relative to the diagonal of the bounding box: the transition nodes grow until their samples are so far
  // from their mean planes (L2). 0: only the noise that the samples show themselves.
  float threshold = 0;
  // Refinement ends when the mesh is about so near to the samples, relative to the diagonal. 0: when it is as dense as they are.
  float error = 0;
  unsigned levels = 2;  // of refinement, at most, 0 to 6
  // How many samples a cube of the finest level has that the surface runs through, 2 to 1000: fewer find thinner parts, more close larger
  // gaps.
  float node_samples = 6;
  // As in vstree::Options: what is no height field is divided as far as the finest level.
  float delta_a = 0;
  float delta_d = 0.25F;
  // Parts whose area is less than this of the whole are left out, 0 to 1.
  float least_part = 0.01F;
  // Holes close whose border has so many edges of the coarse mesh or fewer, 0 to 1000; an edge is about a node long.
  std::uint32_t gap_edges = 16;
  unsigned threads = 0;  // as in vstree::Options
};

struct Reconstructed {
  std::vector<float> positions, normals;  // [3 * vertices]
  // [3 * vertices], red green blue: means of the samples around. None if these have none.
  std::vector<std::uint8_t> colours;
  std::vector<std::uint32_t> triangles;  // [3 * triangles]; the children of triangle i of a level are 4 i to 4 i + 3
  std::uint32_t base_vertices = 0;       // of the coarse mesh, the first of all
  std::uint32_t base_triangles = 0;
  unsigned levels = 0;  // that were refined
  float node_side = 0;  // of the finest transition nodes, in the positions' unit
  float noise = 0;  // root mean square distance of the samples from the mean planes of these, in the positions' unit
  std::uint32_t left_out = 0;  // parts
};

// Errors: vstree::Error, as from vstree::Tree.
Reconstructed reconstruct(const vstree::PointSet& points, const ReconstructOptions& options = {});

}  // namespace glark::reconstruct

// Deprecated: the names that these had before.
namespace glark::vstree {
using glark::reconstruct::reconstruct;
using glark::reconstruct::Reconstructed;
using glark::reconstruct::ReconstructOptions;
}  // namespace glark::vstree

#endif  // GLARK_RECONSTRUCT_H
