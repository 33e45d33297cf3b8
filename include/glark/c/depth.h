/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Depth tags by metrics, in C: glark/depth.h says what each function computes. Link to glark-depth.
 *
 *   glark_depth_tagger* tagger = NULL;
 *   if (glark_depth_tagger_create(vertices, triangles, 5, &tagger, &error) != GLARK_SUCCESS) puts(error.message);
 *   glark_depth_by_distance(tagger, positions, &range, tags, &error);
 *   glark_depth_tagger_free(tagger); */
#ifndef GLARK_C_DEPTH_H
#define GLARK_C_DEPTH_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct glark_depth_tagger glark_depth_tagger;

typedef struct glark_depth_distance_range {
  float point[3];
  float nearest, farthest; /* distances, in the unit of the mesh */
  float finest, coarsest;  /* tags */
} glark_depth_distance_range;

typedef struct glark_depth_view {
  float eye[3];
  float pixels_at_one; /* height / (2 tan(field_of_view / 2)), in pixels */
  float nearest;       /* shorter distances are raised to this one */
} glark_depth_view;

typedef struct glark_depth_height_map {
  glark_floats heights; /* [width * height], row by row, the first row at v = 0 */
  uint32_t width, height;
} glark_depth_height_map;

typedef enum glark_depth_edge_rule { GLARK_DEPTH_ROUNDED = 0, GLARK_DEPTH_GEOMORPH = 1 } glark_depth_edge_rule;

typedef struct glark_depth_budget {
  float bias;         /* subtracted from every tag */
  uint64_t triangles; /* with the new tags */
  bool kept;          /* false: even the coarse mesh exceeds the budget */
} glark_depth_budget;

/* The values that the C++ types begin with. */
GLARK_EXPORT glark_depth_distance_range glark_depth_default_distance_range(void);
GLARK_EXPORT glark_depth_view glark_depth_default_view(void);

/* triangles: [3 * triangles], copied. max_level: 0 to 11. */
GLARK_EXPORT glark_code glark_depth_tagger_create(size_t vertices, glark_indices triangles, unsigned max_level,
                                                  glark_depth_tagger** tagger, glark_error* error);
GLARK_EXPORT void glark_depth_tagger_free(glark_depth_tagger* tagger); /* NULL: nothing happens */

/* positions, normals: [3 * vertices]. tags, wanted, other: [vertices]. coordinates: [2 * vertices]. */
GLARK_EXPORT glark_code glark_depth_manual(const glark_depth_tagger* tagger, glark_floats wanted,
                                           glark_float_output tags, glark_error* error);
GLARK_EXPORT glark_code glark_depth_by_distance(const glark_depth_tagger* tagger, glark_floats positions,
                                                const glark_depth_distance_range* range, glark_float_output tags,
                                                glark_error* error);
GLARK_EXPORT glark_code glark_depth_by_edge_length(glark_depth_tagger* tagger, glark_floats positions,
                                                   const glark_depth_view* view, float pixels, glark_float_output tags,
                                                   glark_error* error);
GLARK_EXPORT glark_code glark_depth_by_curvature(glark_depth_tagger* tagger, glark_floats positions,
                                                 glark_floats normals, float tolerance, glark_float_output tags,
                                                 glark_error* error);
GLARK_EXPORT glark_code glark_depth_by_curvature_on_screen(glark_depth_tagger* tagger, glark_floats positions,
                                                           glark_floats normals, const glark_depth_view* view,
                                                           float pixels, glark_float_output tags, glark_error* error);
GLARK_EXPORT glark_code glark_depth_by_displacement(glark_depth_tagger* tagger, glark_floats coordinates,
                                                    const glark_depth_height_map* map, float tolerance,
                                                    glark_float_output tags, glark_error* error);
GLARK_EXPORT glark_code glark_depth_principal_curvatures(glark_depth_tagger* tagger, glark_floats positions,
                                                         glark_floats normals, glark_float_output greater,
                                                         glark_float_output lesser, glark_error* error);

GLARK_EXPORT glark_code glark_depth_take_greater(const glark_depth_tagger* tagger, glark_floats other,
                                                 glark_float_output tags, glark_error* error);
GLARK_EXPORT glark_code glark_depth_take_lesser(const glark_depth_tagger* tagger, glark_floats other,
                                                glark_float_output tags, glark_error* error);
GLARK_EXPORT glark_code glark_depth_blend(const glark_depth_tagger* tagger, glark_floats other, float weight,
                                          glark_float_output tags, glark_error* error);

GLARK_EXPORT glark_code glark_depth_refined_triangles(const glark_depth_tagger* tagger, glark_floats tags,
                                                      glark_depth_edge_rule rule, uint64_t* triangles,
                                                      glark_error* error);
GLARK_EXPORT glark_code glark_depth_keep_budget(const glark_depth_tagger* tagger, uint64_t triangles,
                                                glark_float_output tags, glark_depth_edge_rule rule,
                                                glark_depth_budget* budget, glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_DEPTH_H */
