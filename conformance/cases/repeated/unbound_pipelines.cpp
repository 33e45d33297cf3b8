// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Program pipelines that change while another one is bound, or none (GL 4.6, 7.4), and then are bound again.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

// `moved` shifts and tints the vertices, so that another stage shows.
std::string unbound_vertex_stage(float shift, const char* tint) {
  return std::string(
             "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
             "uniform float shift; uniform mat2 turn; layout(location = 0) out vec4 colour;\n"
             "void main() { colour = vertex_colour") +
         tint + fmt::format("; gl_Position = position + vec4({:f} + shift, turn[1][0], 0.0, 0.0); }}\n", shift);
}

std::string unbound_fragment_stage(const char* swizzle) {
  return std::string(
             "layout(location = 0) in vec4 colour; uniform float tone; out vec4 pixel;\n"
             "void main() { pixel = vec4(colour.") +
         swizzle + " + vec3(tone), 1.0); }\n";
}

struct Pipelines {
  GLuint changed = 0;  // the pipeline that changes
  GLuint other = 0;
  GLuint vertex = 0;  // the stages of both at first
  GLuint fragment = 0;
  GLuint next_vertex = 0;
  GLuint next_fragment = 0;
};

Pipelines make_pipelines(Test& t) {
  const Pipeline first = bind_pipeline(t, unbound_vertex_stage(0, ""), unbound_fragment_stage("rgb"));
  Pipelines all{.changed = first.name, .vertex = first.vertex_program, .fragment = first.fragment_program};
  all.next_vertex = separable_program(t, GL_VERTEX_SHADER, unbound_vertex_stage(0.25F, ".grba"));
  all.next_fragment = separable_program(t, GL_FRAGMENT_SHADER, unbound_fragment_stage("brg"));
  gl.GenProgramPipelines(1, &all.other);
  gl.BindProgramPipeline(all.other);
  gl.UseProgramStages(all.other, GL_VERTEX_SHADER_BIT, all.vertex);
  gl.UseProgramStages(all.other, GL_FRAGMENT_SHADER_BIT, all.fragment);
  return all;
}

struct PipelineChange {
  const char* leaf;
  void (*make)(Pipelines& p);  // while p.changed is not bound
};

// A program in use would come before the pipeline. UseProgram is called only if there is one: it may make an implementation
// ask for everything.
void bind_alone(GLuint pipeline) {
  GLint program = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
  if (program != 0) gl.UseProgram(0);
  gl.BindProgramPipeline(pipeline);
}

GLint unbound_location_of(GLuint program, const char* name) { return gl.GetUniformLocation(program, name); }

constexpr PipelineChange pipeline_changes[] = {
    {"vertex_stage", [](Pipelines& p) { gl.UseProgramStages(p.changed, GL_VERTEX_SHADER_BIT, p.next_vertex); }},
    {"fragment_stage", [](Pipelines& p) { gl.UseProgramStages(p.changed, GL_FRAGMENT_SHADER_BIT, p.next_fragment); }},
    {"both_stages",
     [](Pipelines& p) {
       gl.UseProgramStages(p.changed, GL_VERTEX_SHADER_BIT, p.next_vertex);
       gl.UseProgramStages(p.changed, GL_FRAGMENT_SHADER_BIT, p.next_fragment);
     }},
    {"taken_away_and_given",
     [](Pipelines& p) {
       gl.UseProgramStages(p.changed, GL_ALL_SHADER_BITS, 0);
       gl.UseProgramStages(p.changed, GL_FRAGMENT_SHADER_BIT, p.fragment);
       gl.UseProgramStages(p.changed, GL_VERTEX_SHADER_BIT, p.next_vertex);
     }},
    {"program_uniform",
     [](Pipelines& p) { gl.ProgramUniform1f(p.vertex, unbound_location_of(p.vertex, "shift"), 0.3F); }},
    {"fragment_uniform",
     [](Pipelines& p) { gl.ProgramUniform1f(p.fragment, unbound_location_of(p.fragment, "tone"), 0.4F); }},
    {"matrix_uniform",
     [](Pipelines& p) {
       const GLfloat turn[] = {0, 0.35F, 0, 0};
       gl.ProgramUniformMatrix2fv(p.vertex, unbound_location_of(p.vertex, "turn"), 1, GL_TRUE, turn);
     }},
    {"active_program",
     [](Pipelines& p) {
       gl.ActiveShaderProgram(p.changed, p.vertex);
       bind_alone(p.changed);
       gl.Uniform1f(unbound_location_of(p.vertex, "shift"), 0.3F);
     }},
    {"active_program_of_fragments",
     [](Pipelines& p) {
       gl.ActiveShaderProgram(p.changed, p.fragment);
       bind_alone(p.changed);
       gl.Uniform1f(unbound_location_of(p.fragment, "tone"), 0.4F);
     }},
    {"deleted",
     [](Pipelines& p) {
       gl.DeleteProgramPipelines(1, &p.changed);  // some implementations give its name again
       gl.GenProgramPipelines(1, &p.changed);
       gl.BindProgramPipeline(p.changed);
       gl.BindProgramPipeline(p.other);
       gl.UseProgramStages(p.changed, GL_VERTEX_SHADER_BIT, p.next_vertex);
       gl.UseProgramStages(p.changed, GL_FRAGMENT_SHADER_BIT, p.fragment);
     }},
    {"deleted_program",
     [](Pipelines& p) {
       gl.DeleteProgram(p.vertex);  // the other pipeline still has it
       gl.UseProgramStages(p.changed, GL_VERTEX_SHADER_BIT, p.next_vertex);
     }},
};

