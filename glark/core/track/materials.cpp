// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glMaterial. Between glBegin and glEnd, each vertex of the fixed function has its own material. A vertex program
// sees the material from before glBegin.
#include <cstring>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// The number of values of a material parameter; 1 for names that GL refuses.
std::size_t values_of(GLenum name) {
  switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE: return 4;
    case GL_COLOR_INDEXES: return 3;
    default: return 1;
  }
}

template <typename Value>
DeferredMaterial change_of(GLenum face, GLenum name, const Value* values, std::size_t count,
                           void (*call)(const gl::Dispatch&, const DeferredMaterial&)) {
  DeferredMaterial change{.call = call, .face = face, .name = name};
  std::memcpy(change.words.data(), values, count * sizeof(Value));
  return change;
}

template <typename Value>
std::array<Value, 4> values_in(const DeferredMaterial& change) {
  std::array<Value, 4> values{};
  std::memcpy(values.data(), change.words.data(), sizeof(values));
  return values;
}

}  // namespace

namespace hook {

void Materialf(Context& c, GLenum face, GLenum name, GLfloat value) {
  track::change_material(c,
                         change_of(face, name, &value, 1, [](const gl::Dispatch& gl, const DeferredMaterial& change) {
                           gl.Materialf(change.face, change.name, values_in<GLfloat>(change)[0]);
                         }));
}

void Materiali(Context& c, GLenum face, GLenum name, GLint value) {
  track::change_material(c,
                         change_of(face, name, &value, 1, [](const gl::Dispatch& gl, const DeferredMaterial& change) {
                           gl.Materiali(change.face, change.name, values_in<GLint>(change)[0]);
                         }));
}

void Materialfv(Context& c, GLenum face, GLenum name, const GLfloat* values) {
  track::change_material(
      c, change_of(face, name, values, values_of(name), [](const gl::Dispatch& gl, const DeferredMaterial& change) {
        gl.Materialfv(change.face, change.name, values_in<GLfloat>(change).data());
      }));
}

void Materialiv(Context& c, GLenum face, GLenum name, const GLint* values) {
  track::change_material(
      c, change_of(face, name, values, values_of(name), [](const gl::Dispatch& gl, const DeferredMaterial& change) {
        gl.Materialiv(change.face, change.name, values_in<GLint>(change).data());
      }));
}

}  // namespace hook
}  // namespace glark::core
