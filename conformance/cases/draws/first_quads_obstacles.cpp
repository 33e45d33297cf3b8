// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first quads of a context, in circumstances in which GL would show nothing of a quad that an implementation drew to
// find out how GL divides it.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLfloat quad_places[4][2] = {{-0.8F, -0.8F}, {0.8F, -0.8F}, {0.8F, 0.8F}, {-0.8F, 0.8F}};
// The quad is not the same along both diagonals.
constexpr GLfloat quad_colours[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

struct QuadDraw {
  const char* leaf;
  GLenum mode;
  bool has_array;
};
constexpr QuadDraw quad_draws[] = {{"quads.begin", GL_QUADS, false},
                                   {"quads.array", GL_QUADS, true},
                                   {"quad_strip.begin", GL_QUAD_STRIP, false},
                                   {"quad_strip.array", GL_QUAD_STRIP, true}};

class OneQuad {
 public:
  explicit OneQuad(const QuadDraw& draw) : draw_(draw) {
    const bool is_strip = draw.mode == GL_QUAD_STRIP;
    for (const std::size_t corner : {0, 1, is_strip ? 3 : 2, is_strip ? 2 : 3}) {
      places_.insert(places_.end(), quad_places[corner], quad_places[corner] + 2);
      colours_.insert(colours_.end(), quad_colours[corner], quad_colours[corner] + 3);
    }
    if (draw.has_array) {
      gl.VertexPointer(2, GL_FLOAT, 0, places_.data());
      gl.ColorPointer(3, GL_FLOAT, 0, colours_.data());
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.EnableClientState(GL_COLOR_ARRAY);
    }
  }
  void draw() const {
    if (draw_.has_array) return gl.DrawArrays(draw_.mode, 0, 4);
    gl.Begin(draw_.mode);
    for (std::size_t i = 0; i < 4; ++i) {
      gl.Color3fv(&colours_[3 * i]);
      gl.Vertex2fv(&places_[2 * i]);
    }
    gl.End();
  }

 private:
  QuadDraw draw_;
  std::vector<GLfloat> places_;
  std::vector<GLfloat> colours_;
};

void bind_samples() {
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint buffers[2] = {};
  gl.GenRenderbuffers(2, buffers);
  for (const auto& [at, format, buffer] :
       {std::tuple<GLenum, GLenum, GLuint>{GL_COLOR_ATTACHMENT0, GL_RGBA8, buffers[0]},
        {GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, buffers[1]}}) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, format, surface_size, surface_size);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, at, GL_RENDERBUFFER, buffer);
  }
}

// Each is switched on before the first refined quad, and stays so.
struct Obstacle {
  const char* name;
  void (*put)();
  bool is_multisampled = false;
};

constexpr Obstacle obstacles[] = {
    {"samples", [] {}, true},
    {"sample_shading",
     [] {
       gl.Enable(GL_SAMPLE_SHADING);
       gl.MinSampleShading(1);
     },
     true},
    {"one_sample",
     [] {
       gl.Enable(GL_SAMPLE_MASK);
       gl.SampleMaski(0, 8);
     },
     true},
    {"other_sample_states",
     [] {
       gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
       gl.Enable(GL_SAMPLE_COVERAGE);
       gl.SampleCoverage(0.5F, GL_TRUE);
       gl.Enable(GL_SAMPLE_SHADING);
     },
     true},
    {"restart_and_storage",
     [] {
       GLuint buffer = 0;
       gl.GenBuffers(1, &buffer);
       gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
       gl.BufferData(GL_SHADER_STORAGE_BUFFER, 1024, nullptr, GL_STATIC_DRAW);
       gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, buffer, 256, 512);
       gl.Enable(GL_PRIMITIVE_RESTART);
       gl.PrimitiveRestartIndex(2);
     }},
    {"deleted_statistics",
     [] {
       for (const GLenum target : {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_VERTEX_SHADER_INVOCATIONS,
                                   GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES}) {
         GLuint query = 0;
         gl.GenQueries(1, &query);
         gl.BeginQuery(target, query);
         gl.DeleteQueries(1, &query);
       }
     }},
    {"deleted_streams",
     [] {
       for (const GLenum target : {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN})
         for (const GLuint stream : {0U, 1U, 3U}) {
           GLuint query = 0;
           gl.GenQueries(1, &query);
           gl.BeginQueryIndexed(target, stream, query);
           gl.DeleteQueries(1, &query);
         }
     }},
    {"ended_twice",
     [] {
       GLuint queries[2] = {};
       gl.GenQueries(2, queries);
       gl.BeginQuery(GL_VERTICES_SUBMITTED, queries[0]);
       gl.EndQuery(GL_VERTICES_SUBMITTED);
       gl.EndQuery(GL_VERTICES_SUBMITTED);
       gl.BeginQuery(GL_VERTICES_SUBMITTED, queries[1]);
       gl.BeginQuery(GL_VERTICES_SUBMITTED, queries[0]);
       gl.EndQuery(GL_VERTICES_SUBMITTED);
       while (gl.GetError() != GL_NO_ERROR) continue;
     }},
};