enum class Bound { other, none, program };

void bind_instead(Bound bound, const Pipelines& p, GLuint program) {
  if (bound == Bound::program) gl.UseProgram(program);
  gl.BindProgramPipeline(bound == Bound::other ? p.other : 0);
}

void check_pipeline_change(Test& t, const PipelineChange& change, Bound bound, bool is_uniform) {
  const GLuint program = colour_program(t);
  Mesh mesh = one_triangle({1, 3, 2});
  for (MeshVertex& vertex : mesh) vertex.position[0] *= 0.6F;
  upload(mesh);
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  Pipelines pipelines = make_pipelines(t);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  gl.UseProgram(0);
  gl.BindProgramPipeline(pipelines.changed);
  expect_as_unrefined(t, draw, "the first pipeline");
  gl.BindProgramPipeline(pipelines.other);
  expect_as_unrefined(t, draw, "the other pipeline");
  gl.BindProgramPipeline(pipelines.changed);
  expect_change(
      t, draw,
      [&] {
        bind_instead(bound, pipelines, program);
        if (bound != Bound::none) repeat_often(draw);
        change.make(pipelines);
        if (bound == Bound::program) gl.UseProgram(0);
        gl.BindProgramPipeline(pipelines.changed);
      },
      change.leaf);
  gl.BindProgramPipeline(pipelines.other);
  expect_as_unrefined(t, draw, "the other pipeline, at last");
  gl.BindProgramPipeline(pipelines.changed);
  expect_as_unrefined(t, draw, "the changed pipeline, at last");
  t.expect(count_generated(draw) > 4, "the draws are refined");
  t.expect_no_error(change.leaf);
}

// Each pipeline is drawn once or often, and nothing else happens before the change.
void check_after_draws(Test& t, const PipelineChange& change, int history) {
  upload(one_triangle());
  refine_uniformly(2);
  Pipelines pipelines = make_pipelines(t);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  gl.UseProgram(0);
  for (const GLuint pipeline : {pipelines.changed, pipelines.other}) {
    gl.BindProgramPipeline(pipeline);
    for (int again = 0; again < history; ++again) draw();
  }
  change.make(pipelines);
  gl.BindProgramPipeline(pipelines.changed);
  const Picture refined = conformance::picture_of(draw);
  gl.Disable(GL_ARK);
  t.expect_same_picture(refined, conformance::picture_of(draw), fmt::format("{}, after {} draws", change.leaf, history),
                        4, 80);
  t.expect_no_error(change.leaf);
}

}  // namespace

Cases unbound_pipelines_cases() {
  Cases cases;
  for (const PipelineChange& change : pipeline_changes)
    cases.push_back({.name = std::string("ark.draw.again.unbound_pipeline.") + change.leaf,
                     .clauses = {"11.R.10-1", "10.R.2-1"},
                     .plan = "Repeat draws of two program pipelines. Change one while the other one, none, or a "
                             "program is in use; bind it, and repeat the draw.",
                     .wrong = "The earlier stages or uniforms of the pipeline.",
                     .check = [&change](Test& t) {
                       for (const int history : {1, 24}) check_after_draws(t, change, history);
                       for (const Bound bound : {Bound::other, Bound::none, Bound::program})
                         check_pipeline_change(t, change, bound, bound != Bound::none);
                     }});
  return cases;
}

}  // namespace glark::conformance
