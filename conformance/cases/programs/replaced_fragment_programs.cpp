// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Fixed-function vertices with a fragment program that another one replaces, which reads other outputs of the vertex stage.
#include <fmt/core.h>

#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

// What a fragment program shows, in assembly and in GLSL.
struct Shown {
  const char* leaf;
  const char* assembly;
  const char* glsl;
};
constexpr Shown all_shown[] = {
    {"unit 0", "fragment.texcoord[0]", "gl_TexCoord[0]"},
    {"unit 1", "fragment.texcoord[1]", "gl_TexCoord[1]"},
    {"unit 3", "fragment.texcoord[3]", "gl_TexCoord[3]"},
    {"colour", "fragment.color", "gl_Color"},
    {"second colour", "fragment.color.secondary", "gl_SecondaryColor"},
};

void shown_vertex(float x, float y) {
  gl.Color3f(0.5F + 0.5F * x, 0.1F, 0.9F);
  gl.SecondaryColor3f(0.1F, 0.5F - 0.5F * y, 0.2F);
  gl.MultiTexCoord2f(GL_TEXTURE0, 0.5F + 0.4F * x, 0);
  gl.MultiTexCoord2f(GL_TEXTURE1, 0, 0.5F - 0.4F * y);
  gl.MultiTexCoord2f(GL_TEXTURE3, 0.9F, 0.5F + 0.3F * y);
  gl.Vertex2f(x, y);
}

void shown_triangle() {
  gl.Begin(GL_TRIANGLES);
  shown_vertex(-0.8F, -0.7F);
  shown_vertex(0.8F, -0.6F);
  shown_vertex(-0.1F, 0.8F);
  gl.End();
}

std::string assembly_of(const Shown& shown) {
  return fmt::format("!!ARBfp1.0\nMOV result.color, {};\nEND\n", shown.assembly);
}

void load_assembly(const Shown& shown) {
  const std::string text = assembly_of(shown);
  gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()),
                      text.data());
}

GLuint glsl_shader(Test& t, const Shown& shown) {
  const std::string text = fmt::format("#version 120\nvoid main() {{ gl_FragColor = {}; }}\n", shown.glsl);
  const char* const source = text.c_str();
  const GLuint shader = gl.CreateShader(GL_FRAGMENT_SHADER);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint is_built = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &is_built);
  t.require(is_built != 0, "the fragment shader compiles");
  return shader;
}

enum class ReplacedBy { string, bind, deleted, relink, other_program, in_list };
constexpr std::array<std::pair<const char*, ReplacedBy>, 6> replacements = {
    {{"string", ReplacedBy::string},
     {"bind", ReplacedBy::bind},
     {"deleted", ReplacedBy::deleted},
     {"relink", ReplacedBy::relink},
     {"other_program", ReplacedBy::other_program},
     {"in_list", ReplacedBy::in_list}}};

// Makes the fragment stage show something else each time.
class FragmentStage {
 public:
  FragmentStage(Test& t, ReplacedBy way) : t_(t), way_(way) {
    if (is_glsl()) {
      program_ = gl.CreateProgram();
      return;
    }
    gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
    gl.GenProgramsARB(static_cast<GLsizei>(names_.size()), names_.data());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names_[i]);
      load_assembly(all_shown[i]);
    }
  }

  void show(const Shown& shown) {
    const auto number = static_cast<std::size_t>(&shown - all_shown);
    switch (way_) {
      case ReplacedBy::string: load_assembly(shown); break;
      case ReplacedBy::bind: gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names_[number]); break;
      case ReplacedBy::deleted:  // the default program comes into its place
        gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
        load_assembly(shown);
        gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names_[number]);
        gl.DeleteProgramsARB(1, &names_[number]);
        break;
      case ReplacedBy::in_list:
        gl.NewList(1, GL_COMPILE);
        gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names_[number]);
        gl.EndList();
        gl.CallList(1);
        break;
      case ReplacedBy::other_program: program_ = gl.CreateProgram(); [[fallthrough]];
      case ReplacedBy::relink: link(shown); break;
    }
  }

 private:
  bool is_glsl() const { return way_ == ReplacedBy::relink || way_ == ReplacedBy::other_program; }

  void link(const Shown& shown) {
    if (shader_ != 0 && way_ == ReplacedBy::relink) gl.DetachShader(program_, shader_);
    shader_ = glsl_shader(t_, shown);
    gl.AttachShader(program_, shader_);
    gl.LinkProgram(program_);
    gl.UseProgram(program_);
  }

  Test& t_;
  ReplacedBy way_;
  std::array<GLuint, std::size(all_shown)> names_{};
  GLuint program_ = 0;
  GLuint shader_ = 0;
};

