// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lights, materials and shading of the fixed function.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "lighting";

GLenum any_light(World& w) { return GL_LIGHT0 + static_cast<GLenum>(w.values.below(3)); }
GLenum any_face(World& w) { return w.values.pick<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK}); }

void toggle(World& w, GLenum capability, std::size_t one_in = 2) {
  if (w.values.below(one_in) != 0)
    gl.Enable(capability);
  else
    gl.Disable(capability);
}

std::array<GLfloat, 4> any_vector(World& w) {
  return {w.values.number(), w.values.number(), w.values.number(), w.values.number()};
}

void light_colour(World& w) {
  const GLenum light = any_light(w);
  const auto name = w.values.pick<GLenum>({GL_AMBIENT, GL_DIFFUSE, GL_DIFFUSE, GL_SPECULAR});
  if (w.values.coin()) return gl.Lightfv(light, name, any_vector(w).data());
  std::array<GLint, 4> integers{};
  for (GLint& each : integers) each = w.values.normalized<GLint>();
  gl.Lightiv(light, name, integers.data());
}

// No vertex has so great a z, so no light lies at a vertex. The first light may be a direction, the others attenuate. In a
// world of polygons, all are directions: their vertices have a w.
void light_position(World& w, GLenum light) {
  const bool is_direction = w.kind == WorldKind::polygons;
  const float last = is_direction         ? 0
                     : light == GL_LIGHT0 ? w.values.pick({0.0F, 0.0F, 1.0F})
                                          : w.values.pick({1.0F, 2.0F, 0.5F, -1.0F});
  const std::array<GLfloat, 4> position = {w.values.number(), w.values.number(), w.values.pick({5.3F, -6.1F, 9.7F}),
                                           last};
  if (w.values.coin()) return gl.Lightfv(light, GL_POSITION, position.data());
  std::array<GLint, 4> integers{};
  for (std::size_t i = 0; i < 4; ++i) integers[i] = static_cast<GLint>(position[i]);
  integers[3] = last == 0.5F ? 1 : integers[3];
  gl.Lightiv(light, GL_POSITION, integers.data());
}

void attenuation(World& w) {
  const GLenum light = any_light(w);
  gl.Lightf(light, GL_CONSTANT_ATTENUATION, w.values.pick({1.0F, 0.5F, 2.0F}));
  gl.Lightf(light, GL_LINEAR_ATTENUATION, w.values.pick({0.0F, 0.1F, 0.3F}));
  gl.Lightf(light, GL_QUADRATIC_ATTENUATION, w.values.pick({0.0F, 0.0F, 0.02F}));
}

void light_model(World& w) {
  switch (w.values.below(4)) {
    case 0: gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, any_vector(w).data()); break;
    case 1: gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, w.kind == WorldKind::fixed ? w.values.between(0, 1) : 0); break;
    case 2: gl.LightModelf(GL_LIGHT_MODEL_TWO_SIDE, static_cast<GLfloat>(w.values.between(0, 1))); break;
    default:
      gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, w.values.pick<GLint>({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}));
      break;
  }
}

void material(World& w) {
  const GLenum face = any_face(w);
  const auto name = w.values.pick<GLenum>({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE});
  if (w.values.below(3) != 0) return gl.Materialfv(face, name, any_vector(w).data());
  std::array<GLint, 4> integers{};
  for (GLint& each : integers) each = w.values.normalized<GLint>();
  gl.Materialiv(face, name, integers.data());
}

// Not 0: what 0 to the power of 0 is differs from GL to GL. Nor are they great: normals may be long, so that the power is
// infinite, and 0 times that is not a number.
void shininess(World& w) {
  const GLenum face = any_face(w);
  if (w.values.coin()) return gl.Materialf(face, GL_SHININESS, w.values.pick({0.5F, 1.0F, 2.5F, 4.0F}));
  gl.Materiali(face, GL_SHININESS, w.values.pick({1, 2, 3}));
}

// Not of back faces alone: in Mesa, a two-sided light then loses their colour (fault `color_of_back` of tests/drivers).
void color_material(World& w) {
  const auto face = w.values.pick<GLenum>({GL_FRONT, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK});
  gl.ColorMaterial(face,
                   w.values.pick<GLenum>({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE}));
  toggle(w, GL_COLOR_MATERIAL, 4);
}

}  // namespace

Rows light_rows() {
  using enum Where;
  // There are no cones, and materials are not changed between Begin and End: there pictures of Mesa and of refined draws differ at times.
  const auto row = [](const char* name, void (*make)(World&)) {
    return Row{name, family, fixed, make, compat_only, 0, false, true};
  };
  return {
      row("Light colours", light_colour),
      row("Light position", [](World& w) { light_position(w, any_light(w)); }),
      row("Light attenuation", attenuation),
      row("LightModel", light_model),
      row("Material", material),
      row("Material shininess", shininess),
      row("ColorMaterial", color_material),
      row("Enable(LIGHTING)", [](World& w) { toggle(w, GL_LIGHTING, 6); }),
      row("Enable(LIGHTi)", [](World& w) { toggle(w, any_light(w), 4); }),
      row("Enable(NORMALIZE)", [](World& w) { toggle(w, GL_NORMALIZE); }),
      row("Enable(RESCALE_NORMAL)", [](World& w) { toggle(w, GL_RESCALE_NORMAL); }),
      row("ShadeModel",
          [](World& w) {
            gl.ShadeModel(w.values.pick<GLenum>({GL_FLAT, GL_SMOOTH, GL_SMOOTH}));
          }),
      row("Enable(COLOR_SUM)", [](World& w) { toggle(w, GL_COLOR_SUM); }),
      row("ClampColor",
          [](World& w) {
            gl.ClampColor(GL_CLAMP_VERTEX_COLOR, w.values.pick<GLenum>({GL_TRUE, GL_FALSE}));
          }),
  };
}

}  // namespace glark::conformance
