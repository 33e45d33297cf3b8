/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * A point cloud as triangle strips, in C: glark/surfel.h says what each function computes. Link to glark-surfel. */
#ifndef GLARK_C_SURFEL_H
#define GLARK_C_SURFEL_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_surfel_element {
  GLARK_SURFEL_CLOUD = 0,
  GLARK_SURFEL_POINT = 1,
  GLARK_SURFEL_NORMAL = 2,
  GLARK_SURFEL_OPTION = 3,
  GLARK_SURFEL_VIEW = 4
} glark_surfel_element;

typedef struct glark_surfel_cloud {
  glark_floats positions; /* [3 * points] */
  glark_floats normals;   /* [3 * points], or empty */
} glark_surfel_cloud;

typedef struct glark_surfel_options {
  unsigned leaf_points; /* 8 to 1024 */
  float delta_a, delta_d;
  float inflation;
  float reach;
  bool turn_edges;
  unsigned levels; /* 1 to 16 */
  unsigned threads;
} glark_surfel_options;

GLARK_EXPORT glark_surfel_options glark_surfel_default_options(void);

typedef struct glark_surfel_node {
  float low[3], high[3];
  float cone_axis[3];
  float cone_apex[3];
  float cone_sine;
  uint32_t left, right;  /* 0xFFFFFFFF in a leaf */
  uint32_t first, count; /* a leaf's strip, in the indices */
  uint32_t representative;
} glark_surfel_node;

typedef struct glark_surfel_nodes {
  const glark_surfel_node* data;
  size_t count;
} glark_surfel_nodes;

typedef struct glark_surfel_counts {
  size_t outer, redundant, dual, valid;
  size_t out_of_reach;
  size_t turned;
  size_t strips;
  size_t indices;
  size_t loose_points;
} glark_surfel_counts;

typedef struct glark_surfel_view {
  float clip_from_object[16]; /* column-major, as in GL */
  unsigned width, height;     /* pixels */
  bool cull_frustum, cull_back_faces;
  float point_pixels, level_pixels;
} glark_surfel_view;

GLARK_EXPORT glark_surfel_view glark_surfel_default_view(void);

typedef struct glark_surfel_strips glark_surfel_strips;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_surfel_strips_create(const glark_surfel_cloud* cloud, const glark_surfel_options* options,
                                                   glark_surfel_strips** strips, glark_error* error);
GLARK_EXPORT void glark_surfel_strips_free(glark_surfel_strips* strips); /* NULL: nothing happens */

GLARK_EXPORT size_t glark_surfel_strips_point_count(const glark_surfel_strips* strips);
GLARK_EXPORT glark_indices glark_surfel_strips_indices(const glark_surfel_strips* strips);
GLARK_EXPORT unsigned glark_surfel_strips_level_count(const glark_surfel_strips* strips);
/* level: 0 is the finest. */
GLARK_EXPORT glark_code glark_surfel_strips_nodes(const glark_surfel_strips* strips, unsigned level,
                                                  glark_surfel_nodes* nodes, glark_error* error);
GLARK_EXPORT glark_code glark_surfel_strips_counts(const glark_surfel_strips* strips, unsigned level,
                                                   glark_surfel_counts* counts, glark_error* error);

/* What a view draws. One frame may be used again for every view. */
typedef struct glark_surfel_frame glark_surfel_frame;

GLARK_EXPORT glark_surfel_frame* glark_surfel_frame_create(void); /* NULL if there is no memory */
GLARK_EXPORT void glark_surfel_frame_free(glark_surfel_frame* frame);
GLARK_EXPORT glark_code glark_surfel_strips_select(const glark_surfel_strips* strips, const glark_surfel_view* view,
                                                   glark_surfel_frame* frame, glark_error* error);

/* For glMultiDrawElements(GL_TRIANGLE_STRIP, counts, GL_UNSIGNED_INT, offsets, draws). The frame owns the arrays. */
GLARK_EXPORT int32_t glark_surfel_frame_draws(const glark_surfel_frame* frame);
GLARK_EXPORT const int32_t* glark_surfel_frame_counts(const glark_surfel_frame* frame);
GLARK_EXPORT const void* const* glark_surfel_frame_offsets(const glark_surfel_frame* frame);
GLARK_EXPORT glark_indices glark_surfel_frame_points(const glark_surfel_frame* frame); /* GL_POINTS */

typedef struct glark_surfel_frame_statistics {
  unsigned level;
  size_t indices, strips;
  size_t visited, out_of_frustum, back_faces; /* numbers of nodes */
} glark_surfel_frame_statistics;

GLARK_EXPORT glark_surfel_frame_statistics glark_surfel_frame_numbers(const glark_surfel_frame* frame);

typedef struct glark_surfel_range {
  size_t first, count;
} glark_surfel_range;

typedef struct glark_surfel_ranges {
  const glark_surfel_range* data;
  size_t count;
} glark_surfel_ranges;

/* ranges: of the indices, that changed; the strips own them until the next update. It may be NULL. */
GLARK_EXPORT glark_code glark_surfel_strips_update(glark_surfel_strips* strips, const glark_surfel_cloud* cloud,
                                                   glark_indices moved, glark_surfel_ranges* ranges,
                                                   glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_SURFEL_H */
