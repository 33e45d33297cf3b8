// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that repeat very often, with another refinement or another program in between. An implementation may keep their
// refined vertices, but not when they are other ones.
#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

void draw_all() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

// The picture of the first draw, which that of the draws after many repetitions equals.
Picture expect_same_often(Test& t, const std::string& what) {
  Picture first = picture_of(draw_all);
  t.expect(count_different(first, Picture(surface_size, surface_size), 8) > 300, "something is drawn, " + what);
  repeat_often(draw_all);
  for (int again = 0; again < 2; ++again) t.expect_same_picture(picture_of(draw_all), first, what, 4, 40);
  t.expect_no_error(what);
  return first;
}

// The next draw of the application finds its own arrays.
void expect_unrefined(Test& t, const Picture& refined) {
  gl.Disable(GL_ARK);
  t.expect_same_picture(picture_of(draw_all), refined, "without refinement", 4, 80);
  gl.Enable(GL_ARK);
}

void check_level(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(bent_mesh());
  for (const int level : {2, 3, 1, 0, 2}) {
    refine_uniformly(level);
    for (int round = 0; round < 2; ++round) {
      t.expect_equal(count_generated(draw_all), GLuint{2} << (2 * level), "triangles");
      repeat_often(draw_all);
    }
  }
}

// Pools of other levels may have the patterns in other places.
void check_pool(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = bent_mesh();
  for (const GLuint level : {11U, 6U, 3U, 9U}) {
    for (MeshVertex& vertex : mesh) vertex.position = {-0.9F * vertex.position[1], vertex.position[0], 0, 1};
    upload(mesh);
    refine_uniformly(3);
    gl.ARKinit(level);
    expect_unrefined(t, expect_same_often(t, "pool level " + std::to_string(level)));
  }
}

struct Surface {
  GLenum refinement;
  float shape;
  const char* name;
};

// The curved surfaces of the same mesh have other outlines.
void check_surface(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex =
              "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal; out vec4 colour;\n"
              "void main() { colour = vec4(abs(normalize(normal)), 1.0); gl_Position = vec4(position.xyz, 1.6); }\n"}));
  upload(bent_mesh());
  const Surface surfaces[] = {{GL_LINEAR_INPUTS_ARK, 1, "linear inputs"},
                              {GL_CURVED_PN_ARK, 1, "curved triangles"},
                              {GL_PHONG_ARK, 1, "Phong tessellation"},
                              {GL_PHONG_ARK, 0.25F, "Phong tessellation with another shape"}};
  std::vector<Picture> pictures;
  for (int round = 0; round < 2; ++round)
    for (const Surface& surface : surfaces) {
      refine_uniformly(4, surface.refinement);
      gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, surface.shape);
      pictures.push_back(expect_same_often(t, surface.name));
    }
  for (std::size_t i = 0; i < 4; ++i) {
    t.expect_same_picture(pictures[i + 4], pictures[i], std::string(surfaces[i].name) + " again", 4, 40);
    for (std::size_t other = 0; other < i; ++other)
      t.expect(count_different(pictures[i], pictures[other], 8) > 100, "the surfaces differ");
  }
}

// The program changes, the inputs do not. A flat output keeps the value of the provoking corner.
void check_program(Test& t) {
  const std::string vertex =
      "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
      "flat out vec4 flat_colour; out vec4 colour; uniform float part;\n"
      "void main() { flat_colour = vertex_colour; colour = vertex_colour.yzxw * part; gl_Position = position; }\n";
  const GLuint plain = colour_program(t);
  const GLuint flat = build_program(t, {.vertex = vertex,
                                        .fragment = "flat in vec4 flat_colour; in vec4 colour; out vec4 pixel;\n"
                                                    "void main() { pixel = mix(flat_colour, colour, 0.25); }"});
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {i % 2 == 0 ? 1.0F : 0.1F, i % 3 == 0 ? 1.0F : 0.2F, 0.15F * static_cast<float>(i), 1};
  upload(mesh);
  refine_uniformly(3);
  for (int round = 0; round < 2; ++round) {
    gl.UseProgram(plain);
    const Picture smooth = expect_same_often(t, "smooth colours");
    expect_unrefined(t, smooth);
    gl.UseProgram(flat);
    for (const float part : {1.0F, 0.0F}) {
      gl.Uniform1f(gl.GetUniformLocation(flat, "part"), part);
      const Picture mixed = expect_same_often(t, "flat colours");
      t.expect(count_different(mixed, smooth, 8) > 300, "the programs differ");
      expect_unrefined(t, mixed);
    }
  }
}

