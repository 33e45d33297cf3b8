// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Links a program from a binary in a file, as toolkits and browsers do. If GL refuses the binary, links the shaders and
// writes the file. A client defines LOAD_BINARY and SAVE_BINARY, the functions ProgramBinary and GetProgramBinary.
#pragma once

#include <stdio.h>
#include <stdlib.h>

enum { most_binary_bytes = 1 << 20 };

static void link_from_cache(GLuint program) {
  static unsigned char binary[most_binary_bytes];
  const char* const path = getenv("PROGRAM_CACHE");
  require(path != NULL, "PROGRAM_CACHE names no file");
  GLenum format = 0;
  GLint linked = 0;
  FILE* file = fopen(path, "rb");
  if (file != NULL) {
    const size_t formats = fread(&format, sizeof(format), 1, file);
    const size_t bytes = fread(binary, 1, sizeof(binary), file);
    fclose(file);
    require(formats == 1 && bytes > 0, "the cache cannot be read");
    LOAD_BINARY(program, format, binary, (GLsizei)bytes);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
  }
  if (linked) return;
  glLinkProgram(program);
  GLsizei length = 0;
  SAVE_BINARY(program, sizeof(binary), &length, &format, binary);
  require(length > 0, "GL gives no binary");
  file = fopen(path, "wb");
  require(file != NULL && fwrite(&format, sizeof(format), 1, file) == 1, "the cache cannot be written");
  require(fwrite(binary, 1, (size_t)length, file) == (size_t)length && fclose(file) == 0, "the cache was not written");
}
