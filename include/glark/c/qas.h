/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Subdivision surfaces in real time, in C: glark/qas.h says what each function computes. Link to glark-qas. */
#ifndef GLARK_C_QAS_H
#define GLARK_C_QAS_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_qas_element {
  GLARK_QAS_MESH = 0,
  GLARK_QAS_VERTEX = 1,
  GLARK_QAS_TRIANGLE = 2,
  GLARK_QAS_CREASE = 3,
  GLARK_QAS_ARRAY = 4
} glark_qas_element;

typedef struct glark_qas_mesh {
  size_t vertex_count;
  glark_indices triangles; /* [3 * triangles] */
  glark_indices creases;   /* [2 * creases]; may be empty */
} glark_qas_mesh;

typedef enum glark_qas_scheme { GLARK_QAS_LOOP = 0, GLARK_QAS_MODIFIED_BUTTERFLY = 1 } glark_qas_scheme;

typedef struct glark_qas_options {
  glark_qas_scheme scheme;
  unsigned splits;  /* 0 or 1 */
  unsigned threads; /* 0: as many as the machine has */
} glark_qas_options;

GLARK_EXPORT glark_qas_options glark_qas_default_options(void);

typedef struct glark_qas_patch {
  uint32_t positions[6];
  uint32_t normals[6];
} glark_qas_patch;

typedef struct glark_qas_patches {
  const glark_qas_patch* data;
  size_t count;
} glark_qas_patches;

typedef struct glark_qas_corner {
  float position[3];
  float edge_position[3];
  float normal[3];
  float edge_normal[3];
} glark_qas_corner;

typedef struct glark_qas_quartic_corner {
  float points[4][4];
  float normals[4][4];
} glark_qas_quartic_corner;

typedef struct glark_qas_sample {
  float position[3];
  float normal[3];
} glark_qas_sample;

typedef struct glark_qas_surface glark_qas_surface;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_qas_surface_create(const glark_qas_mesh* mesh, const glark_qas_options* options,
                                                 glark_qas_surface** surface, glark_error* error);
GLARK_EXPORT void glark_qas_surface_free(glark_qas_surface* surface); /* NULL: nothing happens */

/* positions: [3 * vertex_count]. */
GLARK_EXPORT glark_code glark_qas_surface_update(glark_qas_surface* surface, glark_floats positions,
                                                 glark_error* error);

/* The surface owns these arrays. Limits are x y z w, so four floats each. */
GLARK_EXPORT glark_floats glark_qas_surface_limit_positions(const glark_qas_surface* surface);
GLARK_EXPORT glark_floats glark_qas_surface_limit_normals(const glark_qas_surface* surface);
GLARK_EXPORT glark_qas_patches glark_qas_surface_patches(const glark_qas_surface* surface);
GLARK_EXPORT glark_indices glark_qas_surface_corner_vertices(const glark_qas_surface* surface); /* [2 * corners] */

/* corners: an array of the caller with corner_count elements. */
GLARK_EXPORT size_t glark_qas_surface_corner_count(const glark_qas_surface* surface);
GLARK_EXPORT glark_code glark_qas_surface_write_corners(const glark_qas_surface* surface, glark_qas_corner* corners,
                                                        size_t count, glark_error* error);
GLARK_EXPORT size_t glark_qas_surface_quartic_corner_count(const glark_qas_surface* surface);
GLARK_EXPORT glark_code glark_qas_surface_write_quartic_corners(const glark_qas_surface* surface,
                                                                glark_qas_quartic_corner* corners, size_t count,
                                                                glark_error* error);

/* barycentric: (w, u, v), of corners 0, 1 and 2. */
GLARK_EXPORT glark_code glark_qas_surface_evaluate(const glark_qas_surface* surface, size_t patch,
                                                   const float barycentric[3], glark_qas_sample* sample,
                                                   glark_error* error);
GLARK_EXPORT glark_code glark_qas_surface_evaluate_quartic(const glark_qas_surface* surface, size_t triangle,
                                                           const float barycentric[3], glark_qas_sample* sample,
                                                           glark_error* error);

typedef struct glark_qas_loop_surface glark_qas_loop_surface;

GLARK_EXPORT glark_code glark_qas_loop_surface_create(const glark_qas_mesh* mesh, glark_qas_loop_surface** surface,
                                                      glark_error* error);
GLARK_EXPORT void glark_qas_loop_surface_free(glark_qas_loop_surface* surface); /* NULL: nothing happens */
GLARK_EXPORT glark_code glark_qas_loop_surface_update(glark_qas_loop_surface* surface, glark_floats positions,
                                                      glark_error* error);
GLARK_EXPORT glark_code glark_qas_loop_surface_evaluate(const glark_qas_loop_surface* surface, size_t triangle,
                                                        const float barycentric[3], glark_qas_sample* sample,
                                                        glark_error* error);
/* samples: [triangles * (2^level + 1) * (2^level + 2) / 2]. threads: 0 for as many as the machine has. */
GLARK_EXPORT glark_code glark_qas_loop_surface_refine(const glark_qas_loop_surface* surface, unsigned level,
                                                      glark_qas_sample* samples, size_t count, unsigned threads,
                                                      glark_error* error);

/* The names of the vertex shader's inputs. NULL stands for the default of glark/qas.h. */
typedef struct glark_qas_shader_inputs {
  const char* position;
  const char* edge_position;
  const char* normal;
  const char* edge_normal;
} glark_qas_shader_inputs;

/* Return the GLSL text, which the caller gives back with glark_qas_text_free; NULL if there is no memory. */
GLARK_EXPORT char* glark_qas_refinement_shader(const glark_qas_shader_inputs* inputs);
GLARK_EXPORT char* glark_qas_quartic_refinement_shader(const char* points, const char* normals);
GLARK_EXPORT void glark_qas_text_free(char* text);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_QAS_H */
