// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/core/support/state_snapshot.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace glark::core::test {
namespace {

constexpr std::size_t longest_answer = 4096;

std::string hexadecimal(GLenum name) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%04X", name);
  return text.data();
}

void drop_errors() {
  while (glGetError() != GL_NO_ERROR) {
  }
}

// Leaves out the time; free memory (GL_NVX_gpu_memory_info, GL_ATI_meminfo); and the device's identity
// (GL_EXT_memory_object, GL_EXT_memory_object_win32), for which OSMesa uses a null pointer.
bool is_left_out(GLenum name) {
  return name == GL_TIMESTAMP || (name >= 0x9047 && name <= 0x904B) || (name >= 0x87FB && name <= 0x87FD) ||
         (name >= 0x9596 && name <= 0x959A);
}

template <typename Get>
std::vector<GLenum> accepted(Get&& get) {
  std::vector<GLenum> names;
  drop_errors();
  for (GLenum name = 0; name <= 0xFFFF; ++name) {
    if (is_left_out(name)) continue;
    get(name);
    if (glGetError() == GL_NO_ERROR) names.push_back(name);
  }
  return names;
}

}  // namespace

StateSnapshot::Names StateSnapshot::find_names() {
  std::vector<GLfloat> floats(longest_answer);
  std::vector<GLint> integers(longest_answer);
  Names names;
  names.floats = accepted([&](GLenum name) { glGetFloatv(name, floats.data()); });
  names.integers = accepted([&](GLenum name) { glGetIntegerv(name, integers.data()); });
  names.enables = accepted([](GLenum name) { glIsEnabled(name); });
  names.pointers = accepted([](GLenum name) {
    void* pointer = nullptr;
    glGetPointerv(name, &pointer);
  });
  return names;
}

template <typename Value>
void StateSnapshot::store(const std::string& name, const std::vector<Value>& value) {
  values_[name] = std::string(reinterpret_cast<const char*>(value.data()), value.size() * sizeof(Value));
}

StateSnapshot StateSnapshot::take(const Names& names) {
  StateSnapshot snapshot;
  for (const GLenum name : names.floats) {
    std::vector<GLfloat> value(longest_answer);
    glGetFloatv(name, value.data());
    value.resize(64);
    snapshot.store("float " + hexadecimal(name), value);
  }
  for (const GLenum name : names.integers) {
    std::vector<GLint> value(longest_answer);
    glGetIntegerv(name, value.data());
    value.resize(64);
    snapshot.store("integer " + hexadecimal(name), value);
  }
  for (const GLenum name : names.enables) {
    snapshot.store("enable " + hexadecimal(name), std::vector<GLboolean>{glIsEnabled(name)});
  }
  for (const GLenum name : names.pointers) {
    void* pointer = nullptr;
    glGetPointerv(name, &pointer);
    snapshot.store("pointer " + hexadecimal(name), std::vector<void*>{pointer});
  }
  snapshot.take_indexed();
  snapshot.take_vertex_attributes();
  snapshot.take_textures();
  snapshot.take_queries();
  drop_errors();
  return snapshot;
}

void StateSnapshot::take_indexed() {
  struct Target {
    GLenum name;
    GLuint count;
  };
  const Target targets[] = {{GL_SHADER_STORAGE_BUFFER_BINDING, 16},
                            {GL_SHADER_STORAGE_BUFFER_START, 16},
                            {GL_SHADER_STORAGE_BUFFER_SIZE, 16},
                            {GL_UNIFORM_BUFFER_BINDING, 16},
                            {GL_UNIFORM_BUFFER_START, 16},
                            {GL_UNIFORM_BUFFER_SIZE, 16},
                            {GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 4},
                            {GL_TRANSFORM_FEEDBACK_BUFFER_START, 4},
                            {GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 4},
                            {GL_ATOMIC_COUNTER_BUFFER_BINDING, 4},
                            {GL_ATOMIC_COUNTER_BUFFER_START, 4},
                            {GL_ATOMIC_COUNTER_BUFFER_SIZE, 4},
                            {GL_IMAGE_BINDING_NAME, 8},
                            {GL_VERTEX_BINDING_BUFFER, 16},
                            {GL_VERTEX_BINDING_OFFSET, 16},
                            {GL_VERTEX_BINDING_STRIDE, 16},
                            {GL_VERTEX_BINDING_DIVISOR, 16}};
  for (const auto& [name, count] : targets) {
    for (GLuint i = 0; i < count; ++i) {
      GLint64 value = -1;
      glGetInteger64i_v(name, i, &value);
      store("indexed " + hexadecimal(name) + "[" + std::to_string(i) + "]", std::vector<GLint64>{value});
    }
  }
}

