// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement (11.R.7b). Textures are small, so that the samplers' results are known.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr int size = 4;
constexpr GLint unit = 3;

// Values of 0 to 255, different for each texel and channel.
float texel(int x, int y, int channel) {
  return static_cast<float>((37 * x + 59 * y + 83 * channel + 11 * x * y) % 256) / 255;
}

void bind_displacement_texture() {
  std::vector<GLubyte> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int channel = 0; channel < 4; ++channel)
        texels.push_back(static_cast<GLubyte>(std::lround(255 * texel(x, y, channel))));
  bind_nearest_texture(unit, size, texels);
}

int wrapped(int i, bool is_clamped) { return is_clamped ? std::clamp(i, 0, size - 1) : ((i % size) + size) % size; }

// Based on: section 8.14.2 of the OpenGL specification.
double sampled(double s, double t, int channel, bool is_linear, bool is_clamped) {
  const double x = s * size - (is_linear ? 0.5 : 0);
  const double y = t * size - (is_linear ? 0.5 : 0);
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto at = [&](int i, int j) {
    return static_cast<double>(texel(wrapped(i, is_clamped), wrapped(j, is_clamped), channel));
  };
  if (!is_linear) return at(x0, y0);
  const double a = x - x0;
  const double b = y - y0;
  return (1 - b) * ((1 - a) * at(x0, y0) + a * at(x0 + 1, y0)) +
         b * ((1 - a) * at(x0, y0 + 1) + a * at(x0 + 1, y0 + 1));
}

struct Displacing {
  const char* leaf;
  std::vector<std::string> clauses;
  const char* plan;
  const char* wrong;
  GLenum refinement = GL_LINEAR_INPUTS_ARK;
  int channel = 0;
  float scale = 0.5F;
  float bias = 0;
  bool is_linear = false;
  bool is_clamped = false;
  bool has_sampler = false;
  bool has_attribute = false;  // DISPLACEMENT_COORDINATE_ARK
  bool has_mipmaps = false;    // with another level 1
  unsigned depth = 3;
};

// With NEAREST, no refined texture coordinate lies near the edge of a texel, where rounding would decide.
Mesh displaced_mesh() {
  Mesh mesh = bent_mesh();
  const Vec2 texture[4] = {{0.06F, 0.11F}, {0.93F, 0.07F}, {0.87F, 1.33F}, {-0.41F, 0.79F}};
  const std::size_t places[] = {0, 1, 2, 2, 3, 0};
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].texture = texture[places[i]];
    // The other attribute has other texture coordinates.
    mesh[i].colour = {texture[places[i]][1] * 0.7F + 0.02F, texture[places[i]][0] * 0.8F - 0.31F, 9, 9};
  }
  return mesh;
}

void set_parameters(const Displacing& d) {
  const GLenum channels[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, static_cast<GLint>(channels[d.channel]));
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, d.scale);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, d.bias);
  if (d.has_attribute) gl.ARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, at_colour);
}

void set_sampling(const Displacing& d) {
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  const auto filter = static_cast<GLint>(d.is_linear ? GL_LINEAR : GL_NEAREST);
  const auto wrap = static_cast<GLint>(d.is_clamped ? GL_CLAMP_TO_EDGE : GL_REPEAT);
  GLuint sampler = 0;
  if (d.has_sampler) {
    gl.GenSamplers(1, &sampler);
    gl.BindSampler(unit, sampler);
  }
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    const bool is_filter = name == GL_TEXTURE_MIN_FILTER || name == GL_TEXTURE_MAG_FILTER;
    if (d.has_sampler)
      gl.SamplerParameteri(sampler, name, is_filter ? filter : wrap);
    else
      gl.TexParameteri(GL_TEXTURE_2D, name, is_filter ? filter : wrap);
  }
  if (d.has_mipmaps) {
    const std::vector<GLubyte> white(4 * size * size, 255);
    gl.TexImage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size / 2, size / 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    gl.TexImage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

reference::Surface undisplaced(const Displacing& d, const reference::Corners& corners, const Vec3& weights) {
  if (d.refinement == GL_CURVED_PN_ARK) return reference::curved_pn(corners, weights);
  if (d.refinement == GL_SCALAR_TAGGED_PN_ARK) return reference::scalar_tagged_pn(corners, weights);
  reference::Surface surface;
  for (std::size_t i = 0; i < 3; ++i) {
    surface.position = surface.position + static_cast<double>(weights[i]) * reference::vector_of(corners[i].position);
    surface.normal = surface.normal + static_cast<double>(weights[i]) * reference::vector_of(corners[i].normal);
  }
  return surface;
}

bool near_texel_edge(double coordinate) {
  const double texels = coordinate * size;
  return std::abs(texels - std::round(texels)) < 1e-4;
}

void expect_displaced(Test& t, const Displacing& d, const Mesh& mesh, const std::vector<SurfaceVertex>& vertices) {
  for (const SurfaceVertex& vertex : vertices) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    double s = 0;
    double v = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshVertex& corner = mesh[3 * triangle + i];
      s += static_cast<double>(vertex.weights[i]) * (d.has_attribute ? corner.colour[0] : corner.texture[0]);
      v += static_cast<double>(vertex.weights[i]) * (d.has_attribute ? corner.colour[1] : corner.texture[1]);
    }
    if (!d.is_linear && (near_texel_edge(s) || near_texel_edge(v))) continue;
    const reference::Surface surface = undisplaced(d, corners_of(mesh, triangle), vertex.weights);
    const double height = d.scale * sampled(s, v, d.channel, d.is_linear, d.is_clamped) + d.bias;
    const reference::Vector expected = surface.position + height * reference::direction(surface.normal);
    const double off = reference::length(reference::vector_of(vertex.position) - expected);
    // Filters have at least 8 bits between two texels. The specification gives no number; GPUs have 8.
    if (!t.expect(off < (d.is_linear ? std::abs(d.scale) / 128 : 1e-5),
                  "the displaced position is off by " + as_text(off)))
      return;
    t.expect_near(reference::length(reference::vector_of(vertex.normal)), reference::length(surface.normal), 1e-4,
                  "the displaced normal has the length of the refined one");
  }
}

