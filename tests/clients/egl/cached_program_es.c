// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The OpenGL ES client with its program in a cache, by OES_get_program_binary.
static void link_from_cache(unsigned program);
#define SCENE_LINK link_from_cache
#include "gles2.c"  // NOLINT(bugprone-suspicious-include): the same client with another way to link

#include <GLES2/gl2ext.h>

static void program_binary(GLuint program, GLenum format, const void* binary, GLint length) {
  ((PFNGLPROGRAMBINARYOESPROC)eglGetProcAddress("glProgramBinaryOES"))(program, format, binary, length);
}
static void get_program_binary(GLuint program, GLsizei size, GLsizei* length, GLenum* format, void* binary) {
  ((PFNGLGETPROGRAMBINARYOESPROC)eglGetProcAddress("glGetProgramBinaryOES"))(program, size, length, format, binary);
}
#define LOAD_BINARY program_binary
#define SAVE_BINARY get_program_binary
#include "program_cache.h"
