// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Matrices of the fixed function. The modelview matrix keeps the vertices near the view volume.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "matrices";

// About the identity times 1/8 for positions, about the identity for the others; at times mirrored.
template <typename T>
std::array<T, 16> any_matrix(World& w) {
  std::array<T, 16> matrix{};
  GLint mode = 0;
  gl.GetIntegerv(GL_MATRIX_MODE, &mode);
  const double scale = mode == GL_MODELVIEW ? 0.125 : 1;
  for (std::size_t i = 0; i < 16; ++i) {
    const bool is_diagonal = i % 5 == 0;
    const bool is_last_row = i % 4 == 3;
    const double value =
        (is_diagonal ? w.values.pick({1.0, 1.0, -1.0, 0.7}) : 0.15 * static_cast<double>(w.values.number())) * scale;
    matrix[i] = static_cast<T>(i == 15 ? 1.0 : is_last_row ? (mode == GL_PROJECTION ? value / 2 : 0.0) : value);
  }
  return matrix;
}

template <auto Command, typename T>
void load(World& w) {
  const std::array<T, 16> matrix = any_matrix<T>(w);
  (gl.*Command)(matrix.data());
}

// A transposed one: the last row is then the last column.
template <auto Command, typename T>
void load_transposed(World& w) {
  const std::array<T, 16> matrix = any_matrix<T>(w);
  std::array<T, 16> transposed{};
  for (std::size_t i = 0; i < 16; ++i) transposed[i] = matrix[i % 4 * 4 + i / 4];
  (gl.*Command)(transposed.data());
}

template <typename T>
std::array<T, 16> near_identity(World& w) {
  std::array<T, 16> matrix{};
  for (std::size_t i = 0; i < 16; ++i)
    matrix[i] = static_cast<T>(i % 5 == 0   ? w.values.pick({1.0, 1.0, -1.0, 0.9})
                               : i % 4 == 3 ? 0
                                            : 0.1 * static_cast<double>(w.values.number()));
  matrix[15] = 1;
  return matrix;
}

template <auto Command, typename T>
void multiply(World& w) {
  const std::array<T, 16> matrix = near_identity<T>(w);
  (gl.*Command)(matrix.data());
}

template <auto Command, typename T>
void rotate(World& w) {
  (gl.*Command)(static_cast<T>(w.values.pick({30, -45, 180, 7})), static_cast<T>(w.values.between(0, 1)),
                static_cast<T>(w.values.between(-1, 1)), static_cast<T>(1));
}

template <auto Command, typename T>
void scale(World& w) {
  (gl.*Command)(static_cast<T>(w.values.pick({1.0, -1.0, 0.8})), static_cast<T>(w.values.pick({1.0, 1.1, -1.0})),
                static_cast<T>(w.values.pick({1.0, 0.5, -1.0})));
}

template <auto Command, typename T>
void translate(World& w) {
  (gl.*Command)(static_cast<T>(w.values.number()), static_cast<T>(w.values.number()),
                static_cast<T>(w.values.number() / 4));
}

void matrix_mode(World& w) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(w.values.below(2)));
  gl.MatrixMode(w.values.pick<GLenum>({GL_MODELVIEW, GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
}

// Back to the places from -8 to 8, so that not everything leaves the view.
void load_initial(World&) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Scalef(0.125F, 0.125F, 0.125F);
}

}  // namespace

Rows matrix_rows() {
  using enum Where;
  using G = GladGLContext;
  const auto row = [](const char* name, void (*make)(World&)) { return Row{name, family, fixed, make, compat_only}; };
  // Executed twice, these do the same as once.
  const auto listed = [](const char* name, void (*make)(World&)) {
    return Row{name, family, fixed, make, compat_only, 0, true, true};
  };
  return {
      listed("MatrixMode", matrix_mode),
      listed("LoadIdentity", load_initial),
      listed("LoadMatrixf", load<&G::LoadMatrixf, GLfloat>),
      listed("LoadMatrixd", load<&G::LoadMatrixd, GLdouble>),
      listed("LoadTransposeMatrixf", load_transposed<&G::LoadTransposeMatrixf, GLfloat>),
      listed("LoadTransposeMatrixd", load_transposed<&G::LoadTransposeMatrixd, GLdouble>),
      row("MultMatrixf", multiply<&G::MultMatrixf, GLfloat>),
      row("MultMatrixd", multiply<&G::MultMatrixd, GLdouble>),
      row("Rotatef", rotate<&G::Rotatef, GLfloat>),
      row("Rotated", rotate<&G::Rotated, GLdouble>),
      row("Scalef", scale<&G::Scalef, GLfloat>),
      row("Scaled", scale<&G::Scaled, GLdouble>),
      row("Translatef", translate<&G::Translatef, GLfloat>),
      row("Translated", translate<&G::Translated, GLdouble>),
      row("PushMatrix", [](World&) { gl.PushMatrix(); }),
      row("PopMatrix", [](World&) { gl.PopMatrix(); }),
  };
}

}  // namespace glark::conformance
