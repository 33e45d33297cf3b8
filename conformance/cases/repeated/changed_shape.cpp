// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that repeat very often, with a change of what shapes their surface in between: tags of the vertices, the texture
// of displacement and its sampling, uniforms of the refinement shader. An implementation may keep their refined
// vertices, but not after such a change.
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr GLint unit = 3;
constexpr int size = 4;

void draw_all() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

GLuint shape_program(Test& t) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                                     "layout(location = 4) in vec2 texcoord; out vec4 colour;\n"
                                     "void main() { colour = vec4(abs(normalize(normal)), 1.0) + 0.01 * texcoord.x;\n"
                                     "  gl_Position = vec4(position.xyz, 1.6); }\n"});
}

Picture expect_same_often(Test& t, const std::string& what) {
  Picture first = picture_of(draw_all);
  t.expect(count_different(first, Picture(surface_size, surface_size), 8) > 300, "something is drawn, " + what);
  repeat_often(draw_all);
  t.expect_same_picture(picture_of(draw_all), first, what, 4, 40);
  t.expect_no_error(what);
  return first;
}

struct Change {
  const char* name;
  std::function<void()> make;
};
void expect_changes(Test& t, const std::vector<Change>& changes) {
  Picture before = expect_same_often(t, "at first");
  for (const Change& change : changes) {
    change.make();
    Picture after = expect_same_often(t, std::string("after ") + change.name);
    t.expect(count_different(before, after, 8) > 60, std::string(change.name) + " shows");
    before = std::move(after);
  }
}

// The edges of two triangles are long enough that the depths of a curved surface show.
void check_depth_tags(Test& t) {
  gl.UseProgram(shape_program(t));
  Mesh mesh = bent_mesh();
  for (MeshVertex& vertex : mesh) vertex.tag = 4;
  const MeshBuffers buffers = upload(mesh);
  refine_by_tags(5, GL_CURVED_PN_ARK);
  const auto write = [&](float first, float others) {
    for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = i == 0 || i == 5 ? first : others;
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers.buffer);
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data());
  };
  expect_changes(t, {{"no depths", [&] { write(0, 0); }},
                     {"other depths", [&] { write(5, 3); }},
                     {"depths of some edges", [&] { write(0, 1); }}});
}

void check_scalar_tags(Test& t) {
  gl.UseProgram(shape_program(t));
  upload(bent_mesh());
  ShapeTags tags{std::vector<Vec4>(6, {0.5F, -0.6F, 0.1F, 3}), std::vector<Vec3>(6, {1, 0, 0})};
  upload_shape_tags(tags);
  refine_uniformly(4, GL_SCALAR_TAGGED_PN_ARK);
  const auto write = [](const auto& values) {  // the buffer of the scalar tags is bound
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(values.size() * sizeof(values[0])), values.data());
  };
  expect_changes(t, {{"a tension",
                      [&] {
                        write(std::vector<Vec3>(6, {1, 1, 0}));
                      }},
                     {"a negative tension",
                      [&] {
                        write(std::vector<Vec3>(6, {0, -1, 0}));
                      }},
                     {"current tags", [] {
                        gl.DisableVertexAttribArray(13);
                        gl.VertexAttrib3f(13, 1, 0.9F, 0);
                      }}});
}

std::vector<GLubyte> texels(int step) {
  std::vector<GLubyte> values;
  for (int i = 0; i < size * size; ++i)
    for (int channel = 0; channel < 4; ++channel)
      values.push_back(static_cast<GLubyte>((step * i * (channel + 1) + 90 * channel) % 256));
  return values;
}

// The texture is bound to the active unit.
std::vector<Change> changes_of_texture(GLuint texture, GLuint other, GLuint sampler) {
  return {{"glTexSubImage2D",
           [] {
             const std::vector<GLubyte> values = texels(71);
             gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, values.data());
           }},
          {"glTexParameteri", [] { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_BLUE); }},
          {"another texture", [other] { gl.BindTexture(GL_TEXTURE_2D, other); }},
          {"the first texture", [texture] { gl.BindTexture(GL_TEXTURE_2D, texture); }},
          {"a sampler", [sampler] { gl.BindSampler(unit, sampler); }},
          {"a parameter of the sampler",
           [sampler] {
             gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
             gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
           }},
          {"the scale", [] { gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, -0.4F); }},
          {"the bias", [] { gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.3F); }},
          {"the channel", [] { gl.ARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, GL_GREEN); }},
          {"another unit", [] { gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit + 1); }},
          {"glTexSubImage2D of the other unit's texture",
           [] {
             const std::vector<GLubyte> values = texels(29);
             gl.ActiveTexture(GL_TEXTURE0 + unit + 1);
             gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, values.data());
           }},
          {"no displacement", [] { gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1); }}};
}

