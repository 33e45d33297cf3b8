/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/edit.h>
#include <stdio.h>

#include "sphere_points.h"

int main(void) {
  float points[3000];
  glark_edit_session* session = NULL;
  glark_error error;
  FILE* file = fopen("edit_c.raw", "wb");
  int good;
  sphere_points(1000, points);
  if (file == NULL || fwrite(points, sizeof(float), 3000, file) != 3000 || fclose(file) != 0) return 1;
  if (glark_edit_session_open("edit_c.raw", "edit_c.edit", NULL, &session, &error) != GLARK_SUCCESS ||
      glark_edit_session_apply(session, "move 0 0 0 9 0 0 1", &error) != GLARK_SUCCESS ||
      glark_edit_session_apply(session, "undo", &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  good = glark_edit_session_operations(session) == 2 && glark_edit_session_size(session) > 0;
  glark_edit_session_free(session);
  for (const char* const* name =
           (const char* const[]){"edit_c.edit/log", "edit_c.edit/sample.ply", "edit_c.edit/sample.ply.cells",
                                 "edit_c.edit/session", "edit_c.edit", "edit_c.raw", NULL};
       *name != NULL; ++name)
    remove(*name);
  return good ? 0 : 1;
}