void StateSnapshot::take_vertex_attributes() {
  const GLenum names[] = {GL_VERTEX_ATTRIB_ARRAY_ENABLED,   GL_VERTEX_ATTRIB_ARRAY_SIZE,
                          GL_VERTEX_ATTRIB_ARRAY_STRIDE,    GL_VERTEX_ATTRIB_ARRAY_TYPE,
                          GL_VERTEX_ATTRIB_ARRAY_INTEGER,   GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
                          GL_VERTEX_ATTRIB_ARRAY_DIVISOR,   GL_VERTEX_ATTRIB_BINDING,
                          GL_VERTEX_ATTRIB_RELATIVE_OFFSET, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING};
  for (GLuint attribute = 0; attribute < 16; ++attribute) {
    const std::string label = "attribute " + std::to_string(attribute) + " ";
    for (const GLenum name : names) {
      GLint value = -1;
      glGetVertexAttribiv(attribute, name, &value);
      store(label + hexadecimal(name), std::vector<GLint>{value});
    }
    std::vector<GLfloat> current(4);
    glGetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, current.data());
    store(label + "current", current);
    void* pointer = nullptr;
    glGetVertexAttribPointerv(attribute, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    store(label + "pointer", std::vector<void*>{pointer});
  }
}

void StateSnapshot::take_textures() {
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLuint unit = 0; unit < 16; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum name : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP,
                              GL_TEXTURE_BINDING_BUFFER, GL_SAMPLER_BINDING}) {
      GLint value = -1;
      glGetIntegerv(name, &value);
      store("unit " + std::to_string(unit) + " " + hexadecimal(name), std::vector<GLint>{value});
    }
  }
  glActiveTexture(static_cast<GLenum>(active));
}

void StateSnapshot::take_queries() {
  for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
                              GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED}) {
    GLint value = -1;
    glGetQueryiv(target, GL_CURRENT_QUERY, &value);
    store("query " + hexadecimal(target), std::vector<GLint>{value});
  }
}

std::vector<std::string> StateSnapshot::differing_names(const StateSnapshot& other) const {
  std::vector<std::string> names;
  for (const auto& [name, value] : values_) {
    const auto found = other.values_.find(name);
    if (found == other.values_.end() || found->second != value) names.push_back(name);
  }
  return names;
}

std::string StateSnapshot::difference(const StateSnapshot& other, const std::vector<std::string>& except) const {
  std::string text;
  for (const std::string& name : differing_names(other)) {
    if (std::find(except.begin(), except.end(), name) != except.end()) continue;
    const std::string& a = values_.at(name);
    const std::string& b = other.values_.at(name);
    std::array<GLint, 4> before{};
    std::array<GLint, 4> after{};
    std::memcpy(before.data(), a.data(), std::min(sizeof(before), a.size()));
    std::memcpy(after.data(), b.data(), std::min(sizeof(after), b.size()));
    text += name + ": " + std::to_string(before[0]) + " " + std::to_string(before[1]) + " became " +
            std::to_string(after[0]) + " " + std::to_string(after[1]) + "\n";
  }
  return text;
}

}  // namespace glark::core::test