Picture picture_with_samples(const OneQuad& quad) {
  const GLint drawn = integer_of(GL_DRAW_FRAMEBUFFER_BINDING);
  clear_surface();
  quad.draw();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  Picture picture = picture_of([&] {
    gl.BlitFramebuffer(0, 0, surface_size, surface_size, 0, 0, surface_size, surface_size, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  });
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(drawn));
  return picture;
}

// States that an implementation may change for a while, and must restore.
std::vector<GLint> other_states() {
  GLint offset = 0;
  GLint size = 0;
  gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_START, 0, &offset);
  gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_SIZE, 0, &size);
  std::vector<GLint> states{offset, size};
  for (const GLenum state : {GL_MULTISAMPLE, GL_SAMPLE_MASK, GL_SAMPLE_SHADING, GL_SAMPLE_COVERAGE,
                             GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_PRIMITIVE_RESTART})
    states.push_back(gl.IsEnabled(state));
  return states;
}

void check_obstacle(Test& t, const Obstacle& obstacle, const QuadDraw& draw) {
  if (t.version() < 46 && !t.has_extension("GL_ARB_pipeline_statistics_query")) t.not_supported("no statistics");
  const OneQuad quad(draw);
  if (obstacle.is_multisampled) {
    bind_samples();
    t.expect(integer_of(GL_SAMPLES) >= 4, "samples");
  }
  const auto picture = [&] {
    return obstacle.is_multisampled ? picture_with_samples(quad) : picture_of([&] { quad.draw(); });
  };
  obstacle.put();
  const Picture plain = picture();
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 200, "the unrefined quad is seen");
  const std::vector<GLint> before = other_states();
  refine_uniformly(2);
  for (int again = 0; again < 3; ++again)
    t.expect_same_picture(picture(), plain, "the quad, drawn for time " + as_text(again), 3, 40);
  t.expect(other_states() == before, "the states are as before");
  t.expect_no_error("the draws");
}

}  // namespace

Cases first_quads_obstacles_cases() {
  Cases cases;
  for (const Obstacle& obstacle : obstacles)
    for (const QuadDraw& draw : quad_draws)
      cases.push_back({.name = std::string("ark.draw.first_quads.") + obstacle.name + "." + draw.leaf,
                       .clauses = {"10.R.2-1", "11.R.3-5"},
                       .plan =
                           "The first quads of a context are drawn into samples, or after queries that were deleted "
                           "or ended while they were active. They have the unrefined picture.",
                       .wrong = "Quads are divided along the other diagonal.",
                       .apis = compat_only,
                       .check = [&obstacle, &draw](Test& t) { check_obstacle(t, obstacle, draw); }});
  return cases;
}

}  // namespace glark::conformance
