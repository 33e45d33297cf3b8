// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// DISPLACEMENT_UNIT_ARK with every texture image unit up to the limit, however its texture and its sampler are bound,
// under every refinement, and in all that reads the height map (11.R.7b).
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/counted.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

GLint units_of_context() {
  GLint units = 0;
  gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  return units;
}

// Ends of the ranges that an implementation may tell apart, and the last unit.
std::vector<GLint> telling_units() {
  std::vector<GLint> units;
  for (const GLint unit : {0, 1, 7, 8, 15, 16, 17, 20, 31, 32, 33, 47, 48, 63, 64, 95})
    if (unit < units_of_context()) units.push_back(unit);
  units.push_back(units_of_context() - 1);
  return units;
}

// Different for units whose numbers are equal modulo a power of two.
GLubyte height_byte(GLint unit) { return static_cast<GLubyte>(23 + (unit * 37) % 211); }
double height_of(GLint unit) { return height_byte(unit) / 255.0; }

GLuint make_even_texture(GLubyte height) {
  const std::array<GLubyte, 4> texel = {height, height, height, height};
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

// A texture of one texel for each unit, which has the unit's height.
std::vector<GLuint> make_textures() {
  std::vector<GLuint> textures;
  for (GLint unit = 0; unit < units_of_context(); ++unit) textures.push_back(make_even_texture(height_byte(unit)));
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return textures;
}

// How the textures get to the units.
struct UnitBinding {
  const char* leaf;
  void (*bind)(const std::vector<GLuint>& textures);
  int version = 0;
  Apis apis = every_api;
};

void bind_each(const std::vector<GLuint>& textures) {
  for (std::size_t unit = 0; unit < textures.size(); ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, textures[unit]);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

// Other targets of each unit have white textures.
void bind_among_others(const std::vector<GLuint>& textures) {
  bind_each(textures);
  const std::vector<GLubyte> white(64, 255);
  std::array<GLuint, 3> others{};
  gl.GenTextures(3, others.data());
  for (std::size_t unit = 0; unit < textures.size(); ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_3D, others[0]);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, others[1]);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, others[2]);
  }
  for (const GLenum target : {GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY})
    gl.TexImage3D(target, 0, GL_RGBA8, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  gl.ActiveTexture(GL_TEXTURE0);
}

constexpr UnitBinding unit_bindings[] = {
    {"bind_texture", bind_each},
    {"bind_textures",
     [](const std::vector<GLuint>& textures) {
       gl.BindTextures(0, static_cast<GLsizei>(textures.size()), textures.data());
     },
     44, desktop_apis},
    {"bind_texture_unit",
     [](const std::vector<GLuint>& textures) {
       for (std::size_t unit = 0; unit < textures.size(); ++unit)
         gl.BindTextureUnit(static_cast<GLuint>(unit), textures[unit]);
     },
     45, desktop_apis},
    {"other_targets", bind_among_others},
};

Mesh level_triangle() {
  Mesh mesh = one_triangle();
  const Vec2 coordinates[] = {{0.1F, 0.2F}, {0.8F, 0.3F}, {0.4F, 0.9F}};
  for (std::size_t i = 0; i < 3; ++i) mesh[i].texture = coordinates[i];
  return mesh;
}

void refine_displaced(GLenum refinement) {
  refine_uniformly(1, refinement);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.125F);
}

// Every vertex is as high as the texture of this unit says.
bool expect_height(Test& t, const Mesh& mesh, double height, const std::string& what) {
  const auto vertices = capture_surface(t, mesh);
  if (!t.expect_equal(vertices.size(), 12U, what + ": vertices")) return false;
  for (const SurfaceVertex& vertex : vertices)
    if (!t.expect_near(vertex.position[2], 0.5 * height + 0.125, 1e-5, what + ": the height")) return false;
  return true;
}

