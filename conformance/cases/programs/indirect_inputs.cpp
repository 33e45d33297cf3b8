// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Indirect inputs of a vertex stage: set by another context, through a program pipeline, by subroutines, or by commands
// that read the same bytes in different ways.
#include <array>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

void draw() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

Picture unrefined() {
  gl.Disable(GL_ARK);
  Picture picture = picture_of(draw);
  gl.Enable(GL_ARK);
  return picture;
}

void expect_as_unrefined(Test& t, const std::string& what) {
  const Picture refined = picture_of(draw);
  t.expect_same_picture(refined, unrefined(), what, 2, 20);
}

const char tinted_stage[] =
    "layout(location = 0) in vec4 position; uniform vec4 tint; out vec4 colour;\n"
    "void main() { colour = tint; gl_Position = position; }\n";

// The other context has had the program in use since before its first refined draw.
void check_other_context(Test& t) {
  const GLuint program = build_program(t, {.vertex = tinted_stage});
  const GLint tint = gl.GetUniformLocation(program, "tint");
  gl.UseProgram(program);
  upload(one_triangle());
  gl.Uniform4f(tint, 1, 0, 0, 1);
  gl.Finish();
  const std::unique_ptr<Context> second = t.create_context(&t.context());
  gl.UseProgram(program);
  t.require(t.context().make_current(), "the first context can be made current");
  refine_uniformly(2);
  expect_as_unrefined(t, "the first color");
  for (const float green : {1.0F, 0.5F, 0.75F}) {
    t.require(second->make_current(), "the second context can be made current");
    gl.Uniform4f(tint, 0, green, 0, 1);
    gl.Finish();
    t.require(t.context().make_current(), "the first context can be made current");
    gl.UseProgram(program);
    expect_as_unrefined(t, "the color that the other context has set");
    t.expect(unrefined().at(surface_size / 2, surface_size / 3)[0] == 0, "the other context's color shows");
  }
}

// Uniform* sets uniforms of the active program of a pipeline object.
void check_pipeline_uniforms(Test& t) {
  const Pipeline pipeline = bind_pipeline(t,
                                          "layout(location = 0) in vec4 position; uniform vec4 tint;\n"
                                          "layout(location = 0) out vec4 colour;\n"
                                          "void main() { colour = tint; gl_Position = position; }\n",
                                          "layout(location = 0) in vec4 colour; layout(location = 0) out vec4 pixel;\n"
                                          "void main() { pixel = colour; }\n");
  gl.ActiveShaderProgram(pipeline.name, pipeline.vertex_program);
  const GLint tint = gl.GetUniformLocation(pipeline.vertex_program, "tint");
  upload(one_triangle());
  refine_uniformly(2);
  for (const float green : {1.0F, 0.25F, 0.75F}) {
    gl.Uniform4f(tint, 1, green, 0, 1);
    for (int again = 0; again < 2; ++again) expect_as_unrefined(t, "a uniform of the active program");
  }
  t.expect_no_error("the draws");
}

// After the declaration of the type Tint.
const char three_tints[] =
    "subroutine(Tint) vec4 kept(vec4 c) { return c; }\n"
    "subroutine(Tint) vec4 swapped(vec4 c) { return c.gbra; }\n"
    "subroutine(Tint) vec4 turned(vec4 c) { return vec4(1.0 - c.rgb, 1.0); }\n"
    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 colour;\n";

// Subroutines are context state. A change of programs resets them.
void check_subroutines(Test& t) {
  const GLuint program =
      build_program(t, {.vertex = std::string("subroutine vec4 Tint(vec4 c); subroutine uniform Tint tint;\n") +
                                  three_tints + "void main() { colour = tint(c); gl_Position = position; }\n"});
  gl.UseProgram(program);
  upload(one_triangle());
  std::vector<Picture> plain;
  const char* const names[] = {"swapped", "turned", "kept"};
  const auto choose = [program](const char* name) {
    const GLuint index = gl.GetSubroutineIndex(program, GL_VERTEX_SHADER, name);
    gl.UniformSubroutinesuiv(GL_VERTEX_SHADER, 1, &index);
  };
  for (const char* const name : names) {
    choose(name);
    plain.push_back(picture_of(draw));
    t.expect(plain.size() < 2 || count_different(plain[plain.size() - 2], plain.back(), 8) > 100, "the choice shows");
  }
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < plain.size(); ++i) {
      choose(names[i]);
      refine_uniformly(2);
      t.expect_same_picture(picture_of(draw), plain[i], std::string(names[i]) + ", refined", 2, 20);
      gl.Disable(GL_ARK);
      t.expect_same_picture(picture_of(draw), plain[i], std::string(names[i]) + ", unrefined after it");
    }
  t.expect_no_error("the draws");
}

