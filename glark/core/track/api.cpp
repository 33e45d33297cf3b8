// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The commands of GL_ARK_adaptive_refinement (docs/spec). A failed command changes nothing.
// Based on: Boubekeur 2007, ch. 7.5 ("Low level API extensions").
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "glark/core/parameters.h"
#include "glark/core/track/complain.h"
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Commands that need the pool, or a context that can refine at all.
bool refuse(Context& c, const char* function, bool needs_pool = false) {
  if (track::inside_begin(c, function)) {
    return true;
  }
  if (!c.capabilities().refinable) {
    track::complain(c, GL_INVALID_OPERATION, function,
                    "the context cannot refine; create one of OpenGL 4.3 or OpenGL ES 3.2");
    return true;
  }
  if (needs_pool && c.ark().pool_level < 0) {
    track::complain(c, GL_INVALID_OPERATION, function, "there are no patterns yet; call glARKinit first");
    return true;
  }
  return false;
}

GLuint highest_tag(const Context& c) { return static_cast<GLuint>(std::max(c.ark().pool_level, 0)); }

bool is_tag_type(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT || type == GL_FLOAT;
}

// Adjacency, patches, points and lines cannot be refined.
bool refuse_mode(Context& c, const char* function, GLenum mode) {
  const bool quads = mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON;
  if (!is_triangle_mode(mode) || (quads && !c.capabilities().is_compatibility())) {
    track::complain(c, GL_INVALID_ENUM, function,
                    fmt::format("mode 0x{:04X} has no triangles here; use GL_TRIANGLES, a strip or a fan{}", mode,
                                c.capabilities().is_compatibility() ? ", quads or a polygon" : ""));
    return true;
  }
  return false;
}

// Checks the errors of glVertexAttribPointer first: some drivers change the array although they raise an error.
bool refuse_array(Context& c, const char* function, GLsizei stride, const void* pointer) {
  const GLint limit = c.capabilities().max_vertex_attribute_stride;
  if (stride < 0 || (limit > 0 && stride > limit)) {
    track::complain(c, GL_INVALID_VALUE, function,
                    fmt::format("stride {} is not between 0 and GL_MAX_VERTEX_ATTRIB_STRIDE ({})", stride, limit));
    return true;
  }
  const bool is_default = c.state().bindings().vertex_array == 0;
  if (is_default ? c.capabilities().api == Capabilities::Api::core
                 : pointer != nullptr && c.state().arrays().bound_buffer(GL_ARRAY_BUFFER).name == 0) {
    track::complain(c, GL_INVALID_OPERATION, function,
                    is_default ? "no vertex array is bound; a core context needs one"
                               : "the vertex array is an object, and no buffer is bound to GL_ARRAY_BUFFER");
    return true;
  }
  return false;
}

// Draws refined even with GL_ARK disabled.
template <typename Draw>
void with_ark(Context& c, Draw&& draw) {
  const bool was_transparent = std::exchange(c.options().transparent, false);
  const bool was_enabled = std::exchange(c.ark().enabled, true);
  draw();
  c.options().transparent = was_transparent;
  c.ark().enabled = was_enabled;
  c.update_refining();
}

ParameterLimits limits_of(const Context& c) {
  return {.level = static_cast<GLint>(highest_tag(c)),
          .first_attribute = c.capabilities().is_compatibility() ? 1 : 0,  // attribute 0 is glVertex there
          .attribute_count = c.capabilities().max_vertex_attributes,
          .texture_unit_count = c.capabilities().max_texture_units};
}

// Why a parameter does not take the value.
template <typename Value>
std::string reason_of(const Parameter* parameter, GLenum name, Value value, const ParameterLimits& limits) {
  if (parameter == nullptr) {
    return fmt::format("0x{:04X} is not the name of a parameter", name);
  }
  std::string needed;
  for (const TokenName& token : parameter->tokens) {
    needed += fmt::format("{}GL_{}", needed.empty() ? "" : ", ", token.name);
  }
  if (parameter->kind == Parameter::Kind::boolean) {
    needed = "GL_FALSE or GL_TRUE";
  } else if (parameter->kind == Parameter::Kind::number) {
    needed = fmt::format("a number from {} to {}, by glARKParameterfARK,", parameter->least, parameter->most);
  } else if (parameter->kind == Parameter::Kind::whole && parameter->bounds != nullptr) {
    const Bounds bounds = parameter->bounds(limits);
    needed = fmt::format("{}an integer from {} to {}", bounds.or_minus_one ? "-1 or " : "", bounds.least, bounds.most);
  }
  if (std::is_floating_point_v<Value> && parameter->kind != Parameter::Kind::number) {
    needed += ", by glARKParameteriARK,";
  }
  return fmt::format("GL_{} cannot be {}; {} is needed", parameter->text, value, needed);
}

