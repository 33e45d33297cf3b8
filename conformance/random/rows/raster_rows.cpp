// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// State behind the vertex stage. A draw has to obey it and to leave it alone. Only state that does not depend on the
// order of overlapping triangles is here.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "rasterization";

GLboolean mostly(World& w) { return static_cast<GLboolean>(w.values.below(4) != 0); }

void switch_state(World& w, GLenum capability) {
  if (w.values.coin())
    gl.Enable(capability);
  else
    gl.Disable(capability);
}

void viewport(World& w) {
  if (w.values.coin()) return gl.Viewport(0, 0, surface_size, surface_size);
  gl.Viewport(w.values.between(-20, 20), w.values.between(-20, 20), w.values.between(80, 160),
              w.values.between(80, 160));
}

void viewport_indexed(World& w) {
  const std::array<GLfloat, 4> v = {w.values.number() * 8, 0, 128, 100};
  if (w.values.coin())
    gl.ViewportIndexedf(0, v[0], v[1], v[2], v[3]);
  else
    gl.ViewportArrayv(0, 1, v.data());
}

void scissor(World& w) {
  switch_state(w, GL_SCISSOR_TEST);
  gl.Scissor(w.values.between(0, 60), w.values.between(0, 60), w.values.between(40, 128), w.values.between(40, 128));
}

void blend(World& w) {
  const auto equation = w.values.pick<GLenum>({GL_MAX, GL_MAX, GL_MIN, GL_FUNC_ADD});
  gl.BlendEquation(equation);
  gl.BlendFunc(GL_ONE, GL_ONE);
}

void stencil(World& w) {
  switch_state(w, GL_STENCIL_TEST);
  gl.StencilFunc(w.values.pick<GLenum>({GL_ALWAYS, GL_EQUAL, GL_LESS}), w.values.between(0, 2), 255);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

void cull(World& w) {
  switch_state(w, GL_CULL_FACE);
  gl.CullFace(w.values.pick<GLenum>({GL_FRONT, GL_BACK, GL_BACK}));
}

void conditional_state(World& w) { gl.DepthMask(mostly(w)); }

// Only the values for which PrimitiveRestart leaves indices in range.
void restart(World& w) {
  switch_state(w, GL_PRIMITIVE_RESTART);
  gl.PrimitiveRestartIndex(w.values.coin() ? static_cast<GLuint>(w.values.between(0, 20)) : 255);
}

}  // namespace

Rows raster_rows() {
  using enum Where;
  return {
      {"Viewport", family, everywhere, viewport},
      {"ViewportIndexedf", family, everywhere, viewport_indexed, desktop_apis},
      {"DepthRangef", family, everywhere,
       [](World& w) {
         const float nearest = w.values.fraction();
         gl.DepthRangef(nearest, w.values.fraction());
       },
       every_api},
      {"Scissor", family, everywhere, scissor},
      {"BlendEquation", family, everywhere, blend},
      {"StencilFunc", family, everywhere, stencil},
      {"CullFace", family, everywhere, cull},
      {"FrontFace", family, everywhere,
       [](World& w) {
         gl.FrontFace(w.values.pick<GLenum>({GL_CW, GL_CCW}));
       }},
      {"ColorMask", family, everywhere,
       [](World& w) {
         const GLboolean red = mostly(w);
         const GLboolean green = mostly(w);
         gl.ColorMask(red, green, mostly(w), GL_TRUE);
       }},
      {"DepthMask", family, everywhere, conditional_state},
      {"DepthFunc", family, everywhere,
       [](World& w) {
         switch_state(w, GL_DEPTH_TEST);
         gl.DepthFunc(w.values.pick<GLenum>({GL_ALWAYS, GL_ALWAYS, GL_NEVER}));
       }},
      {"PolygonOffset", family, everywhere,
       [](World& w) {
         switch_state(w, GL_POLYGON_OFFSET_FILL);
         gl.PolygonOffset(w.values.number(), w.values.number());
       }},
      {"RASTERIZER_DISCARD", family, everywhere,
       [](World& w) {
         if (w.values.below(5) == 0)
           gl.Enable(GL_RASTERIZER_DISCARD);
         else
           gl.Disable(GL_RASTERIZER_DISCARD);
       }},
      {"PrimitiveRestartIndex", family, shader, restart, desktop_apis},
      {"PRIMITIVE_RESTART_FIXED_INDEX", family, shader,
       [](World& w) { switch_state(w, GL_PRIMITIVE_RESTART_FIXED_INDEX); }},
      {"ProvokingVertex", family, everywhere,
       [](World& w) {
         gl.ProvokingVertex(w.values.pick<GLenum>({GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION}));
       },
       desktop_apis},
      {"BeginQuery", family, everywhere,  // an occlusion query does not disturb draws
       [](World&) {
         GLuint query = 0;
         gl.GenQueries(1, &query);
         gl.BeginQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, query);
         gl.EndQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
         gl.DeleteQueries(1, &query);
       }},
      {"PushAttrib", "attribute stacks", everywhere,
       [](World& w) {
         gl.PushAttrib(
             w.values.pick<GLbitfield>({GL_ALL_ATTRIB_BITS, GL_CURRENT_BIT, GL_LIGHTING_BIT | GL_TRANSFORM_BIT,
                                        GL_ENABLE_BIT, GL_TEXTURE_BIT, GL_FOG_BIT | GL_POLYGON_BIT}));
       },
       compat_only},
      {"PopAttrib", "attribute stacks", everywhere, [](World&) { gl.PopAttrib(); }, compat_only},
      {"PushClientAttrib", "attribute stacks", everywhere,
       [](World& w) {
         gl.PushClientAttrib(w.values.pick<GLbitfield>({GL_CLIENT_VERTEX_ARRAY_BIT, GL_CLIENT_ALL_ATTRIB_BITS}));
       },
       compat_only},
      {"PopClientAttrib", "attribute stacks", everywhere, [](World&) { gl.PopClientAttrib(); }, compat_only},
  };
}

}  // namespace glark::conformance