void check_binding(Test& t, const UnitBinding& binding) {
  if (t.version() < binding.version) t.not_supported("no such command");
  gl.UseProgram(surface_program(t));
  const Mesh mesh = level_triangle();
  upload(mesh);
  binding.bind(make_textures());
  refine_displaced(GL_LINEAR_INPUTS_ARK);
  for (GLint unit = 0; unit < units_of_context(); ++unit) {
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
    if (!expect_height(t, mesh, height_of(unit), fmt::format("unit {}", unit))) return;
  }
  t.expect_no_error("the draws");
}

struct HeightReader {
  const char* leaf;
  GLenum refinement = GL_LINEAR_INPUTS_ARK;
  bool is_welded = false;
};
constexpr HeightReader height_readers[] = {
    {.leaf = "inputs"},
    {.leaf = "curved", .refinement = GL_CURVED_PN_ARK},
    {.leaf = "tagged", .refinement = GL_SCALAR_TAGGED_PN_ARK},
    {.leaf = "phong", .refinement = GL_PHONG_ARK},
    {.leaf = "welded", .is_welded = true},
    {.leaf = "welded_curved", .refinement = GL_CURVED_PN_ARK, .is_welded = true}};

// Whether the triangle lies before this depth in normalized device coordinates, drawn to the screen.
bool lies_before(double depth) {
  clear_surface();
  gl.ClearDepthf(static_cast<GLfloat>(depth / 2 + 0.5));
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Disable(GL_DEPTH_TEST);
  return count_different(read_picture(surface_size, surface_size), Picture(surface_size, surface_size), 8) > 400;
}

void expect_depth(Test& t, double height, const std::string& what) {
  const double depth = 0.5 * height + 0.125;
  t.expect(lies_before(depth + 0.004) && !lies_before(depth - 0.004), what + ": the height on the screen");
}

// Then the texture of the unit is replaced, after many draws. An implementation may refine differently with transform
// feedback.
void check_reader(Test& t, const HeightReader& reader) {
  gl.UseProgram(surface_program(t));
  const Mesh mesh = level_triangle();
  upload(mesh);
  const GLuint other = make_even_texture(251);
  refine_displaced(reader.refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, reader.is_welded ? GL_TRUE : GL_FALSE);
  bind_each(make_textures());
  for (const GLint unit : telling_units()) {
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
    repeat_often([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    expect_depth(t, height_of(unit), fmt::format("unit {}", unit));
    if (!expect_height(t, mesh, height_of(unit), fmt::format("unit {}", unit))) return;
    repeat_often([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, other);
    gl.ActiveTexture(GL_TEXTURE0);
    expect_depth(t, 251 / 255.0, fmt::format("another texture of unit {}", unit));
    if (!expect_height(t, mesh, 251 / 255.0, fmt::format("another texture of unit {}", unit))) return;
  }
  t.expect_no_error("the draws");
}

// A texture of two texels: 0 below the middle, and 1 above it. Samplers of the units tell where T = 1.4 lies.
GLuint make_halves() {
  const std::array<GLubyte, 8> texels = {0, 0, 0, 255, 255, 255, 255, 255};
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  return texture;
}

GLuint make_sampler(GLenum wrap) {
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
  return sampler;
}

// The unit repeats, where T reads 0; its neighbours clamp, where T would read 1; or the other way round.
void check_samplers(Test& t) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = level_triangle();
  for (MeshVertex& vertex : mesh) vertex.texture = {1.3F + 0.1F * vertex.texture[0], 0.5F};
  upload(mesh);
  const auto count = static_cast<std::size_t>(units_of_context());
  bind_each(std::vector<GLuint>(count, make_halves()));
  refine_displaced(GL_LINEAR_INPUTS_ARK);
  const GLuint repeating = make_sampler(GL_REPEAT);
  const GLuint clamping = make_sampler(GL_CLAMP_TO_EDGE);
  for (const bool repeats : {true, false}) {
    for (std::size_t unit = 0; unit < count; ++unit)
      gl.BindSampler(static_cast<GLuint>(unit), repeats ? clamping : repeating);
    for (const GLint unit : telling_units()) {
      gl.BindSampler(static_cast<GLuint>(unit), repeats ? repeating : clamping);
      gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
      if (!expect_height(t, mesh, repeats ? 0 : 1, fmt::format("the sampler of unit {}", unit))) return;
      gl.BindSampler(static_cast<GLuint>(unit), repeats ? clamping : repeating);
    }
  }
  t.expect_no_error("the draws");
}

// Measured errors, geomorphing, other channels and the fixed function: a step of the height shows.
void check_measured(Test& t) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = level_triangle();
  const Vec2 coordinates[] = {{0.1F, 0.5F}, {0.9F, 0.5F}, {0.9F, 0.5F}};
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i].texture = coordinates[i];
    mesh[i].normal = {0, 1, 0};
  }
  upload(mesh);
  const auto count = static_cast<std::size_t>(units_of_context());
  const GLuint even = make_even_texture(255);
  const GLuint halves = make_halves();
  refine_uniformly(3);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 1);
  clear_surface();
  for (const bool is_step : {true, false}) {
    bind_each(std::vector<GLuint>(count, is_step ? even : halves));
    for (const GLint unit : telling_units()) {
      gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
      gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
      gl.BindTexture(GL_TEXTURE_2D, is_step ? halves : even);
      const GLuint triangles = count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
      t.expect(is_step ? triangles > 2 : triangles == 1,
               fmt::format("unit {}: {} triangles of {} surface", unit, triangles, is_step ? "a stepped" : "an even"));
      gl.BindTexture(GL_TEXTURE_2D, is_step ? even : halves);
    }
  }
  gl.ActiveTexture(GL_TEXTURE0);
  t.expect_no_error("the draws");
}

