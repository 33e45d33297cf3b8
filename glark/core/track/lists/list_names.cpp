// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/track/lists/list_names.h"

namespace glark::core::track {
namespace {

template <typename Name>
GLuint integer_at(const void* lists, GLsizei i) {
  return static_cast<GLuint>(static_cast<GLint>(static_cast<const Name*>(lists)[i]));
}

// OpenGL 4.6 compatibility, 21.4: the names of GL_2_BYTES, GL_3_BYTES and GL_4_BYTES are big-endian groups of bytes.
GLuint group_at(const void* lists, GLsizei i, GLsizei size) {
  const auto* bytes = static_cast<const GLubyte*>(lists);
  GLuint value = 0;
  for (GLsizei k = 0; k < size; ++k) {
    value = value << 8 | bytes[i * size + k];
  }
  return value;
}

}  // namespace

bool is_name_type(GLenum type) { return type >= GL_BYTE && type <= GL_4_BYTES; }

GLuint name_at(GLenum type, const void* lists, GLsizei i) {
  switch (type) {
    case GL_BYTE: return integer_at<GLbyte>(lists, i);
    case GL_UNSIGNED_BYTE: return static_cast<const GLubyte*>(lists)[i];
    case GL_SHORT: return integer_at<GLshort>(lists, i);
    case GL_UNSIGNED_SHORT: return static_cast<const GLushort*>(lists)[i];
    case GL_INT: return integer_at<GLint>(lists, i);
    case GL_UNSIGNED_INT: return static_cast<const GLuint*>(lists)[i];
    case GL_FLOAT: return integer_at<GLfloat>(lists, i);
    case GL_2_BYTES: return group_at(lists, i, 2);
    case GL_3_BYTES: return group_at(lists, i, 3);
    default: return group_at(lists, i, 4);
  }
}

}  // namespace glark::core::track
