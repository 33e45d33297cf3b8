/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * A mesh from points, in C: glark/reconstruct.h says what each function computes. Link to glark-reconstruct. */
#ifndef GLARK_C_RECONSTRUCT_H
#define GLARK_C_RECONSTRUCT_H

#include <glark/c/vstree.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct glark_reconstruct_options {
  float threshold, error;
  unsigned levels; /* 0 to 6 */
  float node_samples;
  float delta_a, delta_d;
  float least_part;
  uint32_t gap_edges;
  unsigned threads;
} glark_reconstruct_options;

GLARK_EXPORT glark_reconstruct_options glark_reconstruct_default_options(void);

typedef struct glark_reconstruct_mesh glark_reconstruct_mesh;

/* options: NULL for the default. Elements of errors: glark_vstree_element. */
GLARK_EXPORT glark_code glark_reconstruct(const glark_vstree_point_set* points,
                                          const glark_reconstruct_options* options, glark_reconstruct_mesh** mesh,
                                          glark_error* error);
GLARK_EXPORT void glark_reconstruct_mesh_free(glark_reconstruct_mesh* mesh); /* NULL: nothing happens */

/* The mesh owns these arrays. */
GLARK_EXPORT glark_floats glark_reconstruct_positions(const glark_reconstruct_mesh* mesh); /* [3 * vertices] */
GLARK_EXPORT glark_floats glark_reconstruct_normals(const glark_reconstruct_mesh* mesh);   /* [3 * vertices] */
GLARK_EXPORT glark_bytes glark_reconstruct_colours(const glark_reconstruct_mesh* mesh); /* [3 * vertices], or empty */
GLARK_EXPORT glark_indices glark_reconstruct_triangles(const glark_reconstruct_mesh* mesh); /* [3 * triangles] */

typedef struct glark_reconstruct_counts {
  uint32_t base_vertices, base_triangles; /* of the coarse mesh */
  unsigned levels;                        /* of refinement */
  float node_side, noise;                 /* in the positions' unit */
  uint32_t left_out;                      /* parts */
  float area_left_out;                    /* of these parts, 0 to 1 */
  uint32_t outliers;                      /* points on no surface, which were left out */
} glark_reconstruct_counts;

GLARK_EXPORT glark_reconstruct_counts glark_reconstruct_mesh_counts(const glark_reconstruct_mesh* mesh);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_RECONSTRUCT_H */
