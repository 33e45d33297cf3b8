// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/fixed_function/state.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace glark::refine {
namespace {

GLenum get_enum(const gl::Dispatch& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return static_cast<GLenum>(value);
}

void read_lighting(const gl::Dispatch& gl, FixedFunctionState& state) {
  for (std::size_t i = 0; i < state.light.size(); ++i) {
    state.light[i] = gl.IsEnabled(GL_LIGHT0 + static_cast<GLenum>(i)) != GL_FALSE;
  }
  state.two_sided = get_enum(gl, GL_LIGHT_MODEL_TWO_SIDE) != 0;
  state.local_viewer = get_enum(gl, GL_LIGHT_MODEL_LOCAL_VIEWER) != 0;
  state.separate_specular = get_enum(gl, GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  state.color_material = gl.IsEnabled(GL_COLOR_MATERIAL) != GL_FALSE;
  if (state.color_material) {
    state.color_material_face = get_enum(gl, GL_COLOR_MATERIAL_FACE);
    state.color_material_parameter = get_enum(gl, GL_COLOR_MATERIAL_PARAMETER);
  }
}

bool texture_enabled(const gl::Dispatch& gl) {
  return gl.IsEnabled(GL_TEXTURE_2D) != GL_FALSE || gl.IsEnabled(GL_TEXTURE_1D) != GL_FALSE ||
         gl.IsEnabled(GL_TEXTURE_3D) != GL_FALSE || gl.IsEnabled(GL_TEXTURE_CUBE_MAP) != GL_FALSE ||
         gl.IsEnabled(GL_TEXTURE_RECTANGLE) != GL_FALSE;
}

void read_texture_units(const gl::Dispatch& gl, FixedFunctionState& state, const FragmentReads& fragment) {
  const GLenum active = get_enum(gl, GL_ACTIVE_TEXTURE);
  const int available = std::min(fixed_function_texture_units, static_cast<int>(get_enum(gl, GL_MAX_TEXTURE_COORDS)));
  for (int i = 0; i < available; ++i) {
    TextureUnitState& unit = state.unit[static_cast<std::size_t>(i)];
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    unit.used = fragment.own_fragment_stage ? (fragment.texture_units >> i & 1U) != 0 : texture_enabled(gl);
    if (!unit.used) {
      continue;
    }
    for (GLenum coordinate = 0; coordinate < 4; ++coordinate) {
      if (gl.IsEnabled(GL_TEXTURE_GEN_S + coordinate) != GL_FALSE) {
        GLint mode = 0;
        gl.GetTexGeniv(GL_S + coordinate, GL_TEXTURE_GEN_MODE, &mode);
        unit.generation[coordinate] = static_cast<GLenum>(mode);
      }
    }
  }
  gl.ActiveTexture(active);
}

bool point_size_attenuates(const gl::Dispatch& gl) {
  GLfloat attenuation[3] = {1, 0, 0};
  gl.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  return attenuation[0] != 1.0F || attenuation[1] != 0.0F || attenuation[2] != 0.0F;
}

}  // namespace

namespace {

// `text` begins behind the name of the texture coordinates. Returns the units that the index there may name: one unit if
// it is a single digit, otherwise all. In assembly, a missing index means unit 0.
unsigned units_of_index(std::string_view text, bool is_assembly) {
  constexpr unsigned all = (1U << fixed_function_texture_units) - 1U;
  const auto next = [&text] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const char letter = text.empty() ? '\0' : text.front();
    text.remove_prefix(text.empty() ? 0 : 1);
    return letter;
  };
  if (next() != '[') {
    return is_assembly ? 1U : all;
  }
  const char digit = next();
  const bool is_literal = digit >= '0' && digit < '0' + fixed_function_texture_units && next() == ']';
  return is_literal ? 1U << (digit - '0') : all;
}

}  // namespace

FragmentReads fragment_reads(const std::string& source) {
  std::string lower(source);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::string_view word = "texcoord";
  const bool is_assembly = lower.find("!!arbfp") != std::string::npos;
  FragmentReads reads{true, 0};
  for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at)) {
    at += word.size();
    reads.texture_units |= units_of_index(std::string_view(lower).substr(at), is_assembly);
  }
  return reads;
}

FixedFunctionState read_fixed_function_state(const gl::Dispatch& gl, const FragmentReads& fragment, bool fog_distance) {
  FixedFunctionState state;
  state.lighting = gl.IsEnabled(GL_LIGHTING) != GL_FALSE;
  if (state.lighting) {
    read_lighting(gl, state);
  }
  state.color_sum = fragment.own_fragment_stage || gl.IsEnabled(GL_COLOR_SUM) != GL_FALSE;
  state.normalize = gl.IsEnabled(GL_NORMALIZE) != GL_FALSE;
  state.rescale_normal = gl.IsEnabled(GL_RESCALE_NORMAL) != GL_FALSE;
  state.fog = fragment.own_fragment_stage || gl.IsEnabled(GL_FOG) != GL_FALSE;
  state.fog_from_coordinate = state.fog && get_enum(gl, GL_FOG_COORD_SRC) == GL_FOG_COORD;
  if (state.fog && fog_distance) {
    state.fog_distance = get_enum(gl, GL_FOG_DISTANCE_MODE_NV);
  }
  for (GLenum plane = 0; plane < 8; ++plane) {
    state.clip_planes = state.clip_planes || gl.IsEnabled(GL_CLIP_PLANE0 + plane) != GL_FALSE;
  }
  state.point_size = point_size_attenuates(gl);
  state.program_point_size = gl.IsEnabled(GL_PROGRAM_POINT_SIZE) != GL_FALSE;
  read_texture_units(gl, state, fragment);
  return state;
}

}  // namespace glark::refine
