// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glEnable and of modes.
#include <algorithm>
#include <array>

#include "glark/core/track/complain.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

void set_ark_enabled(Context& c, bool enabled) {
  if (track::inside_begin(c, enabled ? "glEnable(GL_ARK)" : "glDisable(GL_ARK)")) {
    return;
  }
  if (enabled && c.ark().pool_level < 0) {
    track::complain(c, GL_INVALID_OPERATION, "glEnable(GL_ARK)", "there are no patterns yet; call glARKinit first");
    return;
  }
  c.ark().enabled = enabled;
  c.update_refining();
}

// The slot of an array that glEnableClientState names; no_slot for arrays that are not followed.
int slot_of(const Context& c, GLenum array) {
  switch (array) {
    case GL_VERTEX_ARRAY: return vertex_slot;
    case GL_NORMAL_ARRAY: return normal_slot;
    case GL_COLOR_ARRAY: return color_slot;
    case GL_TEXTURE_COORD_ARRAY: return texture_slot(c.state().arrays().client_texture());
    default: return no_slot;
  }
}

void client_state_changed(Context& c, GLenum array, bool enabled) {
  const int slot = c.refining() && !c.state().immediate().open() ? slot_of(c, array) : no_slot;
  if (slot == no_slot) {
    c.state().arrays().vertex_arrays().forget_current();
    return;
  }
  c.state()
      .arrays()
      .vertex_arrays()
      .change(c.state().bindings().vertex_array)
      .sources[static_cast<std::size_t>(slot)]
      .enabled = enabled;
}

// A call replaced the vertex arrays and the buffer bindings.
void client_state_replaced(Context& c) {
  c.state().forget_bindings();
  c.state().arrays().bound_buffers().forget();
  c.state().arrays().vertex_arrays().forget_all();
  c.state().arrays().set_client_texture(0);
  if (c.capabilities().refinable && !c.state().immediate().open()) {
    c.state().arrays().read_client_state();
  }
}

void set_tag_array(Context& c, bool enabled) {
  if (track::inside_begin(c, "glEnable(GL_DEPTH_TAG_ARRAY_ARK)")) {
    return;
  }
  c.state().arrays().vertex_arrays().forget_current();
  if (enabled) {
    c.gl().EnableVertexAttribArray(c.ark().tag_attribute);
  } else {
    c.gl().DisableVertexAttribArray(c.ark().tag_attribute);
  }
}

// Names other than those of clip distances are left out.
void note_clip_distance(Context& c, GLenum capability, bool enabled) {
  const GLenum number = capability - GL_CLIP_DISTANCE0;
  if (capability < GL_CLIP_DISTANCE0 || number >= clip_distance_count ||
      c.capabilities().api == Capabilities::Api::es) {
    return;
  }
  std::uint8_t& bits = c.state().bindings().clip_distances;
  const auto bit = static_cast<std::uint8_t>(1U << number);
  bits = static_cast<std::uint8_t>(enabled ? bits | bit : bits & ~bit);
}

// Notes the enables that refined draws depend on. All others can only change the generated vertex stage.
void set_capability(Context& c, GLenum capability, bool enabled) {
  Bindings& b = c.state().bindings();
  switch (capability) {
    case GL_DEBUG_OUTPUT: b.debug_output = enabled; break;
    case GL_RASTERIZER_DISCARD: b.rasterizer_discard = enabled; break;
    case GL_PRIMITIVE_RESTART: b.primitive_restart = enabled; break;
    case GL_PRIMITIVE_RESTART_FIXED_INDEX: b.primitive_restart_fixed = enabled; break;
    case GL_VERTEX_PROGRAM_ARB: b.vertex_program = enabled; break;
    case GL_VERTEX_PROGRAM_TWO_SIDE: b.two_side = enabled; break;
    case GL_BLEND: b.blend = enabled; break;
    case GL_DEPTH_TEST: b.depth_test = enabled; break;
    case GL_STENCIL_TEST: b.stencil_test = enabled; break;
    case GL_POLYGON_OFFSET_FILL: b.polygon_offset = enabled; break;
    case GL_CULL_FACE: b.culling.enabled = enabled; break;
    // The most frequent enables that the vertex stage does not depend on.
    case GL_SCISSOR_TEST:
    case GL_ALPHA_TEST:
    case GL_DITHER: break;
    // EXT_vertex_array enabled arrays by glEnable, and drivers still accept it.
    case GL_VERTEX_ARRAY:
    case GL_NORMAL_ARRAY:
    case GL_COLOR_ARRAY:
    case GL_INDEX_ARRAY:
    case GL_TEXTURE_COORD_ARRAY:
    case GL_EDGE_FLAG_ARRAY:
    case GL_FOG_COORD_ARRAY:
    case GL_SECONDARY_COLOR_ARRAY: c.state().arrays().vertex_arrays().forget_current(); break;
    default:
      note_clip_distance(c, capability, enabled);
      c.state().fixed_function().touch();
      break;
  }
}

}  // namespace

