// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The features of the driver's context.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "glark/gl/dispatch.h"

namespace glark::core {

// The name that our extension adds to those of the driver.
inline constexpr std::string_view extension_name = "GL_ARK_adaptive_refinement";

struct Capabilities {
  enum class Api { compatibility, core, es };
  Api api = Api::compatibility;
  int version = 0;                      // 45 for 4.5
  std::string version_text;             // GL_VERSION; empty: the context could not be asked
  bool refinable = false;               // GL >= 4.3 or ES >= 3.2
  bool quads_follow_convention = true;  // provoking vertex of quads under GL_FIRST_VERTEX_CONVENTION
  bool parameter_buffer = false;        // GL_PARAMETER_BUFFER is a binding point
  bool query_buffer = false;            // query results can go to a buffer
  std::size_t attribute_stack = 0;      // depth of the stack of glPushAttrib
  bool multi_draw_indirect = false;     // with a base instance; without it, bins are read back
  std::vector<std::string> extensions;
  std::string extension_string;  // what glGetString(GL_EXTENSIONS) returns to the application; empty in core contexts
  bool fog_distance = false;     // GL_NV_fog_distance
  bool ati_fragment_shader = false;
  GLint max_vertex_attributes = 16;
  GLint max_vertex_attribute_stride = 0;  // 0: there is no limit
  GLint max_texture_units = 0;
  GLint max_feedback_components = 64;
  GLint max_vertex_storage_blocks = 0;
  GLuint storage_bindings = 0;  // indexed bindings of GL_SHADER_STORAGE_BUFFER
  GLuint feedback_buffers = 0;  // indexed bindings of GL_TRANSFORM_FEEDBACK_BUFFER

  bool is_compatibility() const { return api == Api::compatibility; }
};

// Queries the current context. The caller keeps GL errors apart (ErrorScope).
Capabilities read_capabilities(const gl::Dispatch& gl);

// A copy of `gl` without the functions that the context does not offer. Some GL libraries have an address for every
// name, so a function pointer proves nothing. In the copy, a pointer means that the function exists.
gl::Dispatch supported_functions(const gl::Dispatch& gl, const Capabilities& capabilities);

}  // namespace glark::core
