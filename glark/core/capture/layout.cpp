// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/layout.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

namespace glark::capture {
namespace {

enum class Kind { floating, integer, wide };

struct TypeRow {
  GLenum type;
  const char* glsl;
  int columns;
  int rows;
  Kind kind;

  int words() const { return columns * rows * (kind == Kind::wide ? 2 : 1); }
};

constexpr TypeRow type_rows[] = {
    {GL_FLOAT, "float", 1, 1, Kind::floating},
    {GL_FLOAT_VEC2, "vec2", 1, 2, Kind::floating},
    {GL_FLOAT_VEC3, "vec3", 1, 3, Kind::floating},
    {GL_FLOAT_VEC4, "vec4", 1, 4, Kind::floating},
    {GL_FLOAT_MAT2, "mat2", 2, 2, Kind::floating},
    {GL_FLOAT_MAT2x3, "mat2x3", 2, 3, Kind::floating},
    {GL_FLOAT_MAT2x4, "mat2x4", 2, 4, Kind::floating},
    {GL_FLOAT_MAT3x2, "mat3x2", 3, 2, Kind::floating},
    {GL_FLOAT_MAT3, "mat3", 3, 3, Kind::floating},
    {GL_FLOAT_MAT3x4, "mat3x4", 3, 4, Kind::floating},
    {GL_FLOAT_MAT4x2, "mat4x2", 4, 2, Kind::floating},
    {GL_FLOAT_MAT4x3, "mat4x3", 4, 3, Kind::floating},
    {GL_FLOAT_MAT4, "mat4", 4, 4, Kind::floating},
    {GL_INT, "int", 1, 1, Kind::integer},
    {GL_INT_VEC2, "ivec2", 1, 2, Kind::integer},
    {GL_INT_VEC3, "ivec3", 1, 3, Kind::integer},
    {GL_INT_VEC4, "ivec4", 1, 4, Kind::integer},
    {GL_UNSIGNED_INT, "uint", 1, 1, Kind::integer},
    {GL_UNSIGNED_INT_VEC2, "uvec2", 1, 2, Kind::integer},
    {GL_UNSIGNED_INT_VEC3, "uvec3", 1, 3, Kind::integer},
    {GL_UNSIGNED_INT_VEC4, "uvec4", 1, 4, Kind::integer},
    {GL_DOUBLE, "double", 1, 1, Kind::wide},
    {GL_DOUBLE_VEC2, "dvec2", 1, 2, Kind::wide},
    {GL_DOUBLE_VEC3, "dvec3", 1, 3, Kind::wide},
    {GL_DOUBLE_VEC4, "dvec4", 1, 4, Kind::wide},
    {GL_DOUBLE_MAT2, "dmat2", 2, 2, Kind::wide},
    {GL_DOUBLE_MAT2x3, "dmat2x3", 2, 3, Kind::wide},
    {GL_DOUBLE_MAT2x4, "dmat2x4", 2, 4, Kind::wide},
    {GL_DOUBLE_MAT3x2, "dmat3x2", 3, 2, Kind::wide},
    {GL_DOUBLE_MAT3, "dmat3", 3, 3, Kind::wide},
    {GL_DOUBLE_MAT3x4, "dmat3x4", 3, 4, Kind::wide},
    {GL_DOUBLE_MAT4x2, "dmat4x2", 4, 2, Kind::wide},
    {GL_DOUBLE_MAT4x3, "dmat4x3", 4, 3, Kind::wide},
    {GL_DOUBLE_MAT4, "dmat4", 4, 4, Kind::wide},
};

const TypeRow* row_of(GLenum type) {
  const auto* found =
      std::find_if(std::begin(type_rows), std::end(type_rows), [type](const TypeRow& row) { return row.type == type; });
  return found != std::end(type_rows) ? found : nullptr;
}

// A word in a name does not count if it is a part of a longer word with another meaning.
struct LongerWord {
  std::string_view text;
  std::size_t at;         // where the part begins
  std::string_view part;  // or a word that begins with it
};
constexpr LongerWord longer_words[] = {{"vertex", 3, "tex"}, {"normaliz", 0, "norm"}, {"normalis", 0, "norm"}};

bool contains(const std::string& lower, std::string_view word) {
  const auto is_part = [&](std::size_t at) {
    return std::ranges::any_of(longer_words, [&](const LongerWord& longer) {
      return word.size() < longer.text.size() && word.starts_with(longer.part) && at >= longer.at &&
             lower.compare(at - longer.at, longer.text.size(), longer.text) == 0;
    });
  };
  std::size_t at = lower.find(word);
  while (at != std::string::npos && is_part(at)) {
    at = lower.find(word, at + 1);
  }
  return at != std::string::npos;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
  std::initializer_list<std::string_view> words;  // the first word that a name contains decides
};

Field* find_told(std::vector<Field>& fields, const std::string& told) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return !told.empty() && (field.name == told || (field.location >= 0 && std::to_string(field.location) == told));
  });
  return found != fields.end() ? &*found : nullptr;
}

