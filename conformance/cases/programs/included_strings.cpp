// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Shaders that include named strings (ARB_shading_language_include) are refined like any other.
#include <string>
#include <string_view>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct NamedString {
  const char* name;
  const char* text;
};

// `body` follows the #version, the #extension and the inputs, and defines vec4 shade(vec4).
struct Inclusion {
  const char* leaf;
  std::string_view body;
  std::vector<NamedString> strings;
  std::vector<const char*> paths;
};

std::vector<Inclusion> inclusions() {
  constexpr const char* red = "vec4 shade(vec4 c) { return c * vec4(1, 0.2, 0.2, 1); }\n";
  constexpr const char* green = "vec4 shade(vec4 c) { return c * vec4(0.2, 1, 0.2, 1); }\n";
  return {
      {"absolute", "#include \"/glark/shade\"\n", {{"/glark/shade", red}}, {}},
      {"angles", "#include </glark/shade>\n", {{"/glark/shade", red}}, {}},
      {"blanks", "  #include \t \"/glark/shade\"\n", {{"/glark/shade", red}}, {}},
      {"relative", "#include \"shade\"\n", {{"/glark/shade", red}}, {"/glark"}},
      {"order_of_paths", "#include <shade>\n", {{"/a/shade", red}, {"/b/shade", green}}, {"/none", "/b", "/a"}},
      {"nested", "#include \"/a/first\"\n", {{"/a/first", "#include \"/b/second\"\n"}, {"/b/second", red}}, {}},
      {"nested_relative",
       "#include <a/first>\n",
       {{"/x/a/first", "#include <b/second>\n"}, {"/y/b/second", green}},
       {"/x", "/y"}},
      {"dots", "#include \"/a/./b/../shade\"\n", {{"/a/shade", green}}, {}},
      {"twice",
       "#include \"/a/guarded\"\n#include \"/a/guarded\"\n",
       {{"/a/guarded",
         "#ifndef once\n#define once\nvec4 shade(vec4 c) { return c * vec4(1, 0.2, 0.2, 1); }\n#endif\n"}},
       {}},
      {"itself",
       "#include \"/a/self\"\n",
       {{"/a/self",
         "#ifndef once\n#define once\n#include \"/a/self\"\nvec4 shade(vec4 c) { return c.zyxw; }\n#endif\n"}},
       {}},
      {"unused",
       "#if 0\n#include \"/nowhere\"\n#endif\n/*\n#include \"/a/wrong\"\n*/\n// #include \"/a/wrong\"\n#include "
       "\"/a/shade\"\n",
       {{"/a/wrong", "vec4 shade(vec4 c) { return vec4(0); }\n"}, {"/a/shade", green}},
       {}},
      {"macro",
       "#include \"/a/macro\"\nvec4 shade(vec4 c) { return SHADE(c); }\n",
       {{"/a/macro", "#define SHADE(x) ((x) * vec4(0.5, 1, 0.25, 1))\n"}},
       {}},
      {"no_line_end", "#include \"/a/shade\"\n", {{"/a/shade", "vec4 shade(vec4 c) { return c.yxzw; }"}}, {}},
  };
}

void name_string(const char* name, const std::string& text) {
  gl.NamedStringARB(GL_SHADER_INCLUDE_ARB, -1, name, static_cast<GLint>(text.size()), text.c_str());
}

GLuint including_shader(const std::string& source, const std::vector<const char*>& paths) {
  const char* text = source.c_str();
  const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
  gl.ShaderSource(shader, 1, &text, nullptr);
  if (paths.empty()) {
    gl.CompileShader(shader);
  } else {
    gl.CompileShaderIncludeARB(shader, static_cast<GLsizei>(paths.size()), paths.data(), nullptr);
  }
  return shader;
}

GLuint including_program(Test& t, const std::string& source, const std::vector<const char*>& paths) {
  const GLuint vertex = including_shader(source, paths);
  const std::string fragment_source =
      glsl_head(t) + "in vec4 colour_; out vec4 pixel; void main() { pixel = colour_; }";
  const char* text = fragment_source.c_str();
  const GLuint fragment = gl.CreateShader(GL_FRAGMENT_SHADER);
  gl.ShaderSource(fragment, 1, &text, nullptr);
  gl.CompileShader(fragment);
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.BindAttribLocation(program, at_position, "position");
  gl.BindAttribLocation(program, at_colour, "colour");
  gl.LinkProgram(program);
  GLint is_linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == 0) t.not_supported("GL itself does not build the program");
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  return program;
}

void check_inclusion(Test& t, const Inclusion& inclusion) {
  if (!t.has_extension("GL_ARB_shading_language_include")) t.not_supported("no GL_ARB_shading_language_include");
  for (const NamedString& each : inclusion.strings) name_string(each.name, each.text);
  std::string head = glsl_head(t);
  head.insert(head.find('\n') + 1, "#extension GL_ARB_shading_language_include : require\n");
  const std::string source = head + "in vec4 position; in vec4 colour; out vec4 colour_;\n" +
                             std::string(inclusion.body) +
                             "void main() { gl_Position = position; colour_ = shade(colour); }\n";
  const GLuint program = including_program(t, source, inclusion.paths);
  // What the strings are later does not matter.
  for (const NamedString& each : inclusion.strings) name_string(each.name, "vec4 shade(vec4 c) { return vec4(0); }\n");
  gl.UseProgram(program);
  upload(one_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture plain = picture_of(draw);
  refine_uniformly(2);
  require_refinable(t, program);
  t.expect_same_picture(picture_of(draw), plain, "the refined triangle", 2, 20);
  t.expect_equal(count_generated(draw), GLuint{16}, "refined triangles");
  t.expect_no_error("the draws");
}

}  // namespace

Cases included_strings_cases() {
  Cases cases;
  for (const Inclusion& inclusion : inclusions())
    cases.push_back({.name = std::string("ark.programs.included.") + inclusion.leaf,
                     .clauses = {"10.R.2-1", "11.R.9-1"},
                     .plan =
                         "A vertex shader includes named strings. Its triangles are refined, and the picture is the "
                         "unrefined one, also after the strings have other contents.",
                     .wrong = "The draw stays unrefined, or the strings are read when the program is drawn.",
                     .apis = desktop_apis,
                     .check = [inclusion](Test& t) { check_inclusion(t, inclusion); }});
  return cases;
}

}  // namespace glark::conformance
