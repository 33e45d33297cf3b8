// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The refinement shader of program 0 (11.R.9) moves what the fixed function's vertex stage draws, whatever the fragment
// stage is: the fixed function, a program without a vertex shader, an assembly program, or a program pipeline.
#include <fmt/core.h>
#include <array>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

GLuint fragment_only(Test& t, const char* text, bool is_separable) {
  const GLuint program = gl.CreateProgram();
  const GLuint shader = gl.CreateShader(GL_FRAGMENT_SHADER);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  if (is_separable) gl.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  gl.LinkProgram(program);
  GLint is_linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == 0) t.internal_error("a program of a fragment shader does not link");
  return program;
}

constexpr char old_fragment[] = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n";
constexpr char new_fragment[] =
    "#version 150 compatibility\nout vec4 pixel; void main() { pixel = vec4(gl_Color.gbr, 1.0); }\n";

void use_assembly() {
  const std::string text = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";
  GLuint name = 0;
  gl.GenProgramsARB(1, &name);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
  gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()),
                      text.c_str());
  gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
}

struct FragmentSide {
  const char* leaf;
  void (*use)(Test&);
  bool may_stay = false;  // an implementation may draw it unrefined (11.R.11)
};

constexpr FragmentSide fragment_sides[] = {
    {"alone", [](Test&) { gl.UseProgram(0); }},
    {"program", [](Test& t) { gl.UseProgram(fragment_only(t, old_fragment, false)); }},
    {"program_150", [](Test& t) { gl.UseProgram(fragment_only(t, new_fragment, false)); }},
    {"separable", [](Test& t) { gl.UseProgram(fragment_only(t, new_fragment, true)); }},
    {"assembly", [](Test&) { use_assembly(); }},
    {"relinked",
     [](Test& t) {
       const GLuint program = fragment_only(t, old_fragment, false);
       gl.UseProgram(program);
       gl.LinkProgram(program);
     }},
    {"pipeline",
     [](Test& t) {
       GLuint pipeline = 0;
       gl.GenProgramPipelines(1, &pipeline);
       gl.BindProgramPipeline(pipeline);
       gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, fragment_only(t, new_fragment, true));
     },
     true},
};

void leave_side() {
  gl.UseProgram(0);
  gl.BindProgramPipeline(0);
  gl.Disable(GL_FRAGMENT_PROGRAM_ARB);
}

void begin_triangle(float shift) {
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : one_triangle()) {
    gl.Normal3f(0, 0, 1);
    gl.Color4fv(vertex.colour.data());
    gl.Vertex2f(0.6F * vertex.position[0] - 0.3F + shift, 0.6F * vertex.position[1]);
  }
  gl.End();
}

constexpr float near_shift = 0.25F;
constexpr float far_shift = 0.5F;

// Positions and colours in client memory, or in a buffer at the same offsets.
struct SideVertex {
  Vec2 position;
  Vec4 colour;
};
std::array<SideVertex, 3> side_vertices;

void place_vertices(float shift) {
  const Mesh mesh = one_triangle();
  for (std::size_t i = 0; i < 3; ++i)
    side_vertices[i] = {{0.6F * mesh[i].position[0] - 0.3F + shift, 0.6F * mesh[i].position[1]}, mesh[i].colour};
}

void point_at(const SideVertex* first) {
  gl.Normal3f(0, 0, 1);
  gl.VertexPointer(2, GL_FLOAT, sizeof(SideVertex), first);
  gl.ColorPointer(4, GL_FLOAT, sizeof(SideVertex), reinterpret_cast<const char*>(first) + sizeof(Vec2));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
}

struct SideWay {
  const char* leaf;
  void (*draw)(float shift);
};
constexpr SideWay side_ways[] = {
    {"begin", begin_triangle},
    {"client_arrays",
     [](float shift) {
       place_vertices(shift);
       point_at(side_vertices.data());
       gl.DrawArrays(GL_TRIANGLES, 0, 3);
     }},
    {"buffer",
     [](float shift) {
       static GLuint buffer = 0;
       place_vertices(shift);
       gl.GenBuffers(1, &buffer);
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       gl.BufferData(GL_ARRAY_BUFFER, sizeof(side_vertices), side_vertices.data(), GL_STATIC_DRAW);
       point_at(nullptr);
       gl.BindBuffer(GL_ARRAY_BUFFER, 0);
       constexpr GLubyte indices[] = {0, 1, 2};
       gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
       gl.DeleteBuffers(1, &buffer);
     }},
    {"list",
     [](float shift) {
       const GLuint list = shift == 0 ? 1 : shift == near_shift ? 2 : 3;
       if (gl.IsList(list) == GL_FALSE) {
         gl.NewList(list, GL_COMPILE);
         begin_triangle(shift);
         gl.EndList();
       }
       gl.CallList(list);
     }},
};

