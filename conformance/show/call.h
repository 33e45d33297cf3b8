// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One call of OpenGL on its way into a CProgram.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

#include "conformance/gl/gl.h"
#include "conformance/show/c_program.h"

namespace glark::conformance {

// A value of GLenum or GLbitfield. Values outside of a group have the group "".
struct NamedValue {
  std::string_view group;
  std::uint32_t value;
  std::string_view name;
};

// Where calls go, the functions that make them, and what values are called. Set before the first call.
struct CallSink {
  CProgram* program = nullptr;
  const GladGLContext* real = nullptr;
  std::string_view (*name_of_value)(std::string_view group, std::uint32_t value) = nullptr;
};
extern CallSink call_sink;

class Call {
 public:
  explicit Call(const char* name) : text_(name) { text_ += '('; }

  void number(double value);
  void number(float value);
  template <typename Integer>
  requires std::is_integral_v<Integer>
  void number(Integer value) {
    add(std::is_signed_v<Integer> ? signed_text(static_cast<long long>(value))
                                  : std::to_string(static_cast<unsigned long long>(value)));
  }
  void boolean(GLboolean value) { add(value == GL_FALSE ? "GL_FALSE" : value == GL_TRUE ? "GL_TRUE" : "2"); }
  void value(GLenum value, std::string_view group);
  void flags(GLbitfield flags, std::string_view group);
  // A parameter whose name decides whether it is a number.
  void number_or_value(GLint value, std::string_view group);
  void sync() { add("sync"); }
  void other() { add("NULL"); }  // a callback
  void text(const GLchar* text);
  void texts(const GLchar* const* texts, GLsizei count);
  // An offset into a buffer, or an address, which means nothing outside of the process.
  void pointer(const void* pointer);
  // The same, where GL writes.
  void result_pointer(const void* pointer);
  template <typename Pointer>
  void pointers(Pointer* const* offsets, GLsizei count);
  void bytes(const void* data, long long size);
  void pixels(const void* data, GLenum format, GLenum type, std::initializer_list<GLsizei> sizes);
  template <typename T>
  void array(std::string_view type, const T* values, long long count);
  // Memory that GL writes.
  template <typename T>
  void result_array(std::string_view type, const T* values, long long count);

  void begin();
  void end();
  template <typename Result>
  void end(Result result);

 private:
  // No address of memory is so small.
  static bool is_offset(const void* pointer) { return reinterpret_cast<std::uintptr_t>(pointer) < 1U << 20U; }
  static std::string signed_text(long long value);
  static std::string text_of(double value);
  template <typename T>
  static std::string element(T value);
  void add(std::string_view argument);
  void add_array(std::string_view type, std::size_t count, const std::string& elements);
  void finish(const std::string& comment);

  std::string text_;
  bool has_arguments_ = false;
  const void* results_ = nullptr;  // what GL writes, if it is an array of at most 4 names or numbers
  std::string (*read_results_)(const void*, long long) = nullptr;
  long long result_count_ = 0;
};

// The number of values of a parameter of lights, materials, textures and so on.
long long values_of_parameter(GLenum parameter);

template <typename T>
std::string Call::element(T value) {
  if constexpr (std::is_floating_point_v<T>)
    return text_of(value);
  else if constexpr (std::is_signed_v<T>)
    return signed_text(static_cast<long long>(value));
  else
    return std::to_string(static_cast<unsigned long long>(value));
}

template <typename T>
void Call::array(std::string_view type, const T* values, long long count) {
  if (is_offset(values)) return pointer(values);
  if (count <= 0 || count > 1 << 20) return add("NULL");
  std::string elements;
  for (long long i = 0; i < count; ++i) elements += (i == 0 ? "" : ", ") + element(values[i]);
  add_array(type, static_cast<std::size_t>(count), elements);
}

template <typename Pointer>
void Call::pointers(Pointer* const* offsets, GLsizei count) {
  std::string elements;
  for (GLsizei i = 0; offsets != nullptr && i < count; ++i) {
    elements +=
        (i == 0 ? "(const void *)" : ", (const void *)") + std::to_string(reinterpret_cast<std::uintptr_t>(offsets[i]));
  }
  add(elements.empty() ? "NULL" : "(const void *[]){" + elements + "}");
}

template <typename T>
void Call::result_array(std::string_view, const T* values, long long count) {
  if (is_offset(values)) return pointer(values);
  add("(void *)results");
  if (count < 1 || count > 4) return;
  results_ = values;
  result_count_ = count;
  read_results_ = [](const void* at, long long number) {
    std::string text;
    for (long long i = 0; i < number; ++i) text += (i == 0 ? "" : ", ") + element(static_cast<const T*>(at)[i]);
    return text;
  };
}

template <typename Result>
void Call::end(Result result) {
  if constexpr (std::is_same_v<Result, GLsync>) {
    text_.insert(0, "sync = ");
    finish("");
  } else if constexpr (std::is_pointer_v<Result>) {
    finish("memory, which the case then reads or writes");
  } else {
    finish(element(result));
  }
}

}  // namespace glark::conformance