// An array of subroutine uniforms has a location for each element.
void check_subroutine_arrays(Test& t) {
  const GLuint program =
      build_program(t, {.vertex = std::string("subroutine vec4 Tint(vec4 c);\n"
                                              "subroutine uniform Tint one; subroutine uniform Tint tints[2];\n") +
                                  three_tints +
                                  "void main() { colour = vec4(one(c).r, tints[0](c).g, tints[1](c).b, 1.0);\n"
                                  "  gl_Position = position; }\n"});
  gl.UseProgram(program);
  upload(one_triangle());
  GLint locations = 0;
  gl.GetProgramStageiv(program, GL_VERTEX_SHADER, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &locations);
  t.require(locations == 3, "three locations");
  const char* const names[] = {"kept", "swapped", "turned"};
  std::vector<Picture> pictures;
  for (std::size_t turn = 0; turn < 6; ++turn) {
    std::array<GLuint, 3> chosen{};
    std::size_t place = 0;
    for (const char* const uniform : {"one", "tints[0]", "tints[1]"}) {
      const GLint location = gl.GetSubroutineUniformLocation(program, GL_VERTEX_SHADER, uniform);
      t.require(location >= 0 && location < 3, std::string("the location of ") + uniform);
      const char* const name = names[(place++ * (1 + turn / 3) + turn) % 3];
      chosen[static_cast<std::size_t>(location)] = gl.GetSubroutineIndex(program, GL_VERTEX_SHADER, name);
    }
    gl.UniformSubroutinesuiv(GL_VERTEX_SHADER, 3, chosen.data());
    const Picture plain = picture_of(draw);
    refine_uniformly(2);
    for (int again = 0; again < 2; ++again)
      t.expect_same_picture(picture_of(draw), plain, "choice " + as_text(turn), 2, 20);
    gl.Disable(GL_ARK);
    pictures.push_back(plain);
    t.expect(turn == 0 || count_different(pictures[turn - 1], plain, 8) > 100, "choice " + as_text(turn) + " shows");
  }
  t.expect_no_error("the draws");
}

// A stage that applies its own subroutine to the colour. Each stage has another number of subroutine uniforms.
std::string stage_with_subroutines(const std::string& uniforms, const std::string& rest) {
  return "subroutine vec4 Tint(vec4 c);\n" + uniforms +
         "\nsubroutine(Tint) vec4 kept(vec4 c) { return c; }\n"
         "subroutine(Tint) vec4 swapped(vec4 c) { return c.gbra; }\n"
         "subroutine(Tint) vec4 turned(vec4 c) { return vec4(1.0 - 0.5 * c.rgb, 1.0); }\n" +
         rest;
}

GLuint program_with_subroutines(Test& t) {
  return build_program(
      t, {.vertex = stage_with_subroutines(
              "subroutine uniform Tint first;",
              "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 passed;\n"
              "void main() { passed = first(c); gl_Position = position; }\n"),
          .fragment = stage_with_subroutines(
              "subroutine uniform Tint third[2];",
              "in vec4 colour; out vec4 pixel; void main() { pixel = third[1](third[0](colour)); }\n"),
          .geometry = stage_with_subroutines(
              "subroutine uniform Tint second[2];",
              "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out; in vec4 passed[]; out vec4 colour;\n"
              "void main() { for (int i = 0; i < 3; ++i) { colour = second[1](second[0](passed[i]));\n"
              "  gl_Position = gl_in[i].gl_Position; EmitVertex(); } }\n")});
}

// Places in the list of names: one for the vertex stage, two each for the geometry and the fragment stage.
using Choice = std::array<std::size_t, 5>;

void choose_in_all_stages(Test& t, GLuint program, const Choice& choice) {
  const char* const names[] = {"kept", "swapped", "turned"};
  std::size_t at = 0;
  for (const GLenum stage : {GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER}) {
    GLint count = 0;
    gl.GetProgramStageiv(program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &count);
    t.require(count == (stage == GL_VERTEX_SHADER ? 1 : 2), "as many locations as subroutine uniforms");
    std::vector<GLuint> chosen;
    while (chosen.size() < static_cast<std::size_t>(count))
      chosen.push_back(gl.GetSubroutineIndex(program, stage, names[choice[at++]]));
    gl.UniformSubroutinesuiv(stage, count, chosen.data());
  }
}

