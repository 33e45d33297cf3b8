// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Texture coordinates, texture environments, fog and clip planes of the fixed function.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* textures = "textures of the fixed function";
constexpr const char* fog = "fog";

void toggle(World& w, GLenum capability, std::size_t one_in = 2) {
  if (w.values.below(one_in) != 0)
    gl.Enable(capability);
  else
    gl.Disable(capability);
}

void any_unit(World& w) { gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(w.values.below(2))); }
GLenum any_coordinate(World& w) { return w.values.pick<GLenum>({GL_S, GL_T, GL_S, GL_T, GL_R}); }

void tex_gen_mode(World& w) {
  any_unit(w);
  const GLenum coordinate = any_coordinate(w);
  const auto mode =
      w.values.pick<GLint>({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP});
  const GLint chosen = coordinate == GL_R && mode == GL_SPHERE_MAP ? GL_EYE_LINEAR : mode;
  switch (w.values.below(3)) {
    case 0: gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, chosen); break;
    case 1: gl.TexGenf(coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLfloat>(chosen)); break;
    default: gl.TexGend(coordinate, GL_TEXTURE_GEN_MODE, chosen); break;
  }
}

void tex_gen_plane(World& w) {
  any_unit(w);
  const GLenum coordinate = any_coordinate(w);
  const auto plane = w.values.pick<GLenum>({GL_OBJECT_PLANE, GL_EYE_PLANE});
  std::array<GLdouble, 4> values{};
  for (GLdouble& each : values) each = 0.4 * static_cast<double>(w.values.number());
  const std::array<GLfloat, 4> floats = {static_cast<GLfloat>(values[0]), static_cast<GLfloat>(values[1]),
                                         static_cast<GLfloat>(values[2]), static_cast<GLfloat>(values[3])};
  if (w.values.coin())
    gl.TexGendv(coordinate, plane, values.data());
  else
    gl.TexGenfv(coordinate, plane, floats.data());
}

void tex_env(World& w) {
  any_unit(w);
  const std::array<GLfloat, 4> colour = {w.values.fraction(), w.values.fraction(), w.values.fraction(), 1};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, colour.data());
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
             w.values.pick<GLint>({GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD}));
}

void fog_value(World& w) {
  switch (w.values.below(4)) {
    case 0: gl.Fogi(GL_FOG_MODE, w.values.pick<GLint>({GL_LINEAR, GL_EXP, GL_EXP2})); break;
    case 1: gl.Fogf(GL_FOG_DENSITY, w.values.pick({0.3F, 1.0F, 2.0F})); break;
    case 2:
      gl.Fogf(GL_FOG_START, w.values.pick({0.0F, -0.5F}));
      gl.Fogi(GL_FOG_END, w.values.pick({1, 2}));
      break;
    default: {
      const std::array<GLfloat, 4> colour = {w.values.fraction(), w.values.fraction(), w.values.fraction(), 1};
      gl.Fogfv(GL_FOG_COLOR, colour.data());
    }
  }
}

void clip_plane(World& w) {
  const GLenum plane = GL_CLIP_PLANE0 + static_cast<GLenum>(w.values.below(6));
  const std::array<GLdouble, 4> equation = {static_cast<double>(w.values.number()),
                                            static_cast<double>(w.values.number()), 0.1, 0.4};
  gl.ClipPlane(plane, equation.data());
  toggle(w, plane, 3);
}

}  // namespace

Rows fixed_texture_rows() {
  using enum Where;
  const auto row = [](const char* name, const char* family, void (*make)(World&)) {
    return Row{name, family, fixed, make, compat_only, 0, false, true};
  };
  return {
      row("Enable(TEXTURE_2D)", textures,
          [](World& w) {
            any_unit(w);
            toggle(w, GL_TEXTURE_2D, 5);
          }),
      row("TexGen mode", textures, tex_gen_mode),
      row("TexGen plane", textures, tex_gen_plane),
      row("Enable(TEXTURE_GEN)", textures,
          [](World& w) {
            any_unit(w);
            toggle(w, w.values.pick<GLenum>({GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R}), 3);
          }),
      row("TexEnv", textures, tex_env),
      row("ActiveTexture", textures, any_unit),
      row("Enable(FOG)", fog, [](World& w) { toggle(w, GL_FOG, 5); }),
      row("Fog", fog, fog_value),
      row("Fog coordinate source", fog,
          [](World& w) {
            gl.Fogi(GL_FOG_COORD_SRC, w.values.pick<GLint>({GL_FOG_COORD, GL_FRAGMENT_DEPTH}));
          }),
      row("ClipPlane", "clip planes", clip_plane),
  };
}

}  // namespace glark::conformance