// Sets the parameter by `set`, which returns an error or none.
template <typename Value, typename Set>
void set_parameter(Context& c, const char* function, GLenum name, Value value, const Set& set) {
  if (refuse(c, function)) {
    return;
  }
  const Parameter* parameter = find_parameter(name);
  const GLenum error = parameter != nullptr ? set(*parameter) : GL_INVALID_ENUM;
  if (error != GL_NO_ERROR) {
    track::complain(c, error, function, reason_of(parameter, name, value, limits_of(c)));
  } else if (name == GL_DEPTH_TAG_ATTRIBUTE_ARK) {
    c.stages()->programs().tag_attribute_changed();
  }
}

// Returns the program that a refinement command names. Null: the error is raised.
Program* named_program(Context& c, const char* function, GLuint name) {
  if (refuse(c, function)) {
    return nullptr;
  }
  if (name != 0 && c.gl().IsShader(name) != GL_FALSE) {
    track::complain(c, GL_INVALID_OPERATION, function,
                    fmt::format("{} is a shader; give the program that it is linked into", name));
    return nullptr;
  }
  if (name == 0 && !c.capabilities().is_compatibility()) {
    track::complain(c, GL_INVALID_VALUE, function,
                    "program 0 is the fixed function, which this context lacks; give a program");
    return nullptr;
  }
  if (name != 0 && c.gl().IsProgram(name) == GL_FALSE) {
    track::complain(c, GL_INVALID_VALUE, function, fmt::format("{} is no program; create it first", name));
    return nullptr;
  }
  Program* program = c.stages()->programs().named(name);
  if (program == nullptr) {
    // The program is not linked yet: its source is kept until it is.
    const std::lock_guard lock(c.share().mutex);
    std::shared_ptr<Program>& slot = c.share().programs[name];
    slot = std::make_shared<Program>();
    slot->name = name;
    program = slot.get();
  }
  return program;
}

std::string join(GLsizei count, const GLchar* const* string, const GLint* length) {
  std::string source;
  for (GLsizei i = 0; i < count; ++i) {
    const bool counted = length != nullptr && length[i] >= 0;
    source.append(string[i], counted ? static_cast<std::size_t>(length[i]) : std::strlen(string[i]));
  }
  return source;
}

}  // namespace

