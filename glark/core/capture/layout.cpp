// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/layout.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace glark::capture {
namespace {

struct TypeRow {
  GLenum type;
  const char* glsl;
  int words;
  bool integer;
};

constexpr TypeRow type_rows[] = {
    {GL_FLOAT, "float", 1, false},
    {GL_FLOAT_VEC2, "vec2", 2, false},
    {GL_FLOAT_VEC3, "vec3", 3, false},
    {GL_FLOAT_VEC4, "vec4", 4, false},
    {GL_FLOAT_MAT2, "mat2", 4, false},
    {GL_FLOAT_MAT3, "mat3", 9, false},
    {GL_FLOAT_MAT4, "mat4", 16, false},
    {GL_FLOAT_MAT2x3, "mat2x3", 6, false},
    {GL_FLOAT_MAT2x4, "mat2x4", 8, false},
    {GL_FLOAT_MAT3x2, "mat3x2", 6, false},
    {GL_FLOAT_MAT3x4, "mat3x4", 12, false},
    {GL_FLOAT_MAT4x2, "mat4x2", 8, false},
    {GL_FLOAT_MAT4x3, "mat4x3", 12, false},
    {GL_INT, "int", 1, true},
    {GL_INT_VEC2, "ivec2", 2, true},
    {GL_INT_VEC3, "ivec3", 3, true},
    {GL_INT_VEC4, "ivec4", 4, true},
    {GL_UNSIGNED_INT, "uint", 1, true},
    {GL_UNSIGNED_INT_VEC2, "uvec2", 2, true},
    {GL_UNSIGNED_INT_VEC3, "uvec3", 3, true},
    {GL_UNSIGNED_INT_VEC4, "uvec4", 4, true},
};

const TypeRow* row_of(GLenum type) {
  const auto* found =
      std::find_if(std::begin(type_rows), std::end(type_rows), [type](const TypeRow& row) { return row.type == type; });
  return found != std::end(type_rows) ? found : nullptr;
}

bool contains(const std::string& lower, std::string_view word) { return lower.find(word) != std::string::npos; }

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_vector_of_three_or_four(GLenum type) { return type == GL_FLOAT_VEC3 || type == GL_FLOAT_VEC4; }

Field* find_role(std::vector<Field>& fields, const char* builtin, std::initializer_list<std::string_view> words) {
  for (Field& field : fields) {
    if (field.name == builtin) {
      return &field;
    }
  }
  for (const std::string_view word : words) {
    for (Field& field : fields) {
      if (!is_builtin(field) && !field.is_array && is_vector_of_three_or_four(field.type) &&
          contains(lower_case(field.name), word)) {
        return &field;
      }
    }
  }
  return nullptr;
}

}  // namespace

int words_of(GLenum type) {
  const TypeRow* row = row_of(type);
  return row != nullptr ? row->words : 0;
}

bool is_integer(GLenum type) {
  const TypeRow* row = row_of(type);
  return row != nullptr && row->integer;
}

bool is_builtin(const Field& field) { return field.name.rfind("gl_", 0) == 0; }

Layout make_layout(std::vector<Field> fields, bool tagged) {
  Layout layout;
  layout.fields = std::move(fields);
  for (Field& field : layout.fields) {
    field.words = words_of(field.type) * field.array_size;
    field.offset = layout.corner_words;
    layout.corner_words += field.words;
  }
  layout.tagged = tagged;
  if (tagged) {
    layout.tag_offset = layout.corner_words++;
  }
  return layout;
}

void assign_roles(std::vector<Field>& fields) {
  Field* position = find_role(fields, "gl_Vertex", {"position", "vertex", "pos", "vert", "coord"});
  Field* normal = find_role(fields, "gl_Normal", {"normal", "nrm", "norm"});
  if (position == nullptr || position == normal) {
    position = nullptr;
    for (Field& field : fields) {
      if (field.location == 0 && &field != normal && !field.is_array && is_vector_of_three_or_four(field.type)) {
        position = &field;
      }
    }
  }
  if (position != nullptr) {
    position->role = Role::position;
  }
  if (normal != nullptr) {
    normal->role = Role::normal;
  }
}

int normal_offset(const std::vector<Field>& fields) {
  const auto normal =
      std::find_if(fields.begin(), fields.end(), [](const Field& field) { return field.role == Role::normal; });
  return normal != fields.end() ? normal->offset : -1;
}

CaptureSources capture_sources(const Layout& layout, Language language, GLuint tag_attribute) {
  CaptureSources result;
  std::string declarations;
  std::string body;
  int index = 0;
  const auto add = [&](const std::string& type, const std::string& array, const std::string& source, int location,
                       bool integer) {
    const std::string number = std::to_string(index++);
    std::string input = source;
    if (location >= 0) {
      input = "glark_in" + number;
      declarations += "layout(location = " + std::to_string(location) + ") in " + type + " " + input + array + ";\n";
    }
    declarations += (integer ? "flat out " : "out ") + type + " glark_out" + number + array + ";\n";
    body += "  glark_out" + number + " = " + input + ";\n";
    return "glark_out" + number;
  };
  for (const Field& field : layout.fields) {
    const std::string array = field.is_array ? "[" + std::to_string(field.array_size) + "]" : "";
    const std::string name = add(row_of(field.type)->glsl, array, field.name, field.location, is_integer(field.type));
    for (int element = 0; element < field.array_size; ++element) {
      result.varyings.push_back(field.is_array ? name + "[" + std::to_string(element) + "]" : name);
    }
  }
  if (layout.tagged) {
    result.varyings.push_back(add("float", "", "", static_cast<int>(tag_attribute), false));
  }
  const char* version = language == Language::es     ? "#version 320 es\nprecision highp float;\nprecision highp int;\n"
                        : language == Language::core ? "#version 430 core\n"
                                                     : "#version 430 compatibility\n";
  result.vertex = version + declarations + "void main() {\n" + body + "  gl_Position = vec4(0.0);\n}\n";
  if (language == Language::es) {
    result.fragment = "#version 320 es\nvoid main() {}\n";
  }
  return result;
}

}  // namespace glark::capture