void check_displacing(Test& t, const Displacing& d) {
  const GLuint program = surface_program(t);
  gl.UseProgram(program);
  bind_displacement_texture();
  set_sampling(d);
  set_parameters(d);
  const Mesh mesh = displaced_mesh();
  upload(mesh);
  refine_uniformly(d.depth, d.refinement);
  require_refinable(t, program);
  const auto vertices = capture_surface(t, mesh);
  t.require(vertices.size() == mesh.size() << (2 * d.depth), "the mesh is refined");
  expect_displaced(t, d, mesh, vertices);
}

std::vector<Displacing> displacings() {
  std::vector<Displacing> all = {
      {.leaf = "linear_inputs",
       .clauses = {"11.R.7b-1", "11.R.7b-2", "11.R.7b-10"},
       .plan = "With LINEAR_INPUTS_ARK.",
       .wrong = "The normal is not scaled to unit length."},
      {.leaf = "curved",
       .clauses = {"11.R.7b-1"},
       .plan = "With CURVED_PN_ARK.",
       .wrong = "The flat position or normal is displaced.",
       .refinement = GL_CURVED_PN_ARK},
      {.leaf = "tagged",
       .clauses = {"11.R.7b-1"},
       .plan = "With SCALAR_TAGGED_PN_ARK.",
       .wrong = "Not displaced.",
       .refinement = GL_SCALAR_TAGGED_PN_ARK},
      {.leaf = "scale_bias",
       .clauses = {"11.R.7b-1", "11.R.7b-2"},
       .plan = "With a scale of -0.3 and a bias of 0.2.",
       .wrong = "Scaled after adding the bias.",
       .scale = -0.3F,
       .bias = 0.2F},
      {.leaf = "filter_linear",
       .clauses = {"11.R.7b-2"},
       .plan = "With LINEAR filtering.",
       .wrong = "The nearest texel: steps.",
       .is_linear = true},
      {.leaf = "wrap_clamp",
       .clauses = {"11.R.7b-2"},
       .plan = "With CLAMP_TO_EDGE and coordinates beyond 0 and 1.",
       .wrong = "The coordinate is wrapped.",
       .is_clamped = true},
      {.leaf = "sampler",
       .clauses = {"11.R.7b-2"},
       .plan = "With a sampler object whose parameters differ from the texture's.",
       .wrong = "The texture's own parameters.",
       .is_linear = true,
       .is_clamped = true,
       .has_sampler = true},
      {.leaf = "level_0",
       .clauses = {"11.R.7b-2"},
       .plan = "Level 1 is white, and the filter uses mipmaps.",
       .wrong = "A coarser level.",
       .has_mipmaps = true},
      {.leaf = "coordinate_attribute",
       .clauses = {"11.R.7b-10"},
       .plan = "DISPLACEMENT_COORDINATE_ARK names another attribute.",
       .wrong = "The input with the name.",
       .has_attribute = true},
      {.leaf = "depth_0",
       .clauses = {"11.R.7b-9"},
       .plan = "At depth 0 the corners are displaced.",
       .wrong = "The draw is treated as one that needs no refinement.",
       .depth = 0},
      {.leaf = "scale_0",
       .clauses = {"11.R.7b-1"},
       .plan = "With a scale of 0, only the bias displaces.",
       .wrong = "A scale of 0 turns displacement off.",
       .scale = 0,
       .bias = 0.25F},
  };
  for (int channel = 1; channel < 4; ++channel)
    all.push_back({.leaf = channel == 1   ? "channel_green"
                           : channel == 2 ? "channel_blue"
                                          : "channel_alpha",
                   .clauses = {"11.R.7b-2"},
                   .plan = "With another channel.",
                   .wrong = "Red.",
                   .channel = channel});
  return all;
}