void prepare_displacement(Test& t, GLuint& texture, GLuint& other) {
  gl.UseProgram(shape_program(t));
  upload(bent_mesh());
  GLint name = 0;
  for (GLuint* const made : {&other, &texture}) {
    bind_nearest_texture(unit, size, texels(made == &texture ? 37 : 113));
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &name);
    *made = static_cast<GLuint>(name);
  }
  gl.ActiveTexture(GL_TEXTURE0 + unit + 1);
  gl.BindTexture(GL_TEXTURE_2D, other);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  refine_uniformly(4, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.4F);
}

void check_displacement(Test& t) {
  GLuint texture = 0;
  GLuint other = 0;
  prepare_displacement(t, texture, other);
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  expect_changes(t, changes_of_texture(texture, other, sampler));
}

// The texture is drawn to.
void check_drawn_texture(Test& t) {
  GLuint texture = 0;
  GLuint other = 0;
  prepare_displacement(t, texture, other);
  GLuint framebuffer = 0;
  GLint drawn = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(drawn));
  expect_changes(t, {{"a cleared texture", [&] {
                        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
                        const float white[4] = {1, 1, 1, 1};
                        gl.ClearBufferfv(GL_COLOR, 0, white);
                        gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(drawn));
                      }}});
}

// The depths follow from the lengths of edges on the screen. No draw repeats while the expected pictures are made.
void check_measured(Test& t) {
  const GLuint program =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                                  "uniform float scale; out vec4 colour;\n"
                                  "void main() { colour = vec4(abs(normalize(normal)), 1.0);\n"
                                  "  gl_Position = vec4(scale * position.xyz, 1.6); }\n"});
  gl.UseProgram(program);
  upload(bent_mesh());
  refine_by_tags(5, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  const auto look = [program](float scale, GLint pixels) {
    gl.Uniform1f(gl.GetUniformLocation(program, "scale"), scale);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  };
  const auto expect_after = [&](const std::function<void()>& first, const std::function<void()>& then,
                                const char* what) {
    then();
    const Picture expected = picture_of(draw_all);
    first();
    repeat_often(draw_all);
    t.expect(count_different(picture_of(draw_all), expected, 8) > 60, std::string(what) + " shows");
    then();
    t.expect_same_picture(picture_of(draw_all), expected, std::string("after ") + what, 4, 40);
  };
  expect_after([&] { look(0.1F, 16); }, [&] { look(1, 16); }, "a uniform");
  expect_after([&] { look(1, 1000); }, [&] { look(1, 4); }, "finer edges");
  expect_after([&] { look(1, 4); }, [&] { look(1, 1000); }, "coarser edges");
  t.expect_no_error("measured depths");
}

void check_refinement_shader(Test& t) {
  const GLuint program = shape_program(t);
  gl.UseProgram(program);
  upload(bent_mesh());
  refine_uniformly(4);
  set_refinement_shader(t, program, "uniform float bend; void refine() { position.xy += bend * ark_barycentric.xy; }");
  const auto bend = [program](float value) { gl.Uniform1f(gl.GetUniformLocation(program, "bend"), value); };
  bend(0.1F);
  expect_changes(
      t, {{"a uniform", [&] { bend(-0.4F); }},
          {"the uniform again", [&] { bend(0.3F); }},
          {"another shader", [&] { set_refinement_shader(t, program, "void refine() { position *= 0.7; }"); }},
          {"a third shader", [&] { set_refinement_shader(t, program, "void refine() { position *= 0.4; }"); }}});
}

constexpr Area often_case{"ark.draw.often."};

}  // namespace

Cases changed_shape_cases() {
  return {
      often_case("depth_tags", {"11.R.13-1"}, "Repeat a draw very often with depth tags that are rewritten.",
                 "The depths of earlier draws.", check_depth_tags),
      often_case("measured", {"11.R.13-1", "11.R.4-4"},
                 "Repeat a draw with measured depths very often; change a uniform of its positions, and the measure.",
                 "The depths of the earlier view.", check_measured),
      often_case("scalar_tags", {"11.R.13-1"},
                 "Repeat a draw very often with scalar tags that are rewritten, and then are current values.",
                 "The surface of earlier tags.", check_scalar_tags),
      often_case("displacement", {"11.R.13-1", "11.R.7b-2"},
                 "Repeat a displaced draw very often; change the texture, its sampling, and each parameter.",
                 "The surface of an earlier texture, sampler or parameter.", check_displacement),
      often_case("drawn_texture", {"11.R.13-1", "11.R.7b-2"},
                 "Repeat a displaced draw very often; then draw to its texture by a framebuffer.",
                 "The surface of the texture before it was drawn to.", check_drawn_texture),
      often_case("refinement_shader", {"11.R.13-1"},
                 "Repeat a draw with a refinement shader very often; change its uniform and its text.",
                 "The surface of the earlier uniform or text.", check_refinement_shader),
  };
}

}  // namespace glark::conformance
