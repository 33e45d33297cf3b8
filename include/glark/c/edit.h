/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT
 *
 * Sessions that edit a scan of any size, in C: glark/edit.h says what each function does. Names of files are in UTF-8 and
 * end with 0. Link to glark-edit. */
#ifndef GLARK_C_EDIT_H
#define GLARK_C_EDIT_H

#include <glark/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glark_edit_element {
  GLARK_EDIT_OPTION = 0,
  GLARK_EDIT_ARRAY = 1,
  GLARK_EDIT_OPERATION = 2,
  GLARK_EDIT_FILE = 3
} glark_edit_element;

typedef struct glark_edit_session_options {
  size_t target; /* the most samples, above 0 */
  size_t memory; /* bytes, 40 MiB or more */
  unsigned threads;
} glark_edit_session_options;

GLARK_EXPORT glark_edit_session_options glark_edit_default_session_options(void);

typedef struct glark_edit_session glark_edit_session;

/* options: NULL for the default. */
GLARK_EXPORT glark_code glark_edit_session_open(const char* scan, const char* folder,
                                                const glark_edit_session_options* options, glark_edit_session** session,
                                                glark_error* error);
GLARK_EXPORT void glark_edit_session_free(glark_edit_session* session); /* NULL: nothing happens */

/* operation: a line of text, "inflate 0 0 1 0.2 0.05" for example. */
GLARK_EXPORT glark_code glark_edit_session_apply(glark_edit_session* session, const char* operation,
                                                 glark_error* error);
GLARK_EXPORT size_t glark_edit_session_operations(const glark_edit_session* session); /* lines of the log */
GLARK_EXPORT size_t glark_edit_session_size(const glark_edit_session* session);       /* samples */

/* The edited sampling. The session owns the arrays, until its next call. */
GLARK_EXPORT const double* glark_edit_session_positions(const glark_edit_session* session); /* [3 * samples] */
GLARK_EXPORT glark_floats glark_edit_session_normals(const glark_edit_session* session);    /* [3 * samples] */
GLARK_EXPORT glark_bytes glark_edit_session_colours(const glark_edit_session* session); /* [3 * samples], or empty */

/* Transfers the edit to the scan. */
GLARK_EXPORT glark_code glark_edit_session_save(const glark_edit_session* session, const char* output,
                                                glark_error* error);

#ifdef __cplusplus
}
#endif

#endif /* GLARK_C_EDIT_H */