// Each turn changes one uniform of one stage.
void check_subroutines_of_stages(Test& t) {
  const GLuint program = program_with_subroutines(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  Picture last(surface_size, surface_size);
  Choice choice = {1, 0, 1, 2, 0};
  for (std::size_t turn = 0; turn < 2 * choice.size(); ++turn) {
    choice[turn % 5] = (choice[turn % 5] + 1) % 3;
    choose_in_all_stages(t, program, choice);
    for (int again = 0; again < 2; ++again) expect_as_unrefined(t, "turn " + as_text(turn));
    const Picture plain = unrefined();
    t.expect(count_different(plain, last, 8) > 100, "turn " + as_text(turn) + " shows");
    last = plain;
  }
  t.expect_no_error("the draws");
}

// Normalized and not normalized: bytes of 1 are almost black, or white.
void check_same_bytes(Test& t, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle({2, 2, 2}));
  gl.DisableVertexAttribArray(at_colour);
  is_uniform ? refine_uniformly(2) : refine_by_tags(2);
  const GLubyte bytes[] = {0, 1, 1, 1};
  for (int round = 0; round < 3; ++round)
    for (const bool is_normalized : {true, false})
      for (int again = 0; again < 3; ++again) {
        is_normalized ? gl.VertexAttrib4Nubv(at_colour, bytes) : gl.VertexAttrib4ubv(at_colour, bytes);
        expect_as_unrefined(t, is_normalized ? "a normalized color" : "a color that is not normalized");
      }
}

// The linked source is the compiled one.
void check_source_not_compiled(Test& t) {
  const std::string fragment = glsl_head(t) + Sources{}.fragment;
  const auto vertex = [&t](const char* colour) {
    return glsl_head(t) + "layout(location = 0) in vec4 position; out vec4 colour;\nvoid main() { colour = " + colour +
           "; gl_Position = position; }\n";
  };
  const std::string compiled = vertex("vec4(0.0, 1.0, 0.0, 1.0)");
  const std::string later = vertex("vec4(1.0, 0.0, 0.0, 1.0)");
  const GLuint program = gl.CreateProgram();
  GLuint shaders[2];
  for (int i = 0; i < 2; ++i) {
    shaders[i] = gl.CreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    const char* const text = i == 0 ? compiled.c_str() : fragment.c_str();
    gl.ShaderSource(shaders[i], 1, &text, nullptr);
    gl.CompileShader(shaders[i]);
    gl.AttachShader(program, shaders[i]);
  }
  const char* const text = later.c_str();
  gl.ShaderSource(shaders[0], 1, &text, nullptr);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  upload(one_triangle());
  const Picture plain = picture_of(draw);
  refine_uniformly(2);
  t.expect_same_picture(picture_of(draw), plain, "the compiled source, refined", 1, 30);
}

constexpr Area stage_case{"ark.stage.shared."};

}  // namespace

Cases indirect_inputs_cases() {
  Cases cases = {
      stage_case("other_context", {"11.R.10-1"},
                 "Another context of the share group sets a uniform of a program that is refined here.",
                 "The value of the first refined draw.", check_other_context),
      stage_case("pipeline_uniforms", {"11.R.10-1"}, "Uniform* of the active program of a pipeline object.",
                 "The value of the first refined draw.", check_pipeline_uniforms),
      stage_case("subroutines", {"11.R.10-1", "10.R.2-6"},
                 "Choose subroutines, and draw refined and unrefined in turn.",
                 "A refined draw leaves the program's initial subroutines.", check_subroutines, desktop_apis),
      stage_case("subroutine_arrays", {"11.R.10-1", "10.R.2-6"},
                 "Choose subroutines for the elements of an array, and draw refined and unrefined in turn.",
                 "The elements have the subroutines of the first one.", check_subroutine_arrays, desktop_apis),
      stage_case(
          "subroutines_of_stages", {"11.R.10-1", "10.R.2-6"},
          "Choose subroutines in the vertex, the geometry and the fragment stage, and draw refined and unrefined "
          "in turn.",
          "Later stages have their initial subroutines, or those of another stage.", check_subroutines_of_stages,
          desktop_apis)};
  cases.push_back(Area{"ark.stage."}(
      "source_not_compiled", {"11.R.10-1"}, "Give the vertex shader another source after compiling it, then link.",
      "The refined draw uses the source that was never compiled.", check_source_not_compiled));
  for (const bool is_uniform : {true, false})
    cases.push_back(stage_case(
        std::string("same_bytes.") + (is_uniform ? "uniform" : "tags"), {"10.R.2-1"},
        "Repeat a draw, and set current values by two commands with the same bytes.",
        "The value that the other command sets for these bytes.",
        [is_uniform](Test& t) { check_same_bytes(t, is_uniform); }, desktop_apis));
  return cases;
}

}  // namespace glark::conformance
