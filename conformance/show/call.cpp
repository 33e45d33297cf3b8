// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/show/call.h"

#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace glark::conformance {

CallSink call_sink;

namespace {

constexpr std::size_t longest_inside = 60;  // characters of an array that stands in the call

std::string in_hexadecimal(std::uint32_t value) { return fmt::format("{:#x}", value); }

std::string_view name_of(std::string_view group, std::uint32_t value) {
  const std::string_view name = call_sink.name_of_value(group, value);
  return name.empty() && value > 0xff ? call_sink.name_of_value("", value) : name;
}

// Returns whether the words are numbers that someone may have written.
bool are_floats(const std::vector<float>& words) {
  for (const float each : words)
    if (each != 0 && !(std::abs(each) > 1e-6F && std::abs(each) < 1e6F)) return false;
  return true;
}

int components_of(GLenum format) {
  switch (format) {
    case GL_RG:
    case GL_RG_INTEGER:
    case GL_LUMINANCE_ALPHA: return 2;
    case GL_RGB:
    case GL_BGR:
    case GL_RGB_INTEGER: return 3;
    case GL_RGBA:
    case GL_BGRA:
    case GL_RGBA_INTEGER: return 4;
    default: return 1;
  }
}

// The bytes of a component; 0 for packed types.
int size_of(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT: return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT: return 4;
    default: return 0;
  }
}

}  // namespace

void Call::add(std::string_view argument) {
  if (has_arguments_) text_ += ", ";
  text_ += argument;
  has_arguments_ = true;
}

std::string Call::signed_text(long long value) { return std::to_string(value); }

std::string Call::text_of(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "NAN" : value > 0 ? "INFINITY" : "-INFINITY";
  const std::string text = fmt::format("{}", static_cast<float>(value) == value ? static_cast<float>(value) : value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

void Call::number(double value) { add(text_of(value)); }
void Call::number(float value) { add(text_of(value)); }

void Call::value(GLenum value, std::string_view group) {
  const std::string_view name = name_of(group, value);
  add(name.empty() ? in_hexadecimal(value) : std::string(name));
}

void Call::flags(GLbitfield flags, std::string_view group) {
  std::string text;
  GLbitfield rest = flags;
  for (unsigned bit = 0; bit < 32; ++bit) {
    const std::string_view name = (flags & (1U << bit)) != 0 ? call_sink.name_of_value(group, 1U << bit) : "";
    if (name.empty()) continue;
    text += (text.empty() ? "" : " | ") + std::string(name);
    rest &= ~(1U << bit);
  }
  const std::string_view whole = call_sink.name_of_value(group, flags);
  if (!whole.empty() && flags != 0)
    add(whole);
  else
    add(rest == 0 && !text.empty() ? text : in_hexadecimal(flags));
}

void Call::number_or_value(GLint value, std::string_view group) {
  const std::string_view name = value > 0xff ? name_of(group, static_cast<std::uint32_t>(value)) : "";
  add(name.empty() ? std::to_string(value) : std::string(name));
}

void Call::text(const GLchar* text) { add(text == nullptr ? "NULL" : c_string(text)); }

void Call::texts(const GLchar* const* texts, GLsizei count) {
  std::string all;
  for (GLsizei i = 0; texts != nullptr && i < count; ++i)
    all += (i == 0 ? "\n      " : ",\n      ") + c_string(texts[i]);
  add(all.empty() ? "NULL" : "(const GLchar *const[]){" + all + "}");
}

void Call::pointer(const void* pointer) {
  if (pointer == nullptr) return add("NULL");
  add(is_offset(pointer) ? fmt::format("(void *){}", reinterpret_cast<std::uintptr_t>(pointer))
                         : "NULL /* memory of the case */");
}

void Call::result_pointer(const void* pointer) { is_offset(pointer) ? this->pointer(pointer) : add("results"); }

void Call::add_array(std::string_view type, std::size_t count, const std::string& elements) {
  if (elements.size() <= longest_inside) return add(fmt::format("(const {}[]){{{}}}", type, elements));
  add(call_sink.program->array(type, count, elements));
}

void Call::bytes(const void* data, long long size) {
  if (is_offset(data)) return pointer(data);
  if (size <= 0 || size > 1 << 24) return add("NULL");
  if (size % 2 != 0) return array("GLubyte", static_cast<const GLubyte*>(data), size);
  if (size % 4 != 0) return array("GLushort", static_cast<const GLushort*>(data), size / 2);
  std::vector<float> floats(static_cast<std::size_t>(size) / 4);
  std::memcpy(floats.data(), data, static_cast<std::size_t>(size));
  if (are_floats(floats)) return array("GLfloat", floats.data(), size / 4);
  std::string elements;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    std::uint32_t word = 0;
    std::memcpy(&word, &floats[i], 4);
    elements += (i == 0 ? "" : ", ") + in_hexadecimal(word);
  }
  add_array("GLuint", floats.size(), elements);
}

void Call::pixels(const void* data, GLenum format, GLenum type, std::initializer_list<GLsizei> sizes) {
  GLint buffer = 0;
  GLint alignment = 4;
  call_sink.real->GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer);
  call_sink.real->GetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  const long long row = static_cast<long long>(*sizes.begin()) * components_of(format) * size_of(type);
  if (buffer != 0 || data == nullptr) return pointer(data);
  if (row == 0) return add("NULL /* pixels of the case */");
  long long rows = 1;
  for (const GLsizei each : sizes) rows *= each;
  rows /= *sizes.begin();
  bytes(data, (row + alignment - 1) / alignment * alignment * (rows - 1) + row);
}

void Call::begin() { text_ += ");"; }

void Call::end() { finish(results_ == nullptr ? "" : read_results_(results_, result_count_)); }

void Call::finish(const std::string& comment) {
  call_sink.program->add(comment.empty() ? text_ : text_ + "  // gives " + comment);
}

long long values_of_parameter(GLenum parameter) {
  switch (parameter) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_POSITION:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
    case GL_TEXTURE_SWIZZLE_RGBA: return 4;
    case GL_SPOT_DIRECTION:
    case GL_COLOR_INDEXES:
    case GL_POINT_DISTANCE_ATTENUATION: return 3;
    default: return 1;
  }
}

}  // namespace glark::conformance
