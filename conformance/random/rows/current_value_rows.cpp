// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Current values: every command that sets one, with all of its types and numbers of components.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "current values";

// The depth tags are a generic attribute, too.
GLuint any_generic(World& w) {
  GLint tag = 15;
  if (w.values.below(8) == 0) gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &tag);
  return w.values.below(8) == 0 ? static_cast<GLuint>(tag) : w.any_float_attribute();
}

template <auto Command, Scale scale = Scale::plain>
void generic(World& w) {
  call<Command, scale>(w, any_generic(w));
}
template <auto Command>
void integers(World& w) {
  call<Command>(w, at_integers);
}
// Mesa leaves the components that a command does not set as they were, and which draw sees which is not certain.
template <auto Command>
void doubles(World& w) {
  gl.VertexAttribL4d(at_doubles, 0, 0, 0, 1);
  call<Command>(w, at_doubles);
}
template <auto Command, Scale scale = Scale::plain>
void value(World& w) {
  call<Command, scale>(w);
}
// Not negative: Mesa's fixed function takes the absolute value, which OpenGL does not say.
template <auto Command>
void fog(World& w) {
  using Argument = std::tuple_element_t<0, typename CommandArguments<Command>::Types>;
  using Number = std::remove_const_t<std::remove_pointer_t<Argument>>;
  const auto number = static_cast<Number>(2 * w.values.fraction());
  if constexpr (std::is_pointer_v<Argument>)
    (gl.*Command)(&number);
  else
    (gl.*Command)(number);
}
template <auto Command>
void coordinates(World& w) {
  call<Command>(w, GL_TEXTURE0 + static_cast<GLenum>(w.values.below(2)));
}

