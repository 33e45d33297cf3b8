/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Normal, colour and displacement maps of a coarse mesh, in C: glark/maps.h says what each function computes. Names of
 * files are in UTF-8 and end with 0. Link to glark-maps. */
#ifndef GLARK_C_MAPS_H
#define GLARK_C_MAPS_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_maps_element {
  GLARK_MAPS_OPTION = 0,
  GLARK_MAPS_ARRAY = 1,
  GLARK_MAPS_TRIANGLE = 2,
  GLARK_MAPS_POINT = 3,
  GLARK_MAPS_FILE = 4
} glark_maps_element;

typedef struct glark_maps_coarse_mesh {
  double origin[3];        /* added to all positions */
  glark_floats positions;  /* [3 * vertices] */
  glark_floats normals;    /* [3 * vertices], or empty */
  glark_indices triangles; /* [3 * triangles], counter-clockwise from outside */
  glark_floats texcoords;  /* [2 * vertices], or empty; the lower left texel is at 0 0 */
} glark_maps_coarse_mesh;

typedef struct glark_maps_fine_mesh {
  double origin[3];        /* added to all positions */
  glark_floats positions;  /* [3 * vertices] */
  glark_floats normals;    /* [3 * vertices], or empty */
  glark_bytes colours;     /* [3 * vertices], red green blue; or empty */
  glark_indices triangles; /* [3 * triangles]; empty: only the vertices */
} glark_maps_fine_mesh;

/* Whose texture coordinates the model has. */
typedef enum glark_maps_texcoord_source {
  GLARK_MAPS_TEXCOORDS_AUTOMATIC = 0, /* those of the coarse mesh if they are usable, or else those of charts */
  GLARK_MAPS_TEXCOORDS_OWN = 1,       /* those of the coarse mesh, or an error */
  GLARK_MAPS_TEXCOORDS_CHARTS = 2     /* those of charts, which are made for the maps */
} glark_maps_texcoord_source;

typedef struct glark_maps_options {
  size_t texture_memory; /* bytes, 1 MiB or more */
  unsigned most_side;    /* 64 to 32768 */
  double noise;          /* of the points, in their unit; 0: they are exact */
  double texels_per_point;
  double reach; /* 0: by the distances of the points */
  bool skip_invalid;
  unsigned threads;
  unsigned width, height; /* of the maps, powers of two; 0: by the number of points */
  glark_maps_texcoord_source texcoords;
} glark_maps_options;

GLARK_EXPORT glark_maps_options glark_maps_default_options(void);

typedef struct glark_maps_model glark_maps_model;

/* Bakes a scan of any size. format: ".ply", ".las" and so on; NULL: by the name. options: NULL for the default. */
GLARK_EXPORT glark_code glark_maps_bake_file(const glark_maps_coarse_mesh* mesh, const char* file, const char* format,
                                             const glark_maps_options* options, glark_maps_model** model,
                                             glark_error* error);
/* Bakes a fine mesh. spacing: the greatest distance of neighbouring samples of a triangle, above 0. */
GLARK_EXPORT glark_code glark_maps_bake_mesh(const glark_maps_coarse_mesh* mesh, const glark_maps_fine_mesh* fine,
                                             double spacing, const glark_maps_options* options,
                                             glark_maps_model** model, glark_error* error);
GLARK_EXPORT void glark_maps_model_free(glark_maps_model* model); /* NULL: nothing happens */

/* 16-bit numbers that are only read. */
typedef struct glark_maps_heights {
  const uint16_t* data;
  size_t count;
} glark_maps_heights;

/* The model owns these arrays. The first row of a map is at the texture coordinate t = 0. */
GLARK_EXPORT glark_floats glark_maps_positions(const glark_maps_model* model);              /* [3 * vertices] */
GLARK_EXPORT glark_floats glark_maps_normals(const glark_maps_model* model);                /* [3 * vertices] */
GLARK_EXPORT glark_floats glark_maps_tangents(const glark_maps_model* model);               /* [4 * vertices] */
GLARK_EXPORT glark_floats glark_maps_texcoords(const glark_maps_model* model);              /* [2 * vertices] */
GLARK_EXPORT glark_indices glark_maps_triangles(const glark_maps_model* model);             /* [3 * triangles] */
GLARK_EXPORT glark_bytes glark_maps_normal_map(const glark_maps_model* model);              /* [3 * width * height] */
GLARK_EXPORT glark_bytes glark_maps_colour_map(const glark_maps_model* model);              /* the same, or empty */
GLARK_EXPORT glark_maps_heights glark_maps_displacement_map(const glark_maps_model* model); /* [width * height] */

typedef struct glark_maps_frame {
  double origin[3];       /* added to all positions */
  unsigned width, height; /* of all maps; powers of two */
  float scale, bias;      /* 65535 in the displacement map is the height scale + bias */
} glark_maps_frame;

GLARK_EXPORT glark_maps_frame glark_maps_model_frame(const glark_maps_model* model);

typedef struct glark_maps_counts {
  uint64_t points, left_out, invalid;
  size_t charts, empty_charts;
  uint64_t texels, filled;
  double reach; /* that was used */
} glark_maps_counts;

GLARK_EXPORT glark_maps_counts glark_maps_model_counts(const glark_maps_model* model);
/* Whether the texture coordinates are those of the coarse mesh. Then the vertices are in its order. */
GLARK_EXPORT bool glark_maps_has_own_texcoords(const glark_maps_model* model);

typedef struct glark_maps_jump {
  float greatest, root_mean_square;
} glark_maps_jump;

/* The differences of the two sides along the edges where two charts meet. */
typedef struct glark_maps_seams {
  glark_maps_jump colour;       /* 0 to 1 */
  glark_maps_jump normal;       /* degrees */
  glark_maps_jump displacement; /* in the unit of the positions */
  size_t edges;
} glark_maps_seams;

GLARK_EXPORT glark_maps_seams glark_maps_model_seams(const glark_maps_model* model);

/* Writes binary glTF, and the displacement map beside it: "model.displacement.png" for "model.glb". */
GLARK_EXPORT glark_code glark_maps_write_model(const char* file, const glark_maps_model* model, glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_MAPS_H */
