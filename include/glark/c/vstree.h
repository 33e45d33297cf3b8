/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Volume-surface trees, normals of points and simplification, in C: glark/vstree.h says what each function computes.
 * Link to glark-vstree. */
#ifndef GLARK_C_VSTREE_H
#define GLARK_C_VSTREE_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_vstree_element {
  GLARK_VSTREE_OPTION = 0,
  GLARK_VSTREE_ARRAY = 1,
  GLARK_VSTREE_POINT = 2,
  GLARK_VSTREE_TRIANGLE = 3
} glark_vstree_element;

enum { GLARK_VSTREE_NONE = -1 }; /* as a uint32_t: there is no such index */

typedef struct glark_vstree_point_set {
  glark_floats positions; /* [3 * points] */
  glark_floats normals;   /* [3 * points], or empty */
  glark_bytes colours;    /* [3 * points], or empty */
  glark_floats texcoords; /* [2 * points], or empty */
} glark_vstree_point_set;

typedef enum glark_vstree_metric {
  GLARK_VSTREE_L2 = 0,
  GLARK_VSTREE_L21 = 1,
  GLARK_VSTREE_QEF = 2,
  GLARK_VSTREE_DENSITY = 3
} glark_vstree_metric;

typedef struct glark_vstree_options {
  bool surface;
  glark_vstree_metric metric;
  float threshold;
  float delta_a, delta_d;
  uint32_t least_samples, most_leaves;
  unsigned threads;
} glark_vstree_options;

GLARK_EXPORT glark_vstree_options glark_vstree_default_options(void);

typedef enum glark_vstree_kind {
  GLARK_VSTREE_VOLUME = 0,
  GLARK_VSTREE_TRANSITION = 1,
  GLARK_VSTREE_SURFACE = 2
} glark_vstree_kind;

typedef struct glark_vstree_node {
  uint32_t begin, end;  /* the range of its samples in the order */
  uint32_t first_child; /* 0: a leaf */
  uint32_t frame;
  float error;
  uint8_t kind; /* a glark_vstree_kind */
  uint8_t level;
  uint8_t children;
  uint8_t joined;
} glark_vstree_node;

typedef struct glark_vstree_nodes {
  const glark_vstree_node* data;
  size_t count;
} glark_vstree_nodes;

typedef struct glark_vstree_frame {
  float origin[3];
  float u[3], v[3], normal[3];
  float low[2], size[2];
  uint32_t node;
} glark_vstree_frame;

typedef struct glark_vstree_frames {
  const glark_vstree_frame* data;
  size_t count;
} glark_vstree_frames;

typedef struct glark_vstree_tree glark_vstree_tree;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_vstree_tree_create(const glark_vstree_point_set* points,
                                                 const glark_vstree_options* options, glark_vstree_tree** tree,
                                                 glark_error* error);
GLARK_EXPORT void glark_vstree_tree_free(glark_vstree_tree* tree); /* NULL: nothing happens */

/* The tree owns these arrays. */
GLARK_EXPORT glark_vstree_nodes glark_vstree_tree_nodes(const glark_vstree_tree* tree);
GLARK_EXPORT glark_vstree_frames glark_vstree_tree_frames(const glark_vstree_tree* tree);
GLARK_EXPORT glark_indices glark_vstree_tree_order(const glark_vstree_tree* tree); /* [samples] */
GLARK_EXPORT size_t glark_vstree_tree_leaf_count(const glark_vstree_tree* tree);
GLARK_EXPORT size_t glark_vstree_tree_bytes(const glark_vstree_tree* tree);
GLARK_EXPORT float glark_vstree_tree_diagonal(const glark_vstree_tree* tree);
GLARK_EXPORT uint32_t glark_vstree_tree_leaf_of(const glark_vstree_tree* tree, const float position[3]);

typedef struct glark_vstree_normal_options {
  unsigned neighbours;  /* 3 to 256 */
  const float* scanner; /* [3]; NULL: not known */
  unsigned threads;
} glark_vstree_normal_options;

GLARK_EXPORT glark_vstree_normal_options glark_vstree_default_normal_options(void);

/* normals: [3 * points], of unit length. options: NULL for the default. */
GLARK_EXPORT glark_code glark_vstree_estimate_normals(const glark_vstree_point_set* points,
                                                      const glark_vstree_normal_options* options,
                                                      glark_float_output normals, glark_error* error);

typedef struct glark_vstree_mesh {
  glark_vstree_point_set points;
  glark_indices triangles; /* [3 * triangles]; empty: a set of points */
} glark_vstree_mesh;

typedef enum glark_vstree_clustering {
  GLARK_VSTREE_VOLUME_SURFACE = 0,
  GLARK_VSTREE_OCTREE = 1,
  GLARK_VSTREE_GRID = 2
} glark_vstree_clustering;

typedef enum glark_vstree_representative {
  GLARK_VSTREE_BEST_POINT = 0, /* Representative::qef */
  GLARK_VSTREE_CENTROID = 1
} glark_vstree_representative;

typedef enum glark_vstree_method {
  GLARK_VSTREE_CLUSTER = 0,
  GLARK_VSTREE_COLLAPSE = 1,
  GLARK_VSTREE_AUTOMATIC = 2
} glark_vstree_method;

typedef struct glark_vstree_simplify_options {
  glark_vstree_clustering clustering;
  glark_vstree_representative representative;
  size_t target; /* 0: `threshold` is used */
  glark_vstree_metric metric;
  float threshold;
  float delta_a, delta_d;
  bool cut;
  unsigned threads;
  glark_vstree_method method;
  float max_error; /* collapse only; 0: no limit */
} glark_vstree_simplify_options;

GLARK_EXPORT glark_vstree_simplify_options glark_vstree_default_simplify_options(void);

typedef struct glark_vstree_simplified glark_vstree_simplified;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_vstree_simplify(const glark_vstree_mesh* mesh,
                                              const glark_vstree_simplify_options* options,
                                              glark_vstree_simplified** simplified, glark_error* error);
GLARK_EXPORT void glark_vstree_simplified_free(glark_vstree_simplified* simplified); /* NULL: nothing happens */

/* The result owns these arrays. */
GLARK_EXPORT glark_floats glark_vstree_simplified_positions(const glark_vstree_simplified* simplified);
GLARK_EXPORT glark_floats glark_vstree_simplified_normals(const glark_vstree_simplified* simplified);
GLARK_EXPORT glark_bytes glark_vstree_simplified_colours(const glark_vstree_simplified* simplified);
GLARK_EXPORT glark_floats glark_vstree_simplified_texcoords(const glark_vstree_simplified* simplified);
GLARK_EXPORT glark_indices glark_vstree_simplified_triangles(const glark_vstree_simplified* simplified);
GLARK_EXPORT glark_indices glark_vstree_simplified_representatives(const glark_vstree_simplified* simplified);
/* The method that was used, and for a collapse the estimate of its error, relative to the diagonal. */
GLARK_EXPORT glark_vstree_method glark_vstree_simplified_method(const glark_vstree_simplified* simplified);
GLARK_EXPORT float glark_vstree_simplified_error(const glark_vstree_simplified* simplified);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_VSTREE_H */