#define GLARK_GENERIC(command) \
  { #command, family, stage, generic < &GladGLContext::command>, every_api }
#define GLARK_DESKTOP(command) \
  { #command, family, stage, generic < &GladGLContext::command>, desktop_apis }
#define GLARK_NORMALIZED(command) \
  { #command, family, stage, generic < &GladGLContext::command, Scale::normalized>, desktop_apis }
#define GLARK_INTEGERS(command, apis) \
  { #command, family, stage, integers < &GladGLContext::command>, apis }
#define GLARK_DOUBLES(command) \
  { #command, family, stage, doubles < &GladGLContext::command>, desktop_apis }

Rows generic_rows() {
  using enum Where;
  return {
      GLARK_GENERIC(VertexAttrib1f),
      GLARK_GENERIC(VertexAttrib2f),
      GLARK_GENERIC(VertexAttrib3f),
      GLARK_GENERIC(VertexAttrib4f),
      GLARK_GENERIC(VertexAttrib1fv),
      GLARK_GENERIC(VertexAttrib2fv),
      GLARK_GENERIC(VertexAttrib3fv),
      GLARK_GENERIC(VertexAttrib4fv),
      GLARK_DESKTOP(VertexAttrib1d),
      GLARK_DESKTOP(VertexAttrib2d),
      GLARK_DESKTOP(VertexAttrib3d),
      GLARK_DESKTOP(VertexAttrib4d),
      GLARK_DESKTOP(VertexAttrib1dv),
      GLARK_DESKTOP(VertexAttrib2dv),
      GLARK_DESKTOP(VertexAttrib3dv),
      GLARK_DESKTOP(VertexAttrib4dv),
      GLARK_DESKTOP(VertexAttrib1s),
      GLARK_DESKTOP(VertexAttrib2s),
      GLARK_DESKTOP(VertexAttrib3s),
      GLARK_DESKTOP(VertexAttrib4s),
      GLARK_DESKTOP(VertexAttrib1sv),
      GLARK_DESKTOP(VertexAttrib2sv),
      GLARK_DESKTOP(VertexAttrib3sv),
      GLARK_DESKTOP(VertexAttrib4sv),
      GLARK_DESKTOP(VertexAttrib4bv),
      GLARK_DESKTOP(VertexAttrib4iv),
      GLARK_DESKTOP(VertexAttrib4ubv),
      GLARK_DESKTOP(VertexAttrib4usv),
      GLARK_DESKTOP(VertexAttrib4uiv),
      GLARK_NORMALIZED(VertexAttrib4Nub),
      GLARK_NORMALIZED(VertexAttrib4Nbv),
      GLARK_NORMALIZED(VertexAttrib4Nsv),
      GLARK_NORMALIZED(VertexAttrib4Niv),
      GLARK_NORMALIZED(VertexAttrib4Nubv),
      GLARK_NORMALIZED(VertexAttrib4Nusv),
      GLARK_NORMALIZED(VertexAttrib4Nuiv),
      GLARK_INTEGERS(VertexAttribI1i, desktop_apis),
      GLARK_INTEGERS(VertexAttribI2i, desktop_apis),
      GLARK_INTEGERS(VertexAttribI3i, desktop_apis),
      GLARK_INTEGERS(VertexAttribI4i, every_api),
      GLARK_INTEGERS(VertexAttribI1iv, desktop_apis),
      GLARK_INTEGERS(VertexAttribI2iv, desktop_apis),
      GLARK_INTEGERS(VertexAttribI3iv, desktop_apis),
      GLARK_INTEGERS(VertexAttribI4iv, every_api),
      GLARK_INTEGERS(VertexAttribI4bv, desktop_apis),
      GLARK_INTEGERS(VertexAttribI4sv, desktop_apis),
      GLARK_DOUBLES(VertexAttribL1d),
      GLARK_DOUBLES(VertexAttribL2d),
      GLARK_DOUBLES(VertexAttribL3d),
      GLARK_DOUBLES(VertexAttribL4d),
      GLARK_DOUBLES(VertexAttribL1dv),
      GLARK_DOUBLES(VertexAttribL2dv),
      GLARK_DOUBLES(VertexAttribL3dv),
      GLARK_DOUBLES(VertexAttribL4dv),
      {"VertexAttribP4ui", family, stage,
       [](World& w) {
         gl.VertexAttribP4ui(w.any_float_attribute(), GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, w.values.seed());
       },
       desktop_apis},
  };
}
#undef GLARK_GENERIC
#undef GLARK_DESKTOP
#undef GLARK_NORMALIZED
#undef GLARK_INTEGERS
#undef GLARK_DOUBLES

// These may also be called between Begin and End, and are compiled into lists.
#define GLARK_VALUE(command, scale) \
  { #command, family, within_begin, value < &GladGLContext::command, Scale::scale>, compat_only, 0, true, true }
#define GLARK_FOG(command) \
  { #command, family, within_begin, fog < &GladGLContext::command>, compat_only, 0, true, true }
#define GLARK_COORDINATES(command) \
  { #command, family, within_begin, coordinates < &GladGLContext::command>, compat_only, 0, true, true }

Rows colour_rows() {
  using enum Where;
  return {
      GLARK_VALUE(Color3b, normalized),           GLARK_VALUE(Color3s, normalized),
      GLARK_VALUE(Color3i, normalized),           GLARK_VALUE(Color3f, normalized),
      GLARK_VALUE(Color3d, normalized),           GLARK_VALUE(Color3ub, normalized),
      GLARK_VALUE(Color3us, normalized),          GLARK_VALUE(Color3ui, normalized),
      GLARK_VALUE(Color4b, normalized),           GLARK_VALUE(Color4s, normalized),
      GLARK_VALUE(Color4i, normalized),           GLARK_VALUE(Color4f, normalized),
      GLARK_VALUE(Color4d, normalized),           GLARK_VALUE(Color4ub, normalized),
      GLARK_VALUE(Color4us, normalized),          GLARK_VALUE(Color4ui, normalized),
      GLARK_VALUE(Color3bv, normalized),          GLARK_VALUE(Color3sv, normalized),
      GLARK_VALUE(Color3iv, normalized),          GLARK_VALUE(Color3fv, normalized),
      GLARK_VALUE(Color3dv, normalized),          GLARK_VALUE(Color3ubv, normalized),
      GLARK_VALUE(Color3usv, normalized),         GLARK_VALUE(Color3uiv, normalized),
      GLARK_VALUE(Color4bv, normalized),          GLARK_VALUE(Color4sv, normalized),
      GLARK_VALUE(Color4iv, normalized),          GLARK_VALUE(Color4fv, normalized),
      GLARK_VALUE(Color4dv, normalized),          GLARK_VALUE(Color4ubv, normalized),
      GLARK_VALUE(Color4usv, normalized),         GLARK_VALUE(Color4uiv, normalized),
      GLARK_VALUE(SecondaryColor3b, normalized),  GLARK_VALUE(SecondaryColor3s, normalized),
      GLARK_VALUE(SecondaryColor3f, normalized),  GLARK_VALUE(SecondaryColor3d, normalized),
      GLARK_VALUE(SecondaryColor3ub, normalized), GLARK_VALUE(SecondaryColor3fv, normalized),
      GLARK_VALUE(SecondaryColor3iv, normalized), GLARK_VALUE(SecondaryColor3usv, normalized),
  };
}

Rows vertex_value_rows() {
  using enum Where;
  return {
      GLARK_VALUE(Normal3b, normalized),
      GLARK_VALUE(Normal3s, normalized),
      GLARK_VALUE(Normal3i, normalized),
      GLARK_VALUE(Normal3f, normalized),
      GLARK_VALUE(Normal3d, normalized),
      GLARK_VALUE(Normal3bv, normalized),
      GLARK_VALUE(Normal3sv, normalized),
      GLARK_VALUE(Normal3iv, normalized),
      GLARK_VALUE(Normal3fv, normalized),
      GLARK_VALUE(Normal3dv, normalized),
      GLARK_FOG(FogCoordf),
      GLARK_FOG(FogCoordd),
      GLARK_FOG(FogCoordfv),
      GLARK_FOG(FogCoorddv),
      GLARK_VALUE(TexCoord1f, plain),
      GLARK_VALUE(TexCoord2f, plain),
      GLARK_VALUE(TexCoord1s, plain),
      GLARK_VALUE(TexCoord2s, plain),
      GLARK_VALUE(TexCoord1d, plain),
      GLARK_VALUE(TexCoord2d, plain),
      GLARK_VALUE(TexCoord1i, plain),
      GLARK_VALUE(TexCoord2i, plain),
      GLARK_VALUE(TexCoord2fv, plain),
      GLARK_VALUE(TexCoord2iv, plain),
      GLARK_VALUE(TexCoord2sv, plain),
      GLARK_COORDINATES(MultiTexCoord1f),
      GLARK_COORDINATES(MultiTexCoord2f),
      GLARK_COORDINATES(MultiTexCoord1d),
      GLARK_COORDINATES(MultiTexCoord2d),
      GLARK_COORDINATES(MultiTexCoord1i),
      GLARK_COORDINATES(MultiTexCoord2i),
      GLARK_COORDINATES(MultiTexCoord2s),
      GLARK_COORDINATES(MultiTexCoord2fv),
      GLARK_COORDINATES(MultiTexCoord2dv),
      GLARK_COORDINATES(MultiTexCoord2iv),
      GLARK_COORDINATES(MultiTexCoord2sv),
      {"EdgeFlag", family, within_begin, [](World& w) { gl.EdgeFlag(static_cast<GLboolean>(w.values.coin())); },
       compat_only, 0, true, true},
  };
}
#undef GLARK_VALUE
#undef GLARK_FOG
#undef GLARK_COORDINATES

}  // namespace

Rows current_value_rows() {
  Rows all = generic_rows();
  for (const Rows& each : {colour_rows(), vertex_value_rows()}) all.insert(all.end(), each.begin(), each.end());
  return all;
}

}  // namespace glark::conformance