void check_replaced(Test& t, ReplacedBy way) {
  const bool is_glsl = way == ReplacedBy::relink || way == ReplacedBy::other_program;
  if (!is_glsl && !t.has_extension("GL_ARB_fragment_program")) t.not_supported("no assembly programs");
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  FragmentStage stage(t, way);
  for (const Shown& shown : all_shown) {
    stage.show(shown);
    gl.Disable(GL_ARK);
    const Picture plain = picture_of(shown_triangle);
    gl.Enable(GL_ARK);
    t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 1000, "something is drawn");
    for (int again = 0; again < 3; ++again) t.expect_same_picture(picture_of(shown_triangle), plain, shown.leaf, 3, 24);
  }
  t.expect_no_error("the draws");
}

// The refined draws come right after each other, with no unrefined one between them.
void check_in_a_row(Test& t, ReplacedBy way) {
  const bool is_glsl = way == ReplacedBy::relink || way == ReplacedBy::other_program;
  if (!is_glsl && !t.has_extension("GL_ARB_fragment_program")) t.not_supported("no assembly programs");
  std::vector<Picture> plain;
  {
    FragmentStage stage(t, way);
    for (const Shown& shown : all_shown) {
      stage.show(shown);
      plain.push_back(picture_of(shown_triangle));
    }
  }
  FragmentStage stage(t, way);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    stage.show(all_shown[i]);
    t.expect_same_picture(picture_of(shown_triangle), plain[i], all_shown[i].leaf, 3, 24);
  }
  t.expect_no_error("the draws");
}

// Ways to write the index of a texture coordinate in GLSL.
constexpr const char* indexed_coordinates[] = {
    "gl_FragColor = gl_TexCoord[1];",        "gl_FragColor = gl_TexCoord [ 1 ];",
    "gl_FragColor = gl_TexCoord[0x1];",      "gl_FragColor = gl_TexCoord[01];",
    "gl_FragColor = gl_TexCoord[2 - 1];",    "gl_FragColor = gl_TexCoord [unit];",
    "gl_FragColor = gl_TexCoord/**/[unit];", "gl_FragColor = coordinates[1];",
    "gl_FragColor = gl_TexCoord\n  [1];",    "gl_FragColor = gl_TexCoord[0] * 0.0 + gl_TexCoord[unit];",
};

void check_indices(Test& t) {
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const char* const statement : indexed_coordinates) {
    const std::string text = fmt::format(
        "#version 120\n#define coordinates gl_TexCoord\nconst int unit = 1;\nvoid main() {{ {} }}\n", statement);
    const char* const source = text.c_str();
    const GLuint program = gl.CreateProgram();
    const GLuint shader = gl.CreateShader(GL_FRAGMENT_SHADER);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    gl.UseProgram(program);
    t.expect_no_error(statement);
    gl.Disable(GL_ARK);
    const Picture plain = picture_of(shown_triangle);
    gl.Enable(GL_ARK);
    t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 1000, "something is drawn");
    t.expect_same_picture(picture_of(shown_triangle), plain, statement, 3, 24);
  }
}

}  // namespace

Cases replaced_fragment_programs_cases() {
  Cases cases;
  for (const auto& [leaf, way] : replacements)
    for (const bool in_a_row : {false, true})
      cases.push_back(
          {.name = fmt::format("ark.vertex_stage.fragment_program.{}.{}", leaf, in_a_row ? "in_a_row" : "each"),
           .clauses = {"11.R.10-1", "11.R.13-1"},
           .plan = "Replace the fragment program of fixed-function vertices by one that shows another "
                   "texture coordinate or colour, and compare with the unrefined picture.",
           .wrong = "The refined vertices give only what the first fragment program read: the rest is 0.",
           .apis = compat_only,
           .is_optional = true,
           .check = [way = way, in_a_row](Test& t) { in_a_row ? check_in_a_row(t, way) : check_replaced(t, way); }});
  cases.push_back({.name = "ark.vertex_stage.fragment_program.index",
                   .clauses = {"11.R.10-1"},
                   .plan =
                       "Read one texture coordinate of fixed-function vertices by an index that is written in several "
                       "ways, and compare with the unrefined picture.",
                   .wrong = "The coordinate is 0.",
                   .apis = compat_only,
                   .check = check_indices});
  return cases;
}

}  // namespace glark::conformance
