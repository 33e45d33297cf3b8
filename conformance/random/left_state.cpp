// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/left_state.h"

#include <fmt/core.h>

#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct Name {
  GLenum name;
  int values;  // how many it has
  bool is_desktop;
};

constexpr Name names[] = {
    {GL_ACTIVE_TEXTURE, 1, false},
    {GL_ARRAY_BUFFER_BINDING, 1, false},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, 1, false},
    {GL_VERTEX_ARRAY_BINDING, 1, false},
    {GL_CURRENT_PROGRAM, 1, false},
    {GL_PROGRAM_PIPELINE_BINDING, 1, false},
    {GL_COPY_READ_BUFFER_BINDING, 1, false},
    {GL_COPY_WRITE_BUFFER_BINDING, 1, false},
    {GL_DRAW_INDIRECT_BUFFER_BINDING, 1, false},
    {GL_DISPATCH_INDIRECT_BUFFER_BINDING, 1, false},
    {GL_SHADER_STORAGE_BUFFER_BINDING, 1, false},
    {GL_UNIFORM_BUFFER_BINDING, 1, false},
    {GL_ATOMIC_COUNTER_BUFFER_BINDING, 1, false},
    {GL_PIXEL_PACK_BUFFER_BINDING, 1, false},
    {GL_PIXEL_UNPACK_BUFFER_BINDING, 1, false},
    {GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1, false},
    {GL_TRANSFORM_FEEDBACK_BINDING, 1, false},
    {GL_VIEWPORT, 4, false},
    {GL_SCISSOR_BOX, 4, false},
    {GL_COLOR_WRITEMASK, 4, false},
    {GL_DEPTH_WRITEMASK, 1, false},
    {GL_DEPTH_FUNC, 1, false},
    {GL_DEPTH_RANGE, 2, false},
    {GL_STENCIL_FUNC, 1, false},
    {GL_STENCIL_REF, 1, false},
    {GL_BLEND_EQUATION_RGB, 1, false},
    {GL_CULL_FACE_MODE, 1, false},
    {GL_FRONT_FACE, 1, false},
    {GL_POLYGON_OFFSET_FACTOR, 1, false},
    {GL_PROVOKING_VERTEX, 1, true},
    {GL_PRIMITIVE_RESTART_INDEX, 1, true},
    {GL_POLYGON_MODE, 2, true},
    {GL_POINT_SIZE, 1, true},
    {GL_CLAMP_READ_COLOR, 1, true},
};

constexpr Name fixed_names[] = {
    {GL_CURRENT_COLOR, 4, true},
    {GL_CURRENT_SECONDARY_COLOR, 4, true},
    {GL_CURRENT_NORMAL, 3, true},
    {GL_CURRENT_TEXTURE_COORDS, 4, true},
    {GL_CURRENT_FOG_COORD, 1, true},
    {GL_EDGE_FLAG, 1, true},
    {GL_MATRIX_MODE, 1, true},
    {GL_MODELVIEW_MATRIX, 16, true},
    {GL_PROJECTION_MATRIX, 16, true},
    {GL_TEXTURE_MATRIX, 16, true},
    {GL_MODELVIEW_STACK_DEPTH, 1, true},
    {GL_PROJECTION_STACK_DEPTH, 1, true},
    {GL_ATTRIB_STACK_DEPTH, 1, true},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, 1, true},
    {GL_CLIENT_ACTIVE_TEXTURE, 1, true},
    {GL_SHADE_MODEL, 1, true},
    {GL_LIST_BASE, 1, true},
    {GL_LIGHT_MODEL_AMBIENT, 4, true},
    {GL_COLOR_MATERIAL_PARAMETER, 1, true},
    {GL_FOG_COORD_SRC, 1, true},
    {GL_VERTEX_ARRAY_SIZE, 1, true},
    {GL_COLOR_ARRAY_SIZE, 1, true},
    {GL_COLOR_ARRAY_TYPE, 1, true},
    {GL_TEXTURE_COORD_ARRAY_SIZE, 1, true},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, 1, true},
    {GL_COLOR_ARRAY_BUFFER_BINDING, 1, true},
    {GL_CLAMP_VERTEX_COLOR, 1, true},
};

