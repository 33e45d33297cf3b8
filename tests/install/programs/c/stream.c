/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/stream.h>
#include <stdio.h>

#include "sphere_points.h"

int main(void) {
  float points[3000];
  glark_stream_reader* reader = NULL;
  glark_stream_points read;
  glark_error error;
  FILE* file = fopen("stream_c.raw", "wb");
  int good;
  sphere_points(1000, points);
  if (file == NULL || fwrite(points, sizeof(float), 3000, file) != 3000 || fclose(file) != 0) return 1;
  if (glark_stream_open_points("stream_c.raw", NULL, &reader, &error) != GLARK_SUCCESS ||
      glark_stream_reader_read(reader, 2000, &read, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  good = read.positions.count == 3000 && read.positions.data[0] == points[0];
  glark_stream_reader_free(reader);
  remove("stream_c.raw");
  return good ? 0 : 1;
}
