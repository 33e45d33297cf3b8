// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw that repeats, and then one component of one element of a uniform array changes: by every command, for every
// type. The vertex stage of a measured draw reads the uniform, or a refinement shader does.
#include <fmt/core.h>

#include <algorithm>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/uniform_commands.h"

namespace glark::conformance {
namespace {

// All components are 0, or one of them is 1: the triangle has the one size or the other.
constexpr float small_size = 0.2F;
constexpr float large_size = 0.6F;

// The size, as a declaration and an expression of GLSL.
struct SizeOf {
  std::string declaration;
  std::string expression;
};

SizeOf size_of(const UniformCommand& command) {
  std::string sum = "0.0";
  for (std::size_t element = 0; element < elements_of_array; ++element)
    for (int i = 0; i < command.components(); ++i)
      sum += " + float(" + command.component(fmt::format("value[{}]", element), i) + ")";
  return {
      fmt::format("uniform {}{} value[{}];\n", is_double_type(command.type) || command.type[0] == 'b' ? "" : "highp ",
                  command.type, elements_of_array),
      fmt::format("({} + {} * ({}))", small_size, large_size - small_size, sum)};
}

void draw_uniform_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void upload_scaled(float scale) {
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh)
    for (std::size_t k = 0; k < 2; ++k) vertex.position[k] *= scale;
  upload(mesh, false);
}

// What the draw gives: its picture, and the number of its refined triangles.
struct SizedDraw {
  Picture picture;
  GLuint triangles;
};

SizedDraw sized_draw() { return {picture_of(draw_uniform_triangle), count_generated(draw_uniform_triangle)}; }

// One change: by which command, and what.
struct ComponentChange {
  const UniformCommand* command;
  GLsizei count;  // of elements that the command sets
  std::size_t first;
  std::size_t element;  // the one that changes
  int component;
};

// Every component in some element, every element by some component; alone and with others.
std::vector<ComponentChange> changes_of(const UniformCommand& command) {
  std::vector<ComponentChange> changes;
  std::size_t turn = 0;
  for (int component = 0; component < command.components(); ++component, ++turn) {
    const std::size_t element = (turn + 1) % elements_of_array;
    changes.push_back({&command, 1, element, element, component});
  }
  for (std::size_t element = 0; element < elements_of_array; ++element)
    changes.push_back({&command, 1, element, element, command.components() - 1});
  if (!command.takes_count) return changes;
  changes.push_back({&command, 2, 1, 2, 0});
  changes.push_back({&command, 3, 0, 2, command.components() - 1});
  return changes;
}

class ChangedUniform {
 public:
  ChangedUniform(Test& t, GLuint program) : t_(t), program_(program) {}

  // Repeats the draw while all components are 0, makes the change, and compares. Some programs set the same values in
  // every draw.
  void check(const ComponentChange& change, const SizedDraw& zero, const SizedDraw& one, bool sets_always) {
    set(change, 0);
    for (int again = 0; again < 24; ++again) {
      if (sets_always) set(change, 0);
      draw_uniform_triangle();
    }
    expect(sized_draw(), zero, change, "0");
    set(change, 1);
    expect(sized_draw(), one, change, "1");
    set(change, 0);
  }

 private:
  void set(const ComponentChange& change, double value) {
    UniformNumbers numbers{};
    const auto components = static_cast<std::size_t>(change.command->components());
    numbers[(change.element - change.first) * components + static_cast<std::size_t>(change.component)] = value;
    const GLint location = gl.GetUniformLocation(program_, fmt::format("value[{}]", change.first).c_str());
    change.command->set(program_, location, change.count, numbers.data());
  }

  void expect(const SizedDraw& actual, const SizedDraw& expected, const ComponentChange& change, const char* value) {
    const std::string what = fmt::format("{} of {} elements: component {} of element {} is {}", change.command->name,
                                         change.count, change.component, change.element, value);
    t_.expect_same_picture(actual.picture, expected.picture, what, 4, 40);
    t_.expect_equal(actual.triangles, expected.triangles, what + ", refined triangles");
  }

  Test& t_;
  GLuint program_;
};

const UniformCommand& first_command(const std::string& type) {
  return *std::find_if(uniform_commands().begin(), uniform_commands().end(),
                       [&](const UniformCommand& command) { return command.type == type; });
}

// The results of both sizes come from triangles of these sizes, while the uniform is 0.
void check_uniform_commands(Test& t, const std::string& type, GLuint program) {
  upload_scaled(large_size / small_size);
  const SizedDraw one = sized_draw();
  upload_scaled(1);
  const SizedDraw zero = sized_draw();
  t.expect(count_different(zero.picture, one.picture, 8) > 300, "the sizes differ");
  ChangedUniform uniform(t, program);
  bool sets_always = false;
  for (const UniformCommand& command : uniform_commands()) {
    if (command.type != type) continue;
    for (const ComponentChange& change : changes_of(command)) {
      sets_always = !sets_always;
      uniform.check(change, zero, one, sets_always);
    }
    uniform.check({&command, 1, 1, 1, 0}, zero, one, true);
    t.expect_no_error(command.name);
  }
}

void check_measured_uniform(Test& t, const std::string& type) {
  const SizeOf size = size_of(first_command(type));
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n" +
                    size.declaration + "out vec4 colour;\nvoid main() { colour = vertex_colour;\n  float size = " +
                    size.expression + ";\n  gl_Position = vec4(position.xy * size, position.zw); }\n"});
  gl.UseProgram(program);
  gl.Viewport(0, 0, surface_size, surface_size);
  refine_by_tags(6);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 3);
  check_uniform_commands(t, type, program);
}

void check_shader_uniform(Test& t, const std::string& type) {
  const SizeOf size = size_of(first_command(type));
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  refine_uniformly(2);
  set_refinement_shader(
      t, program,
      size.declaration + "void refine() { float size = " + size.expression + ";\n  position.xy *= size; }\n");
  check_uniform_commands(t, type, program);
}

}  // namespace

Cases uniform_components_cases() {
  Cases cases;
  for (const std::string& type : types_of_uniforms()) {
    const Apis apis = is_double_type(type) ? desktop_apis : every_api;
    cases.push_back({.name = "ark.draw.again.component.measured." + type,
                     .clauses = {"11.R.4-5", "11.R.10-1"},
                     .plan = "Repeat a measured draw whose vertex stage reads an array of this type, change one "
                             "component of one element by each command, and count.",
                     .wrong = "The depths of the earlier value: only some components or the first element count.",
                     .apis = apis,
                     .check = [type](Test& t) { check_measured_uniform(t, type); }});
    cases.push_back({.name = "ark.draw.again.component.shader." + type,
                     .clauses = {"11.R.9-21", "11.R.13-1"},
                     .plan = "Repeat a draw whose refinement shader reads an array of this type, change one component "
                             "of one element by each command, and compare.",
                     .wrong = "The refined vertices of the earlier value.",
                     .apis = apis,
                     .check = [type](Test& t) { check_shader_uniform(t, type); }});
  }
  return cases;
}

}  // namespace glark::conformance