// Squares of colours: between the corners, interpolated inputs give other outputs than interpolated outputs.
void check_outputs(Test& t) {
  gl.UseProgram(build_program(
      t,
      {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
                 "void main() { colour = vertex_colour * vertex_colour; gl_Position = position; }\n"}));
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {i % 3 == 0 ? 1.0F : 0.0F, i % 3 == 1 ? 1.0F : 0.0F, i % 3 == 2 ? 1.0F : 0.0F, 1};
  upload(mesh);
  for (int round = 0; round < 2; ++round) {
    refine_uniformly(3, GL_LINEAR_INPUTS_ARK);
    const Picture inputs = expect_same_often(t, "interpolated inputs");
    refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK);
    const Picture outputs = expect_same_often(t, "interpolated outputs");
    t.expect(count_different(inputs, outputs, 8) > 300, "the refinements differ");
  }
}

// No index of the implementation's own restarts a primitive. Some drivers restart draws without indices, too.
void check_restart(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(bent_mesh());
  refine_uniformly(3);
  gl.Enable(GL_PRIMITIVE_RESTART);
  for (const GLuint index : {1U, 20U, 50U}) {
    gl.PrimitiveRestartIndex(index);
    gl.Disable(GL_ARK);
    const GLuint unrefined = count_generated(draw_all);
    const Picture plain = picture_of(draw_all);
    gl.Enable(GL_ARK);
    for (int again = 0; again < 3; ++again) {
      t.expect_same_picture(picture_of(draw_all), plain, "with a restart index", 4, 80);
      t.expect_equal(count_generated(draw_all), 64 * unrefined, "triangles with a restart index");
      repeat_often(draw_all);
    }
  }
}

// Fixed function: colours, coordinates and normals of the arrays reach the picture.
void check_fixed_function(Test& t) {
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {i % 2 == 0 ? 1.0F : 0.1F, i % 3 == 0 ? 1.0F : 0.2F, 0.15F * static_cast<float>(i), 1};
  upload(mesh);
  gl.DisableVertexAttribArray(at_position);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, position)));
  gl.ColorPointer(4, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, colour)));
  gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, normal)));
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY}) gl.EnableClientState(array);
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const Picture unlit = expect_same_often(t, "unlit");
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_COLOR_MATERIAL);
  const Picture lit = expect_same_often(t, "lit");
  gl.ShadeModel(GL_FLAT);
  const Picture flat = expect_same_often(t, "lit, flat");
  gl.ShadeModel(GL_SMOOTH);
  t.expect_same_picture(expect_same_often(t, "lit again"), lit, "lit again", 4, 40);
  t.expect(count_different(unlit, lit, 8) > 300 && count_different(flat, lit, 8) > 300, "the modes differ");
}

constexpr Area often_case{"ark.draw.often."};

}  // namespace

Cases changed_refinement_cases() {
  return {
      often_case("level", {"11.R.13-1", "11.R.2-2"}, "Repeat a draw very often with each of several uniform levels.",
                 "The level of earlier draws.", check_level),
      often_case("pool", {"11.R.13-1", "11.R.1-5", "11.R.1-8"},
                 "Repeat a draw very often with each of several pools, and another mesh each time.",
                 "Patterns that lie where they lay in the earlier pool.", check_pool),
      often_case("surface", {"11.R.13-1", "11.R.7c-6"},
                 "Repeat a draw very often with linear inputs, curved triangles, and two shapes of Phong tessellation.",
                 "The surface of earlier draws.", check_surface),
      often_case("program", {"11.R.13-1", "11.R.6-10"},
                 "Repeat a draw very often with two programs in turn; one has flat outputs.",
                 "The outputs of earlier draws; flat values of the refined triangles.", check_program),
      often_case("outputs", {"11.R.13-1", "11.R.6-1"},
                 "Repeat a draw very often with interpolated inputs and interpolated outputs in turn.",
                 "The outputs of the other refinement.", check_outputs),
      often_case("restart", {"11.R.13-1", "10.R.2-2"}, "Repeat a draw very often while a restart index is enabled.",
                 "The restart index cuts the implementation's own triangles.", check_restart, desktop_apis),
      often_case("fixed_function", {"11.R.13-1"},
                 "Fixed function: repeat a draw very often, unlit, lit, and with flat shading.",
                 "Attributes that are not drawn; smooth colours where they should be flat.", check_fixed_function,
                 compat_only),
  };
}

}  // namespace glark::conformance