// The triangle's normal points to the right: the height moves it there.
void check_fixed_units(Test& t) {
  bind_each(make_textures());
  refine_uniformly(1);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  const auto draw = [](float shift) {
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(1, 0, 0);
    gl.Color3f(1, 0.5F, 0.25F);
    for (const MeshVertex& vertex : one_triangle())
      gl.Vertex2f(0.5F * vertex.position[0] - 0.4F + shift, 0.5F * vertex.position[1]);
    gl.End();
  };
  for (const GLint unit : telling_units()) {
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
    const Picture expected = picture_of([&] { draw(0.5F * static_cast<float>(height_of(unit))); });
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
    t.expect_same_picture(picture_of([&] { draw(0); }), expected, fmt::format("unit {}", unit), 2, 60);
  }
  t.expect_no_error("the draws");
}

constexpr Area unit_case{"ark.displacement.units."};

}  // namespace

Cases all_units_cases() {
  const std::vector<std::string> clauses = {"11.R.7b-1", "11.R.7b-2"};
  Cases cases;
  for (const UnitBinding& binding : unit_bindings) {
    Case each = unit_case(
        binding.leaf, clauses, "The texture of every unit has another height; displace by each of them.",
        "Units above 15 or 31 are taken modulo that number; the texture of another target.",
        [&binding](Test& t) { check_binding(t, binding); }, binding.apis);
    each.is_optional = binding.version != 0;
    cases.push_back(each);
  }
  for (const HeightReader& reader : height_readers)
    cases.push_back(unit_case(
        std::string("kept.") + reader.leaf, clauses, "Draw often by one of many units, then replace its texture.",
        "Another unit is read, or the texture of the first draw.", [&reader](Test& t) { check_reader(t, reader); }));
  cases.push_back(unit_case("samplers", clauses, "The sampler of one unit repeats, while those of all others clamp.",
                            "The sampler of another unit.", check_samplers));
  cases.push_back(unit_case("measured", {"11.R.7b-2", "11.R.4-19", "11.R.4-20"},
                            "The surface of one unit has a step, those of all others are even; measure the error.",
                            "The measure reads another unit.", check_measured));
  cases.push_back(unit_case(
      "fixed_function", {"11.R.7b-2", "11.R.7b-7"}, "Displace the fixed function by one of many units.",
      "Units above the texture coordinate sets of the fixed function are left out.", check_fixed_units, compat_only));
  return cases;
}

}  // namespace glark::conformance
