// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the queries: the extension's own state, its name among the extensions, and its errors.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "glark/core/parameters.h"
#include "glark/core/track/complain.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

GLint tag_array_parameter(const Context& c, GLenum parameter) {
  GLint value = 0;
  c.gl().GetVertexAttribiv(c.ark().tag_attribute, parameter, &value);
  return value;
}

// Returns the value of a state of the extension; empty for any other name.
std::optional<GLdouble> extension_state(const Context& c, GLenum name) {
  if (!c.capabilities().refinable) {
    return std::nullopt;
  }
  const ArkState& ark = c.ark();
  switch (name) {
    case GL_ARK: return ark.enabled ? 1 : 0;
    case GL_MAX_DEPTH_ARK: return static_cast<GLint>(max_supported_level);
    case GL_POOL_LEVEL_ARK: return ark.pool_level;
    case GL_CURRENT_DEPTH_TAG_ARK: return static_cast<GLint>(track::current_tag(c));
    case GL_DEPTH_TAG_ARRAY_ARK: return tag_array_parameter(c, GL_VERTEX_ATTRIB_ARRAY_ENABLED);
    case GL_DEPTH_TAG_ARRAY_TYPE_ARK: return tag_array_parameter(c, GL_VERTEX_ATTRIB_ARRAY_TYPE);
    case GL_DEPTH_TAG_ARRAY_STRIDE_ARK: return tag_array_parameter(c, GL_VERTEX_ATTRIB_ARRAY_STRIDE);
    case GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK: return tag_array_parameter(c, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING);
    default: break;
  }
  const Parameter* parameter = find_parameter(name);
  return parameter != nullptr ? std::optional(parameter->get(ark)) : std::nullopt;
}

template <typename Integer>
Integer nearest_integer(GLdouble value) {
  constexpr auto least = static_cast<GLdouble>(std::numeric_limits<Integer>::min());
  if (value >= -least) {  // the greatest integer of 64 bits is no double
    return std::numeric_limits<Integer>::max();
  }
  return static_cast<Integer>(std::round(std::max(value, least)));
}

// Writes our state, or leaves the query to GL. Returns whether it was ours.
template <typename Value>
bool answer(Context& c, GLenum name, Value* data) {
  constexpr GLenum last_name = 0x6F3F;  // of the block of tokens
  const std::optional<GLdouble> value = name >= GL_ARK && name <= last_name ? extension_state(c, name) : std::nullopt;
  if (!value.has_value()) {
    return false;
  }
  if (!track::inside_begin(c, "glGet") && data != nullptr) {
    if constexpr (std::is_same_v<Value, GLboolean>) {
      *data = *value != 0 ? GL_TRUE : GL_FALSE;
    } else if constexpr (std::is_integral_v<Value>) {
      *data = nearest_integer<Value>(*value);
    } else {
      *data = static_cast<Value>(*value);
    }
  }
  return true;
}

// While a list is cut into segments, GL's current list is a segment of ours.
template <typename Value>
void correct_list_index(const Context& c, GLenum name, Value* data) {
  if (name == GL_LIST_INDEX && c.state().lists().cutting() && data != nullptr) {
    *data = static_cast<Value>(c.state().lists().name());
  }
}

// Between our draws, GL's transform feedback is paused, and the application's is not.
template <typename Value>
void correct_paused_feedback(const Context& c, GLenum name, Value* data) {
  if (name == GL_TRANSFORM_FEEDBACK_PAUSED && data != nullptr && c.stages() != nullptr &&
      c.stages()->feedback().ours() && c.stages()->feedback().captures()) {
    *data = 0;
  }
}

template <typename Value>
void correct_extension_count(const Context& c, GLenum name, Value* data) {
  if (name == GL_NUM_EXTENSIONS && c.capabilities().refinable && data != nullptr) {
    *data = static_cast<Value>(*data + 1);
  }
}

template <typename Value, typename Function>
void get(Context& c, GLenum name, Value* data, const Function& from_gl) {
  if (!answer(c, name, data)) {
    from_gl(name, data);
    correct_extension_count(c, name, data);
    correct_list_index(c, name, data);
    correct_paused_feedback(c, name, data);
  }
}

}  // namespace

namespace track {

GLuint current_tag(const Context& c) {
  GLfloat value[4] = {0, 0, 0, 0};
  c.gl().GetVertexAttribfv(c.ark().tag_attribute, GL_CURRENT_VERTEX_ATTRIB, value);
  const float limit = static_cast<float>(std::max(c.ark().pool_level, 0));
  return std::isnan(value[0]) ? 0 : static_cast<GLuint>(std::clamp(std::round(value[0]), 0.0F, limit));
}

bool inside_begin(Context& c, const char* function) {
  if (c.state().immediate().open()) {
    complain(c, GL_INVALID_OPERATION, function, "it is called between glBegin and glEnd");
  }
  return c.state().immediate().open();
}

}  // namespace track

namespace hook {

void GetBooleanv(Context& c, GLenum name, GLboolean* data) {
  if (!answer(c, name, data)) {
    c.gl().GetBooleanv(name, data);
    correct_paused_feedback(c, name, data);
  }
}

void GetIntegerv(Context& c, GLenum name, GLint* data) { get(c, name, data, c.gl().GetIntegerv); }

void GetFloatv(Context& c, GLenum name, GLfloat* data) { get(c, name, data, c.gl().GetFloatv); }

void GetDoublev(Context& c, GLenum name, GLdouble* data) { get(c, name, data, c.gl().GetDoublev); }

void GetInteger64v(Context& c, GLenum name, GLint64* data) { get(c, name, data, c.gl().GetInteger64v); }

void GetTransformFeedbackiv(Context& c, GLuint id, GLenum name, GLint* data) {
  c.gl().GetTransformFeedbackiv(id, name, data);
  if (id == c.state().bindings().transform_feedback.object) {
    correct_paused_feedback(c, name, data);
  }
}

void GetPointerv(Context& c, GLenum name, void** data) {
  if (c.capabilities().refinable && name == GL_DEPTH_TAG_ARRAY_POINTER_ARK && data != nullptr) {
    c.gl().GetVertexAttribPointerv(c.ark().tag_attribute, GL_VERTEX_ATTRIB_ARRAY_POINTER, data);
    return;
  }
  c.gl().GetPointerv(name, data);
}

// We may have set the application's own errors aside. They are older than ours, but GL may return errors in any order.
GLenum GetError(Context& c) {
  if (c.state().immediate().open()) {
    return c.gl().GetError();
  }
  const GLenum error = c.pending_error().take();
  return error != GL_NO_ERROR ? error : c.gl().GetError();
}

const GLubyte* GetString(Context& c, GLenum name) {
  const GLubyte* text = c.gl().GetString(name);
  if (name != GL_EXTENSIONS || text == nullptr || !c.capabilities().refinable) {
    return text;
  }
  return reinterpret_cast<const GLubyte*>(c.capabilities().extension_string.c_str());
}

const GLubyte* GetStringi(Context& c, GLenum name, GLuint index) {
  if (name == GL_EXTENSIONS && c.capabilities().refinable) {
    GLint count = 0;
    c.gl().GetIntegerv(GL_NUM_EXTENSIONS, &count);
    if (index == static_cast<GLuint>(count)) {
      return reinterpret_cast<const GLubyte*>(extension_name.data());
    }
  }
  return c.gl().GetStringi(name, index);
}

}  // namespace hook
}  // namespace glark::core
