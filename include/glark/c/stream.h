/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Scans of any size, in C: glark/stream.h says what each function computes. Names of files are in UTF-8 and end with 0.
 * Link to glark-stream. */
#ifndef GLARK_C_STREAM_H
#define GLARK_C_STREAM_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_stream_element {
  GLARK_STREAM_OPTION = 0,
  GLARK_STREAM_FILE = 1,
  GLARK_STREAM_POINT = 2
} glark_stream_element;

/* Arrays of doubles that are only read. */
typedef struct glark_stream_doubles {
  const double* data;
  size_t count; /* of numbers, not of points */
} glark_stream_doubles;

typedef struct glark_stream_reader glark_stream_reader;

/* format: ".ply", ".las" and so on; NULL: by the name. */
GLARK_EXPORT glark_code glark_stream_open_points(const char* file, const char* format, glark_stream_reader** reader,
                                                 glark_error* error);
GLARK_EXPORT void glark_stream_reader_free(glark_stream_reader* reader); /* NULL: nothing happens */
/* Whether the number of points is known before the end; it is written to `count`. */
GLARK_EXPORT bool glark_stream_reader_count(const glark_stream_reader* reader, uint64_t* count);
GLARK_EXPORT bool glark_stream_reader_has_normals(const glark_stream_reader* reader);
GLARK_EXPORT size_t glark_stream_reader_channel_count(const glark_stream_reader* reader);
/* The name of a channel; NULL beyond the last one. The reader owns it. */
GLARK_EXPORT const char* glark_stream_reader_channel_name(const glark_stream_reader* reader, size_t channel);

/* The reader owns the arrays, until the next call. No positions: the end. */
typedef struct glark_stream_points {
  uint64_t first;
  glark_stream_doubles positions; /* [3 * points] */
  glark_floats normals;           /* [3 * points], or empty */
  glark_stream_doubles channels;  /* [channels * points] */
} glark_stream_points;

/* most: the most points, 1 or more. After an error of the file, each further read gives the same one, until a seek. */
GLARK_EXPORT glark_code glark_stream_reader_read(glark_stream_reader* reader, size_t most, glark_stream_points* points,
                                                 glark_error* error);
GLARK_EXPORT glark_code glark_stream_reader_seek(glark_stream_reader* reader, uint64_t point, glark_error* error);

typedef struct glark_stream_sample_options {
  size_t target; /* 0: `error` is used */
  double error;
  size_t memory; /* bytes, 40 MiB or more */
  unsigned threads;
  bool skip_invalid;
} glark_stream_sample_options;

GLARK_EXPORT glark_stream_sample_options glark_stream_default_sample_options(void);

typedef struct glark_stream_sample_report {
  uint64_t points, left_out, samples;
  size_t cells;
  bool in_core, is_shuffled;
} glark_stream_sample_report;

/* Writes the sampling, and its index beside it. options: NULL for the default. report: may be NULL. */
GLARK_EXPORT glark_code glark_stream_sample_file(const char* large, const char* small,
                                                 const glark_stream_sample_options* options,
                                                 glark_stream_sample_report* report, glark_error* error);

typedef struct glark_stream_transfer_options {
  unsigned neighbours; /* 3 to 64 */
  bool singular;
  unsigned threads;
} glark_stream_transfer_options;

GLARK_EXPORT glark_stream_transfer_options glark_stream_default_transfer_options(void);

/* options: NULL for the default. points: the number of points, or NULL. */
GLARK_EXPORT glark_code glark_stream_transfer(const char* large, const char* from, const char* to, const char* output,
                                              const glark_stream_transfer_options* options, uint64_t* points,
                                              glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_STREAM_H */