namespace hook {

void Enable(Context& c, GLenum capability) {
  if (capability == GL_MAP1_VERTEX_3 || capability == GL_MAP1_VERTEX_4 || capability == GL_MAP2_VERTEX_3 ||
      capability == GL_MAP2_VERTEX_4) {
    c.share().maps_vertices = true;
  }
  if (c.capabilities().refinable && (capability == GL_ARK || capability == GL_DEPTH_TAG_ARRAY_ARK)) {
    capability == GL_ARK ? set_ark_enabled(c, true) : set_tag_array(c, true);
    return;
  }
  c.gl().Enable(capability);
  if (track::executes(c)) {
    set_capability(c, capability, true);
  }
}

void Disable(Context& c, GLenum capability) {
  if (c.capabilities().refinable && (capability == GL_ARK || capability == GL_DEPTH_TAG_ARRAY_ARK)) {
    capability == GL_ARK ? set_ark_enabled(c, false) : set_tag_array(c, false);
    return;
  }
  c.gl().Disable(capability);
  if (track::executes(c)) {
    set_capability(c, capability, false);
  }
}

void Enablei(Context& c, GLenum capability, GLuint index) {
  c.gl().Enablei(capability, index);
  if (track::executes(c) && capability == GL_BLEND && index == 0) {
    c.state().bindings().blend = true;
  }
}

void Disablei(Context& c, GLenum capability, GLuint index) {
  c.gl().Disablei(capability, index);
  if (track::executes(c) && capability == GL_BLEND && index == 0) {
    c.state().bindings().blend = false;
  }
}

GLboolean IsEnabled(Context& c, GLenum capability) {
  if (c.capabilities().refinable && capability == GL_ARK) {
    return track::inside_begin(c, "glIsEnabled(GL_ARK)") || !c.ark().enabled ? GL_FALSE : GL_TRUE;
  }
  if (c.capabilities().refinable && capability == GL_DEPTH_TAG_ARRAY_ARK) {
    GLint enabled = 0;
    c.gl().GetVertexAttribiv(c.ark().tag_attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    return enabled != 0 ? GL_TRUE : GL_FALSE;
  }
  return c.gl().IsEnabled(capability);
}

void EnableClientState(Context& c, GLenum array) {
  if (c.capabilities().refinable && array == GL_DEPTH_TAG_ARRAY_ARK) {
    set_tag_array(c, true);
    return;
  }
  c.gl().EnableClientState(array);
  if (array == GL_PRIMITIVE_RESTART_NV) {
    c.state().forget_bindings();
  }
  client_state_changed(c, array, true);
}

void DisableClientState(Context& c, GLenum array) {
  if (c.capabilities().refinable && array == GL_DEPTH_TAG_ARRAY_ARK) {
    set_tag_array(c, false);
    return;
  }
  c.gl().DisableClientState(array);
  if (array == GL_PRIMITIVE_RESTART_NV) {
    c.state().forget_bindings();
  }
  client_state_changed(c, array, false);
}

void DepthFunc(Context& c, GLenum function) {
  c.gl().DepthFunc(function);
  if (track::executes(c) && function >= GL_NEVER && function <= GL_ALWAYS) {
    c.state().bindings().depth_function = function;
  }
}

void DepthMask(Context& c, GLboolean writes) {
  c.gl().DepthMask(writes);
  if (track::executes(c)) {
    c.state().bindings().depth_writes = writes != GL_FALSE;
  }
}

void ColorMask(Context& c, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
  c.gl().ColorMask(red, green, blue, alpha);
  if (track::executes(c)) {
    c.state().bindings().color_writes = (red | green | blue | alpha) != GL_FALSE;
  }
}

// Only draw buffer 0 is tracked: a depth pre-pass masks all draw buffers.
void ColorMaski(Context& c, GLuint buffer, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
  c.gl().ColorMaski(buffer, red, green, blue, alpha);
  if (track::executes(c) && buffer == 0) {
    c.state().bindings().color_writes = (red | green | blue | alpha) != GL_FALSE;
  }
}

void MatrixMode(Context& c, GLenum mode) {
  c.gl().MatrixMode(mode);
  if (track::executes(c)) {
    c.state().bindings().matrix_mode = mode;
    c.changes().touch_any_matrix();  // GL may have refused
  }
}

void Viewport(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  constexpr GLsizei certainly_possible = 4096;
  c.gl().Viewport(x, y, width, height);
  if (!track::executes(c) || width < 0 || height < 0) {
    return;
  }
  std::array<GLint, 4> viewport{x, y, width, height};
  if (std::max(width, height) > certainly_possible) {  // GL clamps to GL_MAX_VIEWPORT_DIMS
    c.gl().GetIntegerv(GL_VIEWPORT, viewport.data());
  }
  c.state().bindings().viewport = {static_cast<float>(viewport[2]), static_cast<float>(viewport[3])};
}

void ViewportIndexedf(Context& c, GLuint index, GLfloat x, GLfloat y, GLfloat width, GLfloat height) {
  c.gl().ViewportIndexedf(index, x, y, width, height);
  if (track::executes(c) && index == 0) {
    c.state().forget_bindings();
  }
}

void ViewportIndexedfv(Context& c, GLuint index, const GLfloat* viewport) {
  c.gl().ViewportIndexedfv(index, viewport);
  if (track::executes(c) && index == 0) {
    c.state().forget_bindings();
  }
}

void ViewportArrayv(Context& c, GLuint first, GLsizei count, const GLfloat* viewports) {
  c.gl().ViewportArrayv(first, count, viewports);
  if (track::executes(c) && first == 0) {
    c.state().forget_bindings();
  }
}

void PolygonMode(Context& c, GLenum face, GLenum mode) {
  c.gl().PolygonMode(face, mode);
  if (!track::executes(c)) {
    return;
  }
  const bool one_face = c.capabilities().is_compatibility() && (face == GL_FRONT || face == GL_BACK);
  if ((!one_face && face != GL_FRONT_AND_BACK) || mode < GL_POINT || mode > GL_FILL) {
    c.state().forget_bindings();  // GL may have refused
    return;
  }
  Bindings& b = c.state().bindings();
  b.polygon_modes = {face == GL_BACK ? b.polygon_modes.front : mode, face == GL_FRONT ? b.polygon_modes.back : mode};
}

void CullFace(Context& c, GLenum face) {
  c.gl().CullFace(face);
  if (track::executes(c) && (face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK)) {
    c.state().bindings().culling.face = face;
  }
}

void FrontFace(Context& c, GLenum mode) {
  c.gl().FrontFace(mode);
  if (track::executes(c) && (mode == GL_CW || mode == GL_CCW)) {
    c.state().bindings().culling.front_face = mode;
  }
}

void ProvokingVertex(Context& c, GLenum mode) {
  c.gl().ProvokingVertex(mode);
  if (track::executes(c) && (mode == GL_FIRST_VERTEX_CONVENTION || mode == GL_LAST_VERTEX_CONVENTION)) {
    c.state().bindings().provoking_vertex = mode;
  }
}

void ShadeModel(Context& c, GLenum mode) {
  c.gl().ShadeModel(mode);
  if (track::executes(c) && (mode == GL_FLAT || mode == GL_SMOOTH)) {
    c.state().bindings().shade_model = mode;
  }
}

void ClampColor(Context& c, GLenum target, GLenum clamp) {
  c.gl().ClampColor(target, clamp);
  if (track::executes(c)) {
    c.state().forget_bindings();
  }
}

GLint RenderMode(Context& c, GLenum mode) {
  c.state().forget_bindings();
  return c.gl().RenderMode(mode);
}

void PushClientAttrib(Context& c, GLbitfield mask) { c.gl().PushClientAttrib(mask); }

void PopClientAttrib(Context& c) {
  c.gl().PopClientAttrib();
  client_state_replaced(c);
}

void ClientAttribDefaultEXT(Context& c, GLbitfield mask) {
  c.gl().ClientAttribDefaultEXT(mask);
  client_state_replaced(c);
}

void PushClientAttribDefaultEXT(Context& c, GLbitfield mask) {
  c.gl().PushClientAttribDefaultEXT(mask);
  client_state_replaced(c);
}

}  // namespace hook
}  // namespace glark::core
