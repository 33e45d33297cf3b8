// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every client program reads its arguments and writes its last frame in this way.
#pragma once

#include <stdio.h>
#include <stdlib.h>

enum { picture_size = 256 };

// usage: CLIENT FRAMES OUT.ppm
static inline int frame_count(int argc, char** argv) {
  const int frames = argc == 3 ? atoi(argv[1]) : 0;
  if (frames <= 0) {
    fprintf(stderr, "usage: %s FRAMES OUT.ppm\n", argv[0]);
    exit(2);
  }
  return frames;
}

static inline void require(int condition, const char* what) {
  if (condition) return;
  fprintf(stderr, "client: %s\n", what);
  exit(1);
}

// `pixels`: picture_size rows of RGBA bytes, the lowest first, as glReadPixels gives them.
static inline int write_picture(const char* path, const unsigned char* pixels) {
  FILE* file = fopen(path, "wb");
  require(file != NULL, "cannot write the picture");
  fprintf(file, "P6\n%d %d\n255\n", picture_size, picture_size);
  for (int y = picture_size - 1; y >= 0; --y) {
    for (int x = 0; x < picture_size; ++x) fwrite(pixels + 4 * (y * picture_size + x), 1, 3, file);
  }
  return fclose(file);
}