// ANGLE, which draws the pages of browsers, puts "_u" before each name: "vPosition" is "_uvPosition" and has no "uv".
constexpr std::string_view angle_prefix = "_u";

bool are_named_by_angle(const std::vector<Field>& fields) {
  return std::ranges::all_of(
      fields, [](const Field& field) { return is_builtin(field) || field.name.starts_with(angle_prefix); });
}

std::string words_of_name(const Field& field, bool by_angle) {
  return lower_case(by_angle && !is_builtin(field) ? field.name.substr(angle_prefix.size()) : field.name);
}

Field* find_by_name(std::vector<Field>& fields, const RoleRule& rule) {
  for (Field& field : fields) {
    if (field.name == rule.builtin) {
      return &field;
    }
  }
  const bool by_angle = are_named_by_angle(fields);
  for (const std::string_view word : rule.words) {
    for (Field& field : fields) {
      if (field.role == Role::other && rule.fits(field) && contains(words_of_name(field, by_angle), word)) {
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

bool names_something_else(const Field& field, bool by_angle) {
  const std::string name = words_of_name(field, by_angle);
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"col",    "rgb",   "tan",  "bin",   "bitan",    "tex",     "uv",
                                              "weight", "joint", "bone", "vel",   "off",      "size",    "scale",
                                              "inst",   "pos",   "vert", "coord", "normaliz", "normalis"},
      [&](std::string_view word) { return contains(name, word); });
}

// Programs that number their attributes have the normal at location 1 or 2; a vec4 is more often a colour.
Field* guess_normal(std::vector<Field>& fields) {
  const bool by_angle = are_named_by_angle(fields);
  Field* found = nullptr;
  for (const int location : {1, 2}) {
    Field* const candidate = find_at(fields, location);
    if (candidate == nullptr || candidate->type != GL_FLOAT_VEC3 || names_something_else(*candidate, by_angle)) {
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
  return row != nullptr ? row->words() : 0;
}

int columns_of(GLenum type) {
  const TypeRow* row = row_of(type);
  return row != nullptr ? row->columns : 0;
}

bool is_integer(GLenum type) {
  const TypeRow* row = row_of(type);
  return row != nullptr && row->kind == Kind::integer;
}

bool is_wide(GLenum type) {
  const TypeRow* row = row_of(type);
  return row != nullptr && row->kind == Kind::wide;
}

bool is_constant_in_draw(const Field& field) {
  return field.name == "gl_InstanceID" || field.name == "gl_BaseVertex" || field.name == "gl_BaseInstance" ||
         field.name == "gl_DrawID";
}

bool is_builtin(const Field& field) { return field.name.rfind("gl_", 0) == 0; }

Layout make_layout(std::vector<Field> fields, bool tagged, WeldedWords welded) {
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
  if (welded.controls) {
    layout.control_offset = layout.corner_words;
    layout.corner_words += control_words;
  }
  if (welded.turns) {
    layout.turn_offset = layout.corner_words++;
  }
  if (welded.displaced_by >= 0) {
    layout.border_offset = layout.corner_words;
    layout.coordinate_offset = layout.fields[static_cast<std::size_t>(welded.displaced_by)].offset;
    layout.corner_words += border_words;
  }
  return layout;
}

void assign_roles(std::vector<Field>& fields, const core::AttributeRoles& told) {
  const RoleRule rules[] = {
      {Role::normal, "gl_Normal", may_be_direction, {"normal", "nrm", "norm"}},
      {Role::texture_coordinate, "gl_MultiTexCoord0", may_be_coordinate, {"texcoord", "texture", "tex", "uv"}},
      {Role::position, "gl_Vertex", may_be_direction, {"position", "vertex", "pos", "vert", "coord"}}};
  const std::string* const names[] = {&told.normal, &told.texture_coordinate, &told.position};
  const auto assign = [](Field* field, Role role) {
    if (field != nullptr && field->role == Role::other) {
      field->role = role;
    }
    return field != nullptr;
  };
  // The roles that the user set come first: a guess must not take their inputs.
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

const Field* find_role(const std::vector<Field>& fields, Role role) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.role == role; });
  return found != fields.end() ? &*found : nullptr;
}

bool can_curve(const std::vector<Field>& fields) {
  return std::ranges::all_of(std::initializer_list<Role>{Role::position, Role::normal}, [&](Role role) {
    const Field* field = find_role(fields, role);
    return field != nullptr && !field->is_array && (field->type == GL_FLOAT_VEC3 || field->type == GL_FLOAT_VEC4);
  });
}

int normal_offset(const std::vector<Field>& fields) {
  const Field* normal = find_role(fields, Role::normal);
  return normal != nullptr ? normal->offset : -1;
}

std::string roles_text(const std::vector<Field>& fields) {
  const auto name = [&](Role role) {
    const Field* field = find_role(fields, role);
    return field != nullptr ? field->name : std::string("unknown");
  };
  return "the position is " + name(Role::position) + ", the normal " + name(Role::normal) +
         ", the texture coordinate " + name(Role::texture_coordinate);
}

std::string copied_input_name(int number) { return "glark_in" + std::to_string(number); }

namespace {

// Puts the text of a capture shader together.
class CaptureText {
 public:
  explicit CaptureText(CaptureSources& result) : result_(result) {}

  void add(const Field& field) {
    const TypeRow& row = *row_of(field.type);
    const std::string array = field.is_array ? "[" + std::to_string(field.array_size) + "]" : "";
    const std::string input = field.made            ? std::string(row.glsl) + "(0.0)"
                              : field.location >= 0 ? declare_input(row.glsl, array, field.location)
                                                    : builtin(field.name);
    for (int element = 0; element < field.array_size; ++element) {
      const std::string value = field.is_array ? input + "[" + std::to_string(element) + "]" : input;
      if (field.location >= 0 && row.kind != Kind::wide)
        note_first_components(row, value, field.location + element * row.columns);
      if (row.kind == Kind::wide) {
        add_wide(row, value);
      } else {
        add_output(row.kind == Kind::integer ? "flat out " : "out ", row.glsl, value);
      }
    }
  }

  void add_tag(GLuint attribute) {
    const auto known = first_components_.find(static_cast<int>(attribute));
    add_output(
        "out ", "float",
        known != first_components_.end() ? known->second : declare_input("float", "", static_cast<int>(attribute)));
  }

  // Words that later passes write.
  void add_room(int words) {
    for (int word = 0; word < words; ++word) add_output("out ", "float", "0.0");
  }

  std::string text(Language language) const {
    const char* version = language == Language::es ? "#version 320 es\nprecision highp float;\nprecision highp int;\n"
                          : language == Language::core ? "#version 430 core\n"
                                                       : "#version 430 compatibility\n";
    const char* extension = draw_parameters_ ? "#extension GL_ARB_shader_draw_parameters : require\n" : "";
    return std::string(version) + extension + declarations_ + "void main() {\n" + body_ +
           "  gl_Position = vec4(0.0);\n}\n";
  }

 private:
  std::string declare_input(const std::string& type, const std::string& array, int location) {
    std::string name = copied_input_name(inputs_++);
    declarations_ += "layout(location = " + std::to_string(location) + ") in " + type + " " + name + array + ";\n";
    return name;
  }

  // In OpenGL ES two inputs cannot have one location: if the program reads the tag itself, the capture takes it from
  // that input.
  void note_first_components(const TypeRow& row, const std::string& value, int location) {
    for (int column = 0; column < row.columns; ++column) {
      std::string component = row.columns > 1 ? value + "[" + std::to_string(column) + "]" : value;
      if (row.rows > 1) component += "[0]";
      first_components_[location + column] = row.kind == Kind::integer ? "float(" + component + ")" : component;
    }
  }

  std::string builtin(const std::string& name) {
    if (name != "gl_BaseVertex" && name != "gl_BaseInstance" && name != "gl_DrawID") return name;
    draw_parameters_ = true;
    return name + "ARB";
  }

  // Captures doubles as pairs of unsigned integers, two doubles at a time: not every driver captures outputs that are
  // doubles.
  void add_wide(const TypeRow& row, const std::string& value) {
    for (int column = 0; column < row.columns; ++column) {
      const std::string vector = row.columns > 1 ? value + "[" + std::to_string(column) + "]" : value;
      const auto half = [&](int component) {
        return "unpackDouble2x32(" + (row.rows > 1 ? vector + "[" + std::to_string(component) + "]" : vector) + ")";
      };
      for (int component = 0; component < row.rows; component += 2) {
        const bool pair = component + 1 < row.rows;
        add_output("flat out ", pair ? "uvec4" : "uvec2",
                   pair ? "uvec4(" + half(component) + ", " + half(component + 1) + ")" : half(component));
      }
    }
  }

  void add_output(const std::string& storage, const std::string& type, const std::string& value) {
    const std::string name = "glark_out" + std::to_string(outputs_++);
    declarations_ += storage + type + " " + name + ";\n";
    body_ += "  " + name + " = " + value + ";\n";
    result_.varyings.push_back(name);
  }

  CaptureSources& result_;
  std::string declarations_;
  std::string body_;
  std::map<int, std::string> first_components_;  // by location, of inputs that are declared
  int inputs_ = 0;
  int outputs_ = 0;
  bool draw_parameters_ = false;
};

}  // namespace

CaptureSources capture_sources(const Layout& layout, Language language, GLuint tag_attribute) {
  CaptureSources result;
  CaptureText text(result);
  for (const Field& field : layout.fields) text.add(field);
  if (layout.tagged) text.add_tag(tag_attribute);
  const int welded_words = (layout.welded() ? control_words : 0) + (layout.turn_offset >= 0 ? 1 : 0) +
                           (layout.displaced() ? border_words : 0);
  if (welded_words > 0) text.add_room(welded_words);
  result.vertex = text.text(language);
  return result;
}

}  // namespace glark::capture
