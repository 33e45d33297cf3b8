// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The commands of GL_ARK_adaptive_refinement (docs/spec). A failed command changes nothing.
// Based on: Boubekeur 2007, ch. 7.5 ("Low level API extensions").
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <utility>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Commands that need the pool, or a context that can refine at all.
bool refuse(Context& c, bool needs_pool) {
  if (track::inside_begin(c)) {
    return true;
  }
  if (!c.capabilities().refinable || (needs_pool && c.ark().pool_level < 0)) {
    c.raise(GL_INVALID_OPERATION);
    return true;
  }
  return false;
}

GLuint highest_tag(const Context& c) { return static_cast<GLuint>(std::max(c.ark().pool_level, 0)); }

bool is_tag_type(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT || type == GL_FLOAT;
}

// Refined triangles only: adjacency, patches, points and lines have none of their own.
bool refuse_mode(Context& c, GLenum mode) {
  const bool quads = mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON;
  if (!is_triangle_mode(mode) || (quads && !c.is_compatibility())) {
    c.raise(GL_INVALID_ENUM);
    return true;
  }
  return false;
}

// What glVertexAttribPointer refuses: not every driver leaves the array alone then.
bool refuse_array(Context& c, GLsizei stride, const void* pointer) {
  const GLint limit = c.capabilities().max_vertex_attribute_stride;
  if (stride < 0 || (limit > 0 && stride > limit)) {
    c.raise(GL_INVALID_VALUE);
    return true;
  }
  const bool is_default = c.state().bindings().vertex_array == 0;
  if (is_default ? c.capabilities().api == Capabilities::Api::core
                 : pointer != nullptr && c.state().bound_buffer(GL_ARRAY_BUFFER).name == 0) {
    c.raise(GL_INVALID_OPERATION);
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

bool set_choice(Context& c, bool known, bool first, bool& state_is_first) {
  if (!known) {
    c.raise(GL_INVALID_ENUM);
    return false;
  }
  state_is_first = first;
  return true;
}

void set_refinement(Context& c, GLenum value) {
  switch (value) {
    case GL_LINEAR_INPUTS_ARK: c.ark().refinement = Refinement::linear_inputs; break;
    case GL_LINEAR_OUTPUTS_ARK: c.ark().refinement = Refinement::linear_outputs; break;
    case GL_CURVED_PN_ARK: c.ark().refinement = Refinement::pn; break;
    case GL_SCALAR_TAGGED_PN_ARK: c.ark().refinement = Refinement::scalar_tagged_pn; break;
    default: c.raise(GL_INVALID_ENUM); break;
  }
}

void set_depth_source(Context& c, GLenum value) {
  switch (value) {
    case GL_DEPTH_TAG_ARK: c.ark().depth_source = DepthSource::tag; break;
    case GL_UNIFORM_DEPTH_ARK: c.ark().depth_source = DepthSource::uniform; break;
    case GL_MEASURED_DEPTH_ARK: c.ark().depth_source = DepthSource::measured; break;
    default: c.raise(GL_INVALID_ENUM); break;
  }
}

void set_measure(Context& c, GLenum name, GLint value) {
  if (value < 0 || (name == GL_EDGE_DEGREES_ARK && value > 180)) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  switch (name) {
    case GL_EDGE_PIXELS_ARK:
      c.ark().measure.pixels = static_cast<float>(value);
      c.ark().edge_pixels = value;
      break;
    case GL_EDGE_DEGREES_ARK: c.ark().measure.degrees = static_cast<float>(value); break;
    default: c.ark().measure.budget = static_cast<unsigned>(value); break;
  }
}

// False, with the error raised: no generic attribute that can carry tags.
bool is_attribute(Context& c, GLint index) {
  const GLint lowest = c.is_compatibility() ? 1 : 0;  // attribute 0 is glVertex there
  if (index < lowest || index >= c.capabilities().max_vertex_attributes) {
    c.raise(GL_INVALID_VALUE);
    return false;
  }
  return true;
}

void set_attribute(Context& c, GLenum name, GLint index) {
  if (!is_attribute(c, index)) {
    return;
  }
  switch (name) {
    case GL_DEPTH_TAG_ATTRIBUTE_ARK:
      c.ark().tag_attribute = static_cast<GLuint>(index);
      c.stages()->programs().tag_attribute_changed();
      break;
    case GL_DISCONTINUITY_ATTRIBUTE_ARK: c.ark().discontinuity_attribute = static_cast<GLuint>(index); break;
    default: c.ark().scalar_tag_attribute = static_cast<GLuint>(index); break;
  }
}

void set_displacement(Context& c, GLenum name, GLint value) {
  Displacement& displacement = c.ark().displacement;
  const auto channel = static_cast<GLenum>(value);
  switch (name) {
    case GL_DISPLACEMENT_UNIT_ARK:
      if (value < -1 || value >= c.capabilities().max_texture_units) {
        c.raise(GL_INVALID_VALUE);
      } else {
        displacement.unit = value;
      }
      break;
    case GL_DISPLACEMENT_CHANNEL_ARK:
      if (channel < GL_RED || channel > GL_ALPHA) {
        c.raise(GL_INVALID_ENUM);
      } else {
        displacement.channel = channel - GL_RED;
      }
      break;
    case GL_DISPLACEMENT_COORDINATE_ARK:
      if (value == -1 || is_attribute(c, value)) {
        displacement.coordinate = value;
      }
      break;
    case GL_DISPLACEMENT_SCALE_ARK: displacement.scale = static_cast<float>(value); break;
    default: displacement.bias = static_cast<float>(value); break;
  }
}

// The program that a refinement command names. Null: the error is raised.
Program* named_program(Context& c, GLuint name) {
  if (refuse(c, false)) {
    return nullptr;
  }
  if (name != 0 && c.gl().IsShader(name) != GL_FALSE) {
    c.raise(GL_INVALID_OPERATION);
    return nullptr;
  }
  if ((name == 0 && !c.is_compatibility()) || (name != 0 && c.gl().IsProgram(name) == GL_FALSE)) {
    c.raise(GL_INVALID_VALUE);
    return nullptr;
  }
  Program* program = c.stages()->programs().named(name);
  if (program == nullptr) {
    // Not linked yet: the source waits for it.
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
  if (refuse(c, false)) {
    return;
  }
  if (max_level > max_supported_level) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  ErrorScope errors(c.pending_error());
  if (!c.stages()->pool().build(max_level)) {
    c.raise(GL_OUT_OF_MEMORY);
    return;
  }
  // From here on the program knows of the extension: it is refined as it says, no longer without its knowledge.
  c.options().transparent = false;
  const GLuint tag = track::current_tag(c);  // of the old level
  c.ark().pool_level = static_cast<int>(max_level);
  c.ark().uniform_level = std::min(c.ark().uniform_level, max_level);
  if (tag > max_level && c.state().lists().compiling) {
    c.ark().lowered_tag = max_level;
  } else if (tag > max_level) {
    DepthTag1i(c, max_level);
  }
  c.update_refining();
}

void ARKParameteriARK(Context& c, GLenum name, GLint value) {
  if (refuse(c, false)) {
    return;
  }
  const auto token = static_cast<GLenum>(value);
  bool first = true;
  switch (name) {
    case GL_REFINEMENT_ARK: set_refinement(c, token); break;
    case GL_DEPTH_SOURCE_ARK: set_depth_source(c, token); break;
    case GL_EDGE_PIXELS_ARK:
    case GL_EDGE_DEGREES_ARK:
    case GL_TRIANGLE_BUDGET_ARK: set_measure(c, name, value); break;
    case GL_GEOMORPH_ARK:
    case GL_WELD_ARK:
      if (value != GL_FALSE && value != GL_TRUE) {
        c.raise(GL_INVALID_VALUE);
      } else {
        (name == GL_WELD_ARK ? c.ark().weld : c.ark().geomorph) = value == GL_TRUE;
      }
      break;
    case GL_UNIFORM_DEPTH_LEVEL_ARK:
      if (value < 0 || static_cast<GLuint>(value) > highest_tag(c)) {
        c.raise(GL_INVALID_VALUE);
      } else {
        c.ark().uniform_level = static_cast<GLuint>(value);
      }
      break;
    case GL_DEPTH_TAG_ATTRIBUTE_ARK:
    case GL_DISCONTINUITY_ATTRIBUTE_ARK:
    case GL_SCALAR_TAG_ATTRIBUTE_ARK: set_attribute(c, name, value); break;
    case GL_DISPLACEMENT_UNIT_ARK:
    case GL_DISPLACEMENT_CHANNEL_ARK:
    case GL_DISPLACEMENT_COORDINATE_ARK:
    case GL_DISPLACEMENT_SCALE_ARK:
    case GL_DISPLACEMENT_BIAS_ARK: set_displacement(c, name, value); break;
    case GL_POLYGON_SPLIT_ARK:
      if (set_choice(c, token == GL_POLYGON_TRIANGLES_ARK || token == GL_POLYGON_CENTROID_ARK,
                     token == GL_POLYGON_TRIANGLES_ARK, first)) {
        c.ark().polygon_split = first ? PolygonSplit::triangles : PolygonSplit::centroid;
      }
      break;
    case GL_PATTERN_INTERIOR_ARK:
      if (set_choice(c, token == GL_MINIMUM_INTERIOR_ARK || token == GL_SMOOTH_INTERIOR_ARK,
                     token == GL_MINIMUM_INTERIOR_ARK, first)) {
        c.ark().smooth_interior = !first;
      }
      break;
    default: c.raise(GL_INVALID_ENUM); break;
  }
}

void ARKParameterfARK(Context& c, GLenum name, GLfloat value) {
  if (refuse(c, false)) {
    return;
  }
  if (name != GL_DISPLACEMENT_SCALE_ARK && name != GL_DISPLACEMENT_BIAS_ARK) {
    c.raise(GL_INVALID_ENUM);
    return;
  }
  if (!std::isfinite(value)) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  (name == GL_DISPLACEMENT_SCALE_ARK ? c.ark().displacement.scale : c.ark().displacement.bias) = value;
}

void DepthTag1i(Context& c, GLuint d) {
  if (!c.capabilities().refinable) {
    c.raise(GL_INVALID_OPERATION);
    return;
  }
  if (d > highest_tag(c)) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  set_tag(c.gl(), c.ark().tag_attribute, &d);
  c.state().set_current(generic_slot(c.ark().tag_attribute), set_tag, c.ark().tag_attribute, &d, sizeof(d));
  c.state().immediate().tags_set = true;
  if (c.state().lists().compiling && c.state().lists().mode == GL_COMPILE_AND_EXECUTE) {
    c.ark().lowered_tag.reset();
  }
}

void DepthTagPointerARK(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (refuse(c, false)) {
    return;
  }
  if (!is_tag_type(type)) {
    c.raise(GL_INVALID_ENUM);
    return;
  }
  if (refuse_array(c, stride, pointer)) {
    return;
  }
  c.gl().VertexAttribPointer(c.ark().tag_attribute, 1, type, GL_FALSE, stride, pointer);
  c.state().vertex_arrays().forget_current();
}

void DrawARP(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (refuse(c, true) || refuse_mode(c, mode)) {
    return;
  }
  if (c.state().lists().compiling) {
    c.raise(GL_INVALID_OPERATION);
    return;
  }
  if (first < 0 || count < 0) {  // Mesa accepts a negative first
    c.raise(GL_INVALID_VALUE);
    return;
  }
  with_ark(c, [&] { DrawArrays(c, mode, first, count); });
}

void DrawARPElementsARK(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (refuse(c, true) || refuse_mode(c, mode)) {
    return;
  }
  if (c.state().lists().compiling) {
    c.raise(GL_INVALID_OPERATION);
    return;
  }
  with_ark(c, [&] { DrawElements(c, mode, count, type, indices); });
}

void RefinementShaderSourceARK(Context& c, GLuint name, GLsizei count, const GLchar* const* string,
                               const GLint* length) {
  if (count < 0) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  Program* program = named_program(c, name);
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
  program->virtual_uniforms.clear();
}

void GetRefinementivARK(Context& c, GLuint name, GLenum parameter, GLint* value) {
  Program* program = named_program(c, name);
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
    default: c.raise(GL_INVALID_ENUM); break;
  }
}

void GetRefinementInfoLogARK(Context& c, GLuint name, GLsizei size, GLsizei* length, GLchar* log) {
  if (size < 0) {
    c.raise(GL_INVALID_VALUE);
    return;
  }
  const Program* program = named_program(c, name);
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