namespace hook {

void ARKinit(Context& c, GLuint max_level) {
  if (refuse(c, "glARKinit")) {
    return;
  }
  if (max_level > max_supported_level) {
    track::complain(
        c, GL_INVALID_VALUE, "glARKinit",
        fmt::format("level {} exceeds {}, the greatest level; give a lower one", max_level, max_supported_level));
    return;
  }
  ErrorScope errors(c.pending_error());
  if (!c.stages()->pool().build(max_level)) {
    track::complain(c, GL_OUT_OF_MEMORY, "glARKinit",
                    fmt::format("there is no memory for the patterns of level {}; give a lower one", max_level));
    return;
  }
  // From here on, the program uses the extension and is no longer refined transparently.
  c.options().transparent = false;
  const GLuint tag = track::current_tag(c);  // of the old level
  c.ark().pool_level = static_cast<int>(max_level);
  c.ark().uniform_level = std::min(c.ark().uniform_level, max_level);
  if (tag > max_level) {
    track::outside_list(c, [&] { DepthTag1i(c, max_level); });
  }
  c.update_refining();
}

void ARKParameteriARK(Context& c, GLenum name, GLint value) {
  set_parameter(c, "glARKParameteriARK", name, value,
                [&](const Parameter& parameter) { return set_integer(parameter, limits_of(c), value, c.ark()); });
}

void ARKParameterfARK(Context& c, GLenum name, GLfloat value) {
  set_parameter(c, "glARKParameterfARK", name, value,
                [&](const Parameter& parameter) { return set_number(parameter, value, c.ark()); });
}

void DepthTag1i(Context& c, GLuint d) {
  if (!c.capabilities().refinable) {
    track::complain(c, GL_INVALID_OPERATION, "glDepthTag1i",
                    "the context cannot refine; create one of OpenGL 4.3 or OpenGL ES 3.2");
    return;
  }
  if (d > highest_tag(c)) {
    track::complain(c, GL_INVALID_VALUE, "glDepthTag1i",
                    c.ark().pool_level < 0
                        ? std::string("tags above 0 need patterns; call glARKinit first")
                        : fmt::format("depth tag {} exceeds level {} of glARKinit; raise maxLevel", d, highest_tag(c)));
    return;
  }
  set_tag(c.gl(), c.ark().tag_attribute, &d);
  c.changes().set_current(generic_slot(c.ark().tag_attribute), set_tag, c.ark().tag_attribute, &d, sizeof(d));
  c.state().immediate().note_tag();
}

void DepthTagPointerARK(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (refuse(c, "glDepthTagPointerARK")) {
    return;
  }
  if (!is_tag_type(type)) {
    track::complain(c, GL_INVALID_ENUM, "glDepthTagPointerARK",
                    fmt::format("tags of type 0x{:04X} do not exist; use GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, "
                                "GL_UNSIGNED_INT or GL_FLOAT",
                                type));
    return;
  }
  if (refuse_array(c, "glDepthTagPointerARK", stride, pointer)) {
    return;
  }
  c.gl().VertexAttribPointer(c.ark().tag_attribute, 1, type, GL_FALSE, stride, pointer);
  c.state().arrays().vertex_arrays().forget_current();
}

void DrawARP(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (refuse(c, "glDrawARP", true) || refuse_mode(c, "glDrawARP", mode)) {
    return;
  }
  if (c.state().lists().compiling()) {
    track::complain(c, GL_INVALID_OPERATION, "glDrawARP",
                    "display lists do not take it; draw with GL_ARK enabled instead");
    return;
  }
  if (first < 0 || count < 0) {  // Mesa accepts a negative first
    track::complain(c, GL_INVALID_VALUE, "glDrawARP", fmt::format("first {} or count {} is negative", first, count));
    return;
  }
  with_ark(c, [&] { DrawArrays(c, mode, first, count); });
}

void DrawARPElementsARK(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (refuse(c, "glDrawARPElementsARK", true) || refuse_mode(c, "glDrawARPElementsARK", mode)) {
    return;
  }
  if (c.state().lists().compiling()) {
    track::complain(c, GL_INVALID_OPERATION, "glDrawARPElementsARK",
                    "display lists do not take it; draw with GL_ARK enabled instead");
    return;
  }
  if (count < 0) {
    track::complain(c, GL_INVALID_VALUE, "glDrawARPElementsARK", fmt::format("count {} is negative", count));
    return;
  }
  if (!track::is_index_type(type)) {
    track::complain(c, GL_INVALID_ENUM, "glDrawARPElementsARK",
                    fmt::format("indices of type 0x{:04X} do not exist; use GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or "
                                "GL_UNSIGNED_INT",
                                type));
    return;
  }
  with_ark(c, [&] { DrawElements(c, mode, count, type, indices); });
}

void RefinementShaderSourceARK(Context& c, GLuint name, GLsizei count, const GLchar* const* string,
                               const GLint* length) {
  if (count < 0) {
    track::complain(c, GL_INVALID_VALUE, "glRefinementShaderSourceARK", fmt::format("count {} is negative", count));
    return;
  }
  Program* program = named_program(c, "glRefinementShaderSourceARK", name);
  if (program == nullptr) {
    return;
  }
  ErrorScope errors(c.pending_error());
  std::string source = join(count, string, length);
  if (name == 0) {
    c.stages()->programs().fixed_function().set_refinement_source(std::move(source));
    return;
  }
  const std::lock_guard lock(program->mutex);
  c.stages()->programs().derived().discard(*program);
  program->refinement_source = std::move(source);
  *program->told_notes = {};
  program->virtual_uniforms.clear();
}

void GetRefinementivARK(Context& c, GLuint name, GLenum parameter, GLint* value) {
  Program* program = named_program(c, "glGetRefinementivARK", name);
  if (program == nullptr || value == nullptr) {
    return;
  }
  switch (parameter) {
    case GL_REFINEMENT_STATUS_ARK:
      *value = c.stages()->planner().derive_for_status(*program, name != 0 ? program : nullptr) != nullptr ? GL_TRUE
                                                                                                           : GL_FALSE;
      break;
    case GL_REFINEMENT_LOG_LENGTH_ARK:
      *value = program->refinement_log.empty() ? 0 : static_cast<GLint>(program->refinement_log.size() + 1);
      break;
    case GL_REFINEMENT_SOURCE_LENGTH_ARK:
      *value = program->refinement_source.empty() ? 0 : static_cast<GLint>(program->refinement_source.size() + 1);
      break;
    default:
      track::complain(c, GL_INVALID_ENUM, "glGetRefinementivARK",
                      fmt::format("0x{:04X} is no property of a refinement program", parameter));
      break;
  }
}

void GetRefinementInfoLogARK(Context& c, GLuint name, GLsizei size, GLsizei* length, GLchar* log) {
  if (size < 0) {
    track::complain(c, GL_INVALID_VALUE, "glGetRefinementInfoLogARK", fmt::format("bufSize {} is negative", size));
    return;
  }
  const Program* program = named_program(c, "glGetRefinementInfoLogARK", name);
  if (program == nullptr) {
    return;
  }
  GLsizei written = 0;
  if (size > 0 && log != nullptr) {
    written = std::min(size - 1, static_cast<GLsizei>(program->refinement_log.size()));
    std::memcpy(log, program->refinement_log.data(), static_cast<std::size_t>(written));
    log[written] = '\0';
  }
  if (length != nullptr) {
    *length = written;
  }
}

}  // namespace hook
}  // namespace glark::core
