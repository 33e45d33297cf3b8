// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/layout.h"

#include <algorithm>
#include <array>
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
  // What is of a vertex says so in full; "tex" is to be found only in names of textures.
  for (std::size_t at = text.find("vertex"); at != std::string::npos; at = text.find("vertex", at + 4)) {
    text.erase(at + 4, 2);
  }
  return text;
}

bool is_vector_of_three_or_four(GLenum type) { return type == GL_FLOAT_VEC3 || type == GL_FLOAT_VEC4; }

bool may_be_direction(const Field& field) {
  return !is_builtin(field) && !field.is_array && is_vector_of_three_or_four(field.type);
}

bool may_be_coordinate(const Field& field) {
  return !is_builtin(field) && !field.is_array && (field.type == GL_FLOAT_VEC2 || may_be_direction(field));
}

struct RoleRule {
  Role role;
  const char* builtin;
  bool (*fits)(const Field&);
  std::initializer_list<std::string_view> words;  // the first that a name has wins
};

Field* find_told(std::vector<Field>& fields, const std::string& told) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return !told.empty() && (field.name == told || (field.location >= 0 && std::to_string(field.location) == told));
  });
  return found != fields.end() ? &*found : nullptr;
}

Field* find_by_name(std::vector<Field>& fields, const RoleRule& rule) {
  for (Field& field : fields) {
    if (field.name == rule.builtin) {
      return &field;
    }
  }
  for (const std::string_view word : rule.words) {
    for (Field& field : fields) {
      if (field.role == Role::other && rule.fits(field) && contains(lower_case(field.name), word)) {
        return &field;
      }
    }
  }
  return nullptr;
}

Field* find_at(std::vector<Field>& fields, int location) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return field.location == location && field.role == Role::other && may_be_direction(field);
  });
  return found != fields.end() ? &*found : nullptr;
}

bool names_something_else(const Field& field) {
  const std::string name = lower_case(field.name);
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"col", "rgb", "tan", "bin", "bitan", "tex", "uv", "weight", "joint",
                                              "bone", "vel", "off", "size", "scale", "inst", "pos", "vert", "coord"},
      [&](std::string_view word) { return contains(name, word); });
}

// Locations 1 and 2 are where programs that number their attributes have it; a vec4 is more often a colour.
Field* guess_normal(std::vector<Field>& fields) {
  Field* found = nullptr;
  for (const int location : {1, 2}) {
    Field* const candidate = find_at(fields, location);
    if (candidate == nullptr || candidate->type != GL_FLOAT_VEC3 || names_something_else(*candidate)) {
      continue;
    }
    if (found != nullptr) {
      return nullptr;
    }
    found = candidate;
  }
  return found;
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

void assign_roles(std::vector<Field>& fields, const core::AttributeRoles& told) {
  const RoleRule rules[] = {
      {Role::normal, "gl_Normal", may_be_direction, {"normal", "nrm", "norm"}},
      {Role::texture_coordinate, "gl_MultiTexCoord0", may_be_coordinate, {"texcoord", "texture", "tex", "uv"}},
      {Role::position, "gl_Vertex", may_be_direction, {"position", "vert", "pos", "coord"}}};
  const std::string* const names[] = {&told.normal, &told.texture_coordinate, &told.position};
  const auto assign = [](Field* field, Role role) {
    if (field != nullptr && field->role == Role::other) {
      field->role = role;
    }
    return field != nullptr;
  };
  // What is told first: a guess must not take it.
  std::array<bool, 3> known{};
  for (std::size_t i = 0; i < known.size(); ++i) {
    known[i] = assign(find_told(fields, *names[i]), rules[i].role);
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    known[i] = known[i] || assign(find_by_name(fields, rules[i]), rules[i].role);
  }
  if (!known[2]) {
    assign(find_at(fields, 0), Role::position);
  }
  if (!known[0]) {
    assign(guess_normal(fields), Role::normal);
  }
}

std::string roles_text(const std::vector<Field>& fields) {
  const auto name = [&](Role role) {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.role == role; });
    return found != fields.end() ? found->name : std::string("unknown");
  };
  return "the position is " + name(Role::position) + ", the normal " + name(Role::normal) +
         ", the texture coordinate " + name(Role::texture_coordinate);
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
