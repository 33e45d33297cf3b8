// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reconstructs a mesh from samples of a surface of any genus: from scans that are noisy, uneven and in layers. Link to
// glark-reconstruct.
//
//   const auto mesh = glark::reconstruct::reconstruct({.positions = positions, .normals = normals});
//   use(mesh.positions, mesh.normals, mesh.triangles);  // and mesh.colours, where the samples have .colours
//
// The mesh is an oriented manifold, also if vertices at one position count as one. It has a boundary where the samples
// end. Gaps of about a transition node are closed, larger gaps stay open. The mesh is semi-regular: each triangle of a
// coarse mesh is divided into four, `levels` times. The result depends neither on the unit of length nor on the number
// of threads.
//
// Special samples:
//   - No sample, one sample or equal samples give no triangles.
//   - Samples on a line give no triangles or a narrow strip; samples in a plane give an open sheet.
//   - Samples with a zero normal are ignored.
//   - Layers whose normals are opposed are the two sides of a thin part, or of a narrow gap. Both stay, at any distance.
//   - If all normals are missing, vstree::estimate_normals() finds them first.
//
// Source: Boubekeur 2007, ch. 3.4. docs/reference/points.md lists the differences.
#ifndef GLARK_RECONSTRUCT_H
#define GLARK_RECONSTRUCT_H

#include <glark/vstree.h>

#include <cstdint>
#include <vector>

namespace glark::reconstruct {

struct ReconstructOptions {
  // Detail below this size is noise, relative to the diagonal of the bounding box. Transition nodes grow until their
  // samples are this far from their mean planes (L2). 0: only the noise measured in the samples.
  float threshold = 0;
  // Refinement ends when the mesh is about this near to the samples, relative to the diagonal. 0: when the mesh is as
  // dense as the samples.
  float error = 0;
  unsigned levels = 2;  // the most levels of refinement, 0 to 6
  // The number of samples in a cube of the finest level, 2 to 1000. Smaller numbers find thinner parts, larger numbers
  // close larger gaps.
  float node_samples = 6;
  // As in vstree::Options: cells that are no height field are divided down to the finest level.
  float delta_a = 0;
  float delta_d = 0.25F;
  // Parts with less than this share of the whole area are left out, 0 to 1.
  float least_part = 0.01F;
  // The most boundary edges of a hole that is closed, 0 to 1000, counted in the coarse mesh. An edge is about as long
  // as a node.
  std::uint32_t gap_edges = 16;
  unsigned threads = 0;  // as in vstree::Options
};

struct Reconstructed {
  std::vector<float> positions, normals;  // [3 * vertices]
  // [3 * vertices], red green blue: the means of the samples around. Empty if the samples have no colours.
  std::vector<std::uint8_t> colours;
  std::vector<std::uint32_t> triangles;  // [3 * triangles]; the children of triangle i of a level are 4 i to 4 i + 3
  std::uint32_t base_vertices = 0;       // the number of vertices of the coarse mesh; they come first
  std::uint32_t base_triangles = 0;
  unsigned levels = 0;  // levels of refinement
  float node_side = 0;  // the side of the finest transition nodes, in the positions' unit
  float noise = 0;      // root mean square distance of the samples from the nodes' mean planes, in the positions' unit
  std::uint32_t left_out = 0;  // the number of parts that were left out
  float area_left_out = 0;     // their share of the area of all parts, 0 to 1
  std::uint32_t outliers = 0;  // the number of samples that lie on no surface, which were left out
};

// Errors: vstree::Error, as from vstree::Tree.
GLARK_EXPORT Reconstructed reconstruct(const vstree::PointSet& points, const ReconstructOptions& options = {});

// Returns the indices of the samples that lie on no surface, in ascending order. reconstruct() leaves them out. A cloud
// without a surface has none. Errors: as from reconstruct().
GLARK_EXPORT std::vector<std::uint32_t> find_outliers(const vstree::PointSet& points, unsigned threads = 0);

}  // namespace glark::reconstruct

// Deprecated: the former names.
namespace glark::vstree {
using glark::reconstruct::reconstruct;
using glark::reconstruct::Reconstructed;
using glark::reconstruct::ReconstructOptions;
}  // namespace glark::vstree

#endif  // GLARK_RECONSTRUCT_H
