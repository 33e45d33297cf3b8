// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/stage_program.h"

#include <fmt/core.h>

namespace glark::conformance {
namespace {

constexpr char inputs[] =
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "layout(location = 3) in vec4 colours; layout(location = 6) in vec4 extra;\n"
    "layout(std140) uniform Block { vec4 block_tint; };\n"
    "out vec4 colour; flat out vec4 hue;\n";

constexpr char more_inputs[] =
    "layout(location = 7) in ivec4 steps; layout(location = 8) in mat2x4 columns;\n"
    "vec4 of_columns() { return 0.5 * shown(columns[0]).yzwx + 0.4 * shown(columns[1]).zwxy; }\n"
    "vec4 of_integers() { return 0.125 * vec4(steps); }\n";
constexpr char no_more_inputs[] =
    "vec4 of_columns() { return vec4(0.0); }\n"
    "vec4 of_integers() { return vec4(0.5, 0.2, 0.1, 0.3); }\n";

// One number of each kind of uniform.
constexpr char sums[] =
    "float sum(float a) { return a; }\n"
    "float sum(vec2 a) { return dot(a, vec2(0.7, 0.4)); }\n"
    "float sum(vec3 a) { return dot(a, vec3(0.7, 0.4, 0.3)); }\n"
    "float sum(vec4 a) { return dot(a, vec4(0.7, 0.4, 0.3, 0.6)); }\n";

// "4x3f" is a matrix of 4 columns and 3 rows, "2ui" a vector of unsigned integers.
std::string glsl_type(const std::string& type) {
  const bool is_double = type.back() == 'd';
  if (type.find('x') != std::string::npos) return (is_double ? "dmat" : "mat") + type.substr(0, 3);
  const std::string kind = type.substr(1);
  if (type[0] == '1') return kind == "f" ? "float" : kind == "d" ? "double" : kind == "i" ? "int" : "uint";
  return (kind == "f" ? "vec" : kind == "d" ? "dvec" : kind == "i" ? "ivec" : "uvec") + type.substr(0, 1);
}

std::string float_type(char rows) { return rows == '1' ? "float" : std::string("vec") + rows; }

// The share of one element of a uniform.
std::string share(const std::string& type, int element) {
  const std::string name = fmt::format("u_{}[{}]", type, element);
  if (type.find('x') == std::string::npos) return fmt::format("sum({}({}))", float_type(type[0]), name);
  std::string text;
  for (char column = '0'; column < type[0]; ++column)
    text += fmt::format("{}{} * sum({}({}[{}]))", column == '0' ? "" : " + ",
                        column == '0'   ? "1.0"
                        : column == '1' ? "0.6"
                                        : "0.8",
                        float_type(type[2]), name, column);
  return text;
}

std::string uniforms(bool is_desktop) {
  std::string declarations;
  std::string shares;
  int number = 0;
  for (const std::string type : uniform_types(is_desktop)) {
    declarations += fmt::format("uniform {} u_{}[2];\n", glsl_type(type), type);
    for (int element = 0; element < uniform_elements; ++element, ++number)
      shares +=
          fmt::format("  all.{} += {:.3f} * ({});\n", "xyz"[number % 3], 0.1 + 0.01 * number, share(type, element));
  }
  return declarations + sums + "vec4 of_uniforms() {\n  vec4 all = vec4(0.0);\n" + shares + "  return all;\n}\n";
}

constexpr char fragment[] =
    "in vec4 colour; flat in vec4 hue; out vec4 pixel;\n"
    "vec3 wave(vec3 x) { return abs(mod(x, 2.0) - 1.0); }\n"  // continuous, and never out of range
    "void main() { pixel = vec4(wave(colour.rgb + colour.a * vec3(0.3, 0.5, 0.7) + hue.rgb + hue.a * 0.2), 1.0); }\n";

std::string vertex(bool is_desktop, WorldKind kind, unsigned salt) {
  const bool has_uniforms = kind == WorldKind::uniforms;
  const bool has_doubles = is_desktop && !has_uniforms;
  std::string text = std::string(inputs) + (has_doubles ? "layout(location = 10) in dvec4 doubles;\n" : "");
  text += has_uniforms ? uniforms(is_desktop) : "vec4 of_uniforms() { return vec4(0.0); }\n";
  text += kind != WorldKind::curved ? "vec4 shown(vec4 a) { return a; }\n"
                                    : "vec4 shown(vec4 a) { return sin(2.0 * a); }\n";
  text += has_uniforms ? no_more_inputs : more_inputs;
  text += fmt::format(
      "void main() {{\n"
      "  colour = shown(colours) * block_tint + 0.7 * shown(extra).wxyz + of_columns();\n"
      "  colour += vec4({:.2f}, 0.1, 0.0, 0.0) + of_uniforms();\n",
      0.05 + 0.2 * salt);
  if (has_doubles) text += "  colour += 0.3 * shown(vec4(doubles)).xzyw;\n";
  text +=
      "  hue = of_integers();\n"
      "  gl_Position = vec4(position.x, 0.5 * position.y + float(gl_InstanceID) * position.w - 0.5 * position.w,\n"
      "                     position.z + 0.0 * normal.z, position.w * (1.0 + 0.2 * position.y));\n"
      "}\n";
  return text;
}

}  // namespace

const std::vector<const char*>& uniform_types(bool is_desktop) {
  static const std::vector<const char*> both = {"1f",   "2f",   "3f",   "4f",   "1i",   "2i",   "3i",
                                                "4i",   "1ui",  "2ui",  "3ui",  "4ui",  "2x2f", "3x3f",
                                                "4x4f", "2x3f", "3x2f", "2x4f", "4x2f", "3x4f", "4x3f"};
  static const std::vector<const char*> all = [] {
    std::vector<const char*> types = both;
    for (const char* type :
         {"1d", "2d", "3d", "4d", "2x2d", "3x3d", "4x4d", "2x3d", "3x2d", "2x4d", "4x2d", "3x4d", "4x3d"})
      types.push_back(type);
    return types;
  }();
  return is_desktop ? all : both;
}

GLuint stage_program(Test& t, WorldKind kind, unsigned salt) {
  const bool is_desktop = !t.is_gles();
  const std::string vertex_source =
      glsl_head(t) + (is_desktop ? "out gl_PerVertex { vec4 gl_Position; };\n" : "") + vertex(is_desktop, kind, salt);
  const std::string fragment_source = glsl_head(t) + fragment;
  const GLuint program = gl.CreateProgram();
  for (const auto& [stage, source] : {std::pair<GLenum, const std::string&>{GL_VERTEX_SHADER, vertex_source},
                                      std::pair<GLenum, const std::string&>{GL_FRAGMENT_SHADER, fragment_source}}) {
    const GLuint shader = gl.CreateShader(stage);
    const char* const text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  }
  gl.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  const char* const captured[] = {"colour", "hue"};
  gl.TransformFeedbackVaryings(program, 2, captured, GL_INTERLEAVED_ATTRIBS);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  char log[2000] = "";
  gl.GetProgramInfoLog(program, sizeof(log), nullptr, log);
  if (linked == GL_FALSE) t.internal_error(std::string("a program of the suite does not link: ") + log);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Block"), colour_block_binding);
  return program;
}

}  // namespace glark::conformance
