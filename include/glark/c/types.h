/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * What the C headers of all client libraries share: arrays and errors. For C99 and later, and for C++.
 *
 * The C functions do what the C++ functions of the same names in glark/NAME.h do; those headers say which values are
 * allowed. The same library has both. Every function that can fail returns a code, and takes a glark_error that may be
 * NULL. After a failure, nothing is written to other results. Functions that only read an object take a NULL object, too:
 * it has nothing, so they return 0 or an empty array.
 * Arrays are a pointer and a number of elements. A count of 0 with NULL is an empty array. */
#ifndef GLARK_C_TYPES_H
#define GLARK_C_TYPES_H

#include <glark/export.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_code {
  GLARK_SUCCESS = 0,
  GLARK_BAD_ARGUMENT = 1,
  GLARK_OUT_OF_MEMORY = 2,
  GLARK_INTERNAL_ERROR = 3
} glark_code;

enum { GLARK_MESSAGE_SIZE = 512, GLARK_NO_ELEMENT = -1 };

typedef struct glark_error {
  glark_code code;
  int element;                      /* a glark_NAME_element, or GLARK_NO_ELEMENT */
  size_t index;                     /* of the element; 0 where there is only one */
  char message[GLARK_MESSAGE_SIZE]; /* the library, the element, its value and the remedy; ends with 0 */
} glark_error;

/* Arrays that are only read. */
typedef struct glark_floats {
  const float* data;
  size_t count; /* of numbers, not of points */
} glark_floats;

typedef struct glark_indices {
  const uint32_t* data;
  size_t count;
} glark_indices;

typedef struct glark_bytes {
  const uint8_t* data;
  size_t count;
} glark_bytes;

/* An array of the caller that a function fills. */
typedef struct glark_float_output {
  float* data;
  size_t count;
} glark_float_output;

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_TYPES_H */