constexpr GLenum capabilities[] = {GL_BLEND,        GL_CULL_FACE,           GL_DEPTH_TEST,
                                   GL_DITHER,       GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST,
                                   GL_STENCIL_TEST, GL_RASTERIZER_DISCARD,  GL_PRIMITIVE_RESTART_FIXED_INDEX};
constexpr GLenum desktop_capabilities[] = {GL_PRIMITIVE_RESTART, GL_PROGRAM_POINT_SIZE, GL_COLOR_LOGIC_OP,
                                           GL_CLIP_DISTANCE0,    GL_CLIP_DISTANCE0 + 1, GL_CLIP_DISTANCE0 + 5};
constexpr GLenum fixed_capabilities[] = {GL_LIGHTING,
                                         GL_LIGHT0,
                                         GL_LIGHT1,
                                         GL_COLOR_MATERIAL,
                                         GL_NORMALIZE,
                                         GL_RESCALE_NORMAL,
                                         GL_FOG,
                                         GL_COLOR_SUM,
                                         GL_TEXTURE_2D,
                                         GL_TEXTURE_GEN_S,
                                         GL_VERTEX_PROGRAM_TWO_SIDE,
                                         GL_VERTEX_ARRAY,
                                         GL_NORMAL_ARRAY,
                                         GL_COLOR_ARRAY,
                                         GL_TEXTURE_COORD_ARRAY,
                                         GL_FOG_COORD_ARRAY,
                                         GL_SECONDARY_COLOR_ARRAY};

template <std::size_t n>
void add_values(LeftState& state, const Name (&all)[n], bool is_desktop) {
  for (const Name& each : all) {
    if (each.is_desktop && !is_desktop) continue;
    std::array<GLfloat, 16> values{};
    gl.GetFloatv(each.name, values.data());
    std::string& text = state[fmt::format("state {:#x}", each.name)];
    for (int i = 0; i < each.values; ++i) text += as_text(values[static_cast<std::size_t>(i)]) + " ";
  }
}

template <std::size_t n>
void add_capabilities(LeftState& state, const GLenum (&all)[n]) {
  for (const GLenum each : all) state[fmt::format("capability {:#x}", each)] = as_text(gl.IsEnabled(each) == GL_TRUE);
}

void add_materials(LeftState& state) {
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
      std::array<GLfloat, 4> values{};
      gl.GetMaterialfv(face, name, values.data());
      std::string& text = state[fmt::format("material {:#x} of {:#x}", name, face)];
      for (const GLfloat value : values) text += as_text(value) + " ";
    }
}

void add_attributes(LeftState& state, GLuint first) {
  for (GLuint i = first; i < 16; ++i) {
    std::string& text = state[fmt::format("attribute {}", i)];
    if (i != at_integers && i != at_doubles)
      for (const float component : current_value(i)) text += as_text(component) + " ";
    for (const GLenum name :
         {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_STRIDE,
          GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
          GL_VERTEX_ATTRIB_BINDING})
      text += as_text(array_state(i, name)) + " ";
  }
}

}  // namespace

LeftState left_state(const World& w) {
  LeftState state;
  add_values(state, names, w.is_desktop());
  add_capabilities(state, capabilities);
  if (w.is_desktop()) add_capabilities(state, desktop_capabilities);
  if (w.t.is_compat()) {
    add_values(state, fixed_names, true);
    add_capabilities(state, fixed_capabilities);
    add_materials(state);
  }
  add_attributes(state, w.t.is_compat() ? 1 : 0);
  for (const GLenum name :
       {GL_REFINEMENT_ARK, GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_LEVEL_ARK, GL_CURRENT_DEPTH_TAG_ARK})
    state[fmt::format("state {:#x}", name)] = as_text(integer_of(name));
  while (gl.GetError() != GL_NO_ERROR) {
  }
  return state;
}

std::optional<std::string> difference_of(const LeftState& refined, const LeftState& plain) {
  for (const auto& [name, value] : plain)
    if (refined.at(name) != value)
      return fmt::format("it leaves {} with {}, without refinement {}", name, refined.at(name), value);
  return {};
}

}  // namespace glark::conformance
