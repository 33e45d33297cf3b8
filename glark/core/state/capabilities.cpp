// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/capabilities.h"

#include <algorithm>

#include "glark/core/objects/get_integer.h"
#include "glark/core/state/arrays/attribute_slots.h"

namespace glark::core {
namespace {

std::vector<std::string> extensions_of(const gl::Dispatch& gl) {
  std::vector<std::string> names;
  const GLint count = get_integer(gl, GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < count; ++i) {
    if (const auto* text = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        text != nullptr) {
      names.emplace_back(text);
    }
  }
  return names;
}

// The names in one string, for programs that do not ask for them one by one. Core contexts have no such string.
std::string extension_string_of(const gl::Dispatch& gl) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  std::string names = text != nullptr ? text : "";
  if (!names.empty() && names.back() != ' ') {
    names += ' ';
  }
  return names += extension_name;
}

// Reads the version and the kind of context. False: the context could not be asked.
bool read_version(const gl::Dispatch& gl, Capabilities& capabilities) {
  const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  if (version == nullptr) {
    return false;
  }
  const std::string text(version);
  const std::size_t digit = text.find_first_of("0123456789");
  if (digit == std::string::npos || digit + 2 >= text.size()) {
    return false;
  }
  capabilities.version_text = text;
  capabilities.version = (text[digit] - '0') * 10 + (text[digit + 2] - '0');
  if (text.rfind("OpenGL ES", 0) == 0) {
    capabilities.api = Capabilities::Api::es;
    capabilities.refinable = capabilities.version >= 32;
    return true;
  }
  const bool core =
      capabilities.version >= 32 && (get_integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
  capabilities.api = core ? Capabilities::Api::core : Capabilities::Api::compatibility;
  capabilities.refinable = capabilities.version >= 43;
  return true;
}

void read_limits(const gl::Dispatch& gl, Capabilities& capabilities) {
  const bool es = capabilities.api == Capabilities::Api::es;
  capabilities.attribute_stack = capabilities.is_compatibility()
                                     ? static_cast<std::size_t>(std::max(0, get_integer(gl, GL_MAX_ATTRIB_STACK_DEPTH)))
                                     : 0;
  capabilities.quads_follow_convention =
      !capabilities.is_compatibility() || get_integer(gl, GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION) != GL_FALSE;
  capabilities.max_texture_units = get_integer(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  capabilities.max_vertex_attributes = std::min<GLint>(get_integer(gl, GL_MAX_VERTEX_ATTRIBS), generic_slots);
  if (capabilities.version >= (es ? 31 : 44)) {
    capabilities.max_vertex_attribute_stride = get_integer(gl, GL_MAX_VERTEX_ATTRIB_STRIDE);
  }
  capabilities.max_vertex_storage_blocks = get_integer(gl, GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS);
  capabilities.storage_bindings = static_cast<GLuint>(get_integer(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS));
  capabilities.feedback_buffers = static_cast<GLuint>(
      get_integer(gl, es ? GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS : GL_MAX_TRANSFORM_FEEDBACK_BUFFERS));
  capabilities.max_feedback_components = get_integer(gl, GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS);
}

}  // namespace

Capabilities read_capabilities(const gl::Dispatch& gl) {
  Capabilities capabilities;
  if (gl.GetString == nullptr || gl.GetIntegerv == nullptr || !read_version(gl, capabilities) ||
      !capabilities.refinable) {
    return capabilities;
  }
  const bool es = capabilities.api == Capabilities::Api::es;
  capabilities.extensions = extensions_of(gl);
  if (capabilities.api != Capabilities::Api::core) {
    capabilities.extension_string = extension_string_of(gl);
  }
  const auto has_extension = [&](std::string_view name) {
    return std::find(capabilities.extensions.begin(), capabilities.extensions.end(), name) !=
           capabilities.extensions.end();
  };
  capabilities.query_buffer = !es && (capabilities.version >= 44 || has_extension("GL_ARB_query_buffer_object"));
  capabilities.multi_draw_indirect =
      !es || (has_extension("GL_EXT_multi_draw_indirect") && has_extension("GL_EXT_base_instance"));
  capabilities.parameter_buffer = !es && (capabilities.version >= 46 || has_extension("GL_ARB_indirect_parameters"));
  capabilities.fog_distance = has_extension("GL_NV_fog_distance");
  capabilities.ati_fragment_shader = has_extension("GL_ATI_fragment_shader");
  read_limits(gl, capabilities);
  return capabilities;
}

gl::Dispatch supported_functions(const gl::Dispatch& gl, const Capabilities& capabilities) {
  gl::Dispatch supported = gl;
  if (capabilities.api == Capabilities::Api::es) {
    supported.PolygonMode = nullptr;
    supported.GetProgramStageiv = nullptr;
    supported.BindFragDataLocationIndexed = nullptr;
    supported.ShaderStorageBlockBinding = nullptr;
    supported.GetBufferSubData = nullptr;
  }
  if (!capabilities.multi_draw_indirect) {
    supported.MultiDrawElementsIndirect = nullptr;
  } else if (capabilities.api == Capabilities::Api::es) {
    supported.MultiDrawElementsIndirect = supported.MultiDrawElementsIndirectEXT;
  }
  if (!capabilities.is_compatibility()) {
    supported.GetProgramStringARB = nullptr;
  }
  const auto lacks = [&](std::string_view extension) {
    return std::find(capabilities.extensions.begin(), capabilities.extensions.end(), extension) ==
           capabilities.extensions.end();
  };
  if (lacks("GL_EXT_depth_bounds_test")) {
    supported.DepthBoundsEXT = nullptr;
  }
  if (lacks("GL_ARB_shading_language_include")) {
    supported.IsNamedStringARB = nullptr;
  }
  return supported;
}

}  // namespace glark::core
