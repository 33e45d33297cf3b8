/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Scalar-tagged PN triangles, in C: glark/pn.h says what each function computes. Link to glark-pn. */
#ifndef GLARK_C_PN_H
#define GLARK_C_PN_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_pn_element {
  GLARK_PN_VERTEX = 0,
  GLARK_PN_TRIANGLE = 1,
  GLARK_PN_CREASE = 2,
  GLARK_PN_ARRAY = 3,
  GLARK_PN_OPTION = 4
} glark_pn_element;

typedef struct glark_pn_mesh {
  glark_floats positions;  /* [3 * vertices] */
  glark_indices triangles; /* [3 * triangles] */
  glark_floats normals;    /* [3 * vertices]; empty: the normals of the triangles' planes */
  glark_indices creases;   /* [2 * creases], the two ends of each sharp edge; may be empty */
} glark_pn_mesh;

typedef struct glark_pn_options {
  float crease_degrees; /* 0 to 180; only without normals */
  float sharpness;      /* 0 or more */
  float tension, bias;  /* -1 to 1 */
  bool split;
} glark_pn_options;

/* The values that the C++ type begins with. */
GLARK_EXPORT glark_pn_options glark_pn_default_options(void);

typedef struct glark_pn_tagged_mesh glark_pn_tagged_mesh;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_pn_derive_tags(const glark_pn_mesh* mesh, const glark_pn_options* options,
                                             glark_pn_tagged_mesh** tagged, glark_error* error);
GLARK_EXPORT void glark_pn_tagged_mesh_free(glark_pn_tagged_mesh* tagged); /* NULL: nothing happens */

/* The tagged mesh owns these arrays. */
GLARK_EXPORT glark_floats glark_pn_positions(const glark_pn_tagged_mesh* tagged);         /* [3 * vertices] */
GLARK_EXPORT glark_floats glark_pn_normals(const glark_pn_tagged_mesh* tagged);           /* [3 * vertices] */
GLARK_EXPORT glark_floats glark_pn_discontinuities(const glark_pn_tagged_mesh* tagged);   /* [4 * vertices] */
GLARK_EXPORT glark_floats glark_pn_tags(const glark_pn_tagged_mesh* tagged);              /* [3 * vertices] */
GLARK_EXPORT glark_indices glark_pn_triangles(const glark_pn_tagged_mesh* tagged);        /* [3 * triangles] */
GLARK_EXPORT glark_indices glark_pn_sources(const glark_pn_tagged_mesh* tagged);          /* [2 * vertices] */
GLARK_EXPORT glark_indices glark_pn_triangle_sources(const glark_pn_tagged_mesh* tagged); /* [triangles] */
GLARK_EXPORT size_t glark_pn_crease_vertices(const glark_pn_tagged_mesh* tagged);
GLARK_EXPORT size_t glark_pn_corners(const glark_pn_tagged_mesh* tagged);

typedef struct glark_pn_corner {
  float position[3];
  float normal[3];
  float discontinuity[4]; /* 0 0 0 1: none */
  float tags[3];          /* sharpness, tension, bias */
} glark_pn_corner;

typedef struct glark_pn_sample {
  double position[3];
  double normal[3];
} glark_pn_sample;

/* barycentric: of corners 0, 1 and 2, each 0 to 1; the sum is 1. All numbers must be finite. */
GLARK_EXPORT glark_code glark_pn_evaluate(const glark_pn_corner corners[3], const double barycentric[3],
                                          glark_pn_sample* sample, glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_PN_H */