constexpr char near_source[] = "void refine() { gl_Vertex.x += 0.25; }";
constexpr char far_source[] = "void refine() { gl_Vertex.x += 0.5; }";

// What an unrefined draw gives for vertices in their place and in the two others.
class PlainPictures {
 public:
  explicit PlainPictures(const SideWay& way) {
    gl.Disable(GL_ARK);
    for (const float shift : {0.0F, near_shift, far_shift}) pictures_.push_back(picture_of([&] { way.draw(shift); }));
    gl.Enable(GL_ARK);
  }
  const Picture& of(float shift) const { return pictures_[shift == 0 ? 0 : shift == near_shift ? 1 : 2]; }

 private:
  std::vector<Picture> pictures_;
};

void expect_moved(Test& t, const FragmentSide& side, const SideWay& way, const PlainPictures& plain, float shift,
                  const std::string& what) {
  const auto draw = [&] { way.draw(0); };
  const GLuint triangles = count_generated(draw);
  const bool stays = side.may_stay && triangles == 1;
  if (!stays) t.expect_equal(triangles, 16U, what + ": triangles");
  t.expect_same_picture(picture_of(draw), plain.of(stays ? 0 : shift), what, 3, 40);
}

constexpr GLenum side_refinements[] = {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_PHONG_ARK, GL_LINEAR_OUTPUTS_ARK,
                                       GL_SCALAR_TAGGED_PN_ARK};

void check_side(Test& t, const FragmentSide& side) {
  refine_uniformly(2);
  side.use(t);
  std::size_t turn = 0;
  for (const SideWay& way : side_ways) {
    gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(side_refinements[turn++ % 5]));
    const PlainPictures plain(way);
    t.expect(count_different(plain.of(0), plain.of(near_shift), 8) > 400, "the places differ");
    const auto expect = [&](float shift, const std::string& what) {
      expect_moved(t, side, way, plain, shift, std::string(way.leaf) + ", " + what);
    };
    expect(0, "without a shader");
    give(0, near_source);
    expect(near_shift, "with a shader");
    repeat_often([&] { way.draw(0); });
    expect(near_shift, "with a shader, often");
    give(0, far_source);
    expect(far_shift, "with another shader");
    gl.RefinementShaderSourceARK(0, 0, nullptr, nullptr);
    expect(0, "after the shader");
    repeat_often([&] { way.draw(0); });
    give(0, near_source);
    expect(near_shift, "with a shader, late");
    give(0, "");
  }
  t.expect_no_error("the draws");
}

// One shader for all fragment stages in turn. Where it is given makes no difference.
void check_turns(Test& t, const SideWay& way) {
  refine_uniformly(2);
  for (int round = 0; round < 2; ++round)
    for (const FragmentSide& side : fragment_sides) {
      side.use(t);
      const PlainPictures plain(way);
      leave_side();
      give(0, round == 0 ? near_source : far_source);
      way.draw(0);
      side.use(t);
      for (int again = 0; again < 2; ++again) {
        expect_moved(t, side, way, plain, round == 0 ? near_shift : far_shift, side.leaf);
        repeat_often([&] { way.draw(0); });
      }
      leave_side();
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases fixed_shader_beside_cases() {
  const std::vector<std::string> clauses = {"11.R.9-4", "11.R.9-37", "11.R.9-16"};
  Cases cases;
  for (const FragmentSide& side : fragment_sides)
    cases.push_back(
        {.name = std::string("ark.shader.fixed.beside.") + side.leaf,
         .clauses = clauses,
         .plan = "Give, replace and remove the shader of program 0 beside this fragment stage.",
         .wrong = "The shader is ignored beside a program of the application, or it stays when it is removed.",
         .apis = compat_only,
         .check = [&side](Test& t) { check_side(t, side); }});
  for (const SideWay& way : side_ways)
    cases.push_back({.name = std::string("ark.shader.fixed.beside_each.") + way.leaf,
                     .clauses = clauses,
                     .plan = "Draw with each fragment stage in turn, under one shader of program 0.",
                     .wrong = "The shader that another fragment stage was drawn with.",
                     .apis = compat_only,
                     .check = [&way](Test& t) { check_turns(t, way); }});
  return cases;
}

}  // namespace glark::conformance
