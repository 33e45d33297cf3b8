// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of assembly vertex programs. Draws with them are only refined in the transparent
// manner, for applications that do not know the extension.
#include <array>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Returns whether the call has changed vertex programs that refined draws depend on.
bool follows(Context& c, GLenum target) {
  return track::executes(c) && target == GL_VERTEX_PROGRAM_ARB && c.options().transparent &&
         c.capabilities().refinable && c.capabilities().is_compatibility();
}

// The generated vertex stage gives what the fragment program reads.
void note_fragment_program(Context& c, GLenum target) {
  if (target == GL_FRAGMENT_PROGRAM_ARB) {
    c.changes().touch_fixed_function();
  }
}

void note_environment(Context& c, GLenum target, GLuint first, const GLfloat* values, GLsizei count = 1) {
  if (follows(c, target) && values != nullptr) {
    c.state().programs().assembly().set_environment(first, values, count);
  }
}

void note_local(Context& c, GLenum target, GLuint first, const GLfloat* values, GLsizei count = 1) {
  if (follows(c, target) && values != nullptr) {
    c.state().programs().assembly().set_local(first, values, count);
  }
}

ProgramParameters::Value to_floats(const GLdouble* v) {
  return {static_cast<GLfloat>(v[0]), static_cast<GLfloat>(v[1]), static_cast<GLfloat>(v[2]),
          static_cast<GLfloat>(v[3])};
}

}  // namespace

namespace hook {

void BindProgramARB(Context& c, GLenum target, GLuint program) {
  c.gl().BindProgramARB(target, program);
  note_fragment_program(c, target);
  if (follows(c, target)) {
    c.state().programs().assembly().bound(program);
  }
}

void DeleteProgramsARB(Context& c, GLsizei n, const GLuint* programs) {
  c.gl().DeleteProgramsARB(n, programs);
  note_fragment_program(c, GL_FRAGMENT_PROGRAM_ARB);  // one of them may be bound
  if (n > 0 && programs != nullptr) {
    c.state().programs().assembly().deleted({programs, static_cast<std::size_t>(n)});
  }
}

void ProgramStringARB(Context& c, GLenum target, GLenum format, GLsizei length, const void* string) {
  c.gl().ProgramStringARB(target, format, length, string);
  note_fragment_program(c, target);
  if (follows(c, target)) {
    c.state().programs().assembly().loaded();
  }
}

void NamedProgramStringEXT(Context& c, GLuint program, GLenum target, GLenum format, GLsizei length,
                           const void* string) {
  c.gl().NamedProgramStringEXT(program, target, format, length, string);
  note_fragment_program(c, target);
  if (follows(c, target)) {
    c.state().programs().assembly().loaded(program);
  }
}

void ProgramEnvParameter4fARB(Context& c, GLenum target, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  c.gl().ProgramEnvParameter4fARB(target, index, x, y, z, w);
  const std::array value{x, y, z, w};
  note_environment(c, target, index, value.data());
}

void ProgramEnvParameter4fvARB(Context& c, GLenum target, GLuint index, const GLfloat* values) {
  c.gl().ProgramEnvParameter4fvARB(target, index, values);
  note_environment(c, target, index, values);
}

void ProgramEnvParameter4dARB(Context& c, GLenum target, GLuint index, GLdouble x, GLdouble y, GLdouble z, GLdouble w) {
  c.gl().ProgramEnvParameter4dARB(target, index, x, y, z, w);
  const std::array value{x, y, z, w};
  note_environment(c, target, index, to_floats(value.data()).data());
}

void ProgramEnvParameter4dvARB(Context& c, GLenum target, GLuint index, const GLdouble* values) {
  c.gl().ProgramEnvParameter4dvARB(target, index, values);
  note_environment(c, target, index, to_floats(values).data());
}

void ProgramEnvParameters4fvEXT(Context& c, GLenum target, GLuint index, GLsizei count, const GLfloat* values) {
  c.gl().ProgramEnvParameters4fvEXT(target, index, count, values);
  note_environment(c, target, index, values, count);
}

void ProgramLocalParameter4fARB(Context& c, GLenum target, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  c.gl().ProgramLocalParameter4fARB(target, index, x, y, z, w);
  const std::array value{x, y, z, w};
  note_local(c, target, index, value.data());
}

void ProgramLocalParameter4fvARB(Context& c, GLenum target, GLuint index, const GLfloat* values) {
  c.gl().ProgramLocalParameter4fvARB(target, index, values);
  note_local(c, target, index, values);
}

void ProgramLocalParameter4dARB(Context& c, GLenum target, GLuint index, GLdouble x, GLdouble y, GLdouble z,
                                GLdouble w) {
  c.gl().ProgramLocalParameter4dARB(target, index, x, y, z, w);
  const std::array value{x, y, z, w};
  note_local(c, target, index, to_floats(value.data()).data());
}

void ProgramLocalParameter4dvARB(Context& c, GLenum target, GLuint index, const GLdouble* values) {
  c.gl().ProgramLocalParameter4dvARB(target, index, values);
  note_local(c, target, index, to_floats(values).data());
}

void ProgramLocalParameters4fvEXT(Context& c, GLenum target, GLuint index, GLsizei count, const GLfloat* values) {
  c.gl().ProgramLocalParameters4fvEXT(target, index, count, values);
  note_local(c, target, index, values, count);
}

}  // namespace hook
}  // namespace glark::core