void expect_not_displaced(Test& t, const SurfaceNames& names, GLenum refinement) {
  gl.UseProgram(surface_program(t, names));
  bind_displacement_texture();
  const Mesh mesh = displaced_mesh();
  upload(mesh);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  refine_uniformly(2, refinement);
  Displacing d{};
  d.refinement = GL_LINEAR_INPUTS_ARK;
  d.scale = 0;
  const auto vertices = capture_surface(t, mesh);
  t.require(vertices.size() > mesh.size(), "the mesh is refined");
  for (const SurfaceVertex& vertex : vertices) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    const reference::Surface flat = undisplaced(d, corners_of(mesh, triangle), vertex.weights);
    if (!t.expect(reference::length(reference::vector_of(vertex.position) - flat.position) < 1e-6,
                  "nothing is displaced"))
      return;
  }
}

void check_names(Test& t, const char* name, bool is_coordinate) {
  if (!is_coordinate) return expect_not_displaced(t, {.texture = name}, GL_LINEAR_INPUTS_ARK);
  gl.UseProgram(surface_program(t, {.texture = name}));
  bind_displacement_texture();
  const Displacing d{};
  set_parameters(d);
  const Mesh mesh = displaced_mesh();
  upload(mesh);
  refine_uniformly(2);
  expect_displaced(t, d, mesh, capture_surface(t, mesh));
}

void check_texture_matrix(Test& t) {
  bind_displacement_texture();
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.4F);
  refine_uniformly(3);
  const auto picture = [](float scale) {
    for (const GLenum at : {GL_TEXTURE0, GL_TEXTURE0 + unit}) {
      gl.ActiveTexture(at);
      gl.MatrixMode(GL_TEXTURE);
      gl.LoadIdentity();
      gl.Scalef(scale, 2 - scale, 1);
    }
    gl.ActiveTexture(GL_TEXTURE0);
    clear_surface();
    gl.Begin(GL_TRIANGLES);
    for (const MeshVertex& vertex : one_triangle()) {
      gl.TexCoord2f(0.13F + vertex.position[0] * 0.57F, 0.29F + vertex.position[1] * 0.61F);
      gl.Normal3f(vertex.position[1], -vertex.position[0], 0.3F);
      gl.Vertex3f(vertex.position[0], vertex.position[1], 0);
    }
    gl.End();
    return read_picture(surface_size, surface_size);
  };
  const Picture expected = picture(1);
  t.expect_same_picture(picture(0.3F), expected, "with another texture matrix");
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
  t.expect(count_different(picture(1), expected, 0) > 100, "displacement shows in the picture");
}

}  // namespace

Cases displacement_cases() {
  Cases cases;
  for (const Displacing& d : displacings())
    cases.push_back({.name = std::string("ark.displacement.") + d.leaf,
                     .clauses = d.clauses,
                     .plan = "A texture of 4 x 4 texels displaces two bent triangles. " + std::string(d.plan),
                     .wrong = d.wrong,
                     .check = [d](Test& t) { check_displacing(t, d); }});
  for (const auto& [name, is_coordinate] : {std::pair<const char*, bool>{"TexCoord0", true},
                                            {"a_texture", true},
                                            {"inTex", true},
                                            {"UV", true},
                                            {"vertex_place", false},
                                            {"other", false}})
    cases.push_back(
        {.name = fmt::format("ark.displacement.names.{}{}", (is_coordinate ? "found_" : "none_"), cases.size()),
         .clauses = is_coordinate ? std::vector<std::string>{"11.R.7b-10"} : std::vector<std::string>{"11.R.7b-7"},
         .plan = std::string("The vec2 input is called ") + name + ".",
         .wrong = "Only one spelling is known; or any vec2 is taken.",
         .check = [name = std::string(name), is_coordinate = is_coordinate](Test& t) {
           check_names(t, name.c_str(), is_coordinate);
         }});
  cases.push_back({.name = "ark.displacement.outputs",
                   .clauses = {"11.R.7b-1"},
                   .plan = "With LINEAR_OUTPUTS_ARK nothing is displaced.",
                   .wrong = "The vertices are displaced.",
                   .check = [](Test& t) { expect_not_displaced(t, {}, GL_LINEAR_OUTPUTS_ARK); }});
  cases.push_back({.name = "ark.displacement.texture_matrix",
                   .clauses = {"11.R.7b-4"},
                   .plan = "With the fixed function, a texture matrix other than the identity changes nothing.",
                   .wrong = "T is transformed by the matrix of unit 0, or of the displacement's unit.",
                   .apis = compat_only,
                   .check = check_texture_matrix});
  return cases;
}

}  // namespace glark::conformance
