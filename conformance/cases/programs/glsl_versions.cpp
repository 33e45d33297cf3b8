// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One scene in every version of the shading languages.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

struct Version {
  int number;
  const char* profile;
  Api api;
  bool has_in_out;
};

std::vector<Version> versions() {
  std::vector<Version> all;
  for (const int number : {110, 120}) all.push_back({number, "", Api::gl_compat, false});
  for (const int number : {130, 140}) all.push_back({number, "", Api::gl_compat, true});
  for (const int number : {150, 330, 400, 410, 420, 430, 440, 450, 460}) {
    all.push_back({number, " compatibility", Api::gl_compat, true});
    all.push_back({number, " core", Api::gl_core, true});
  }
  all.push_back({140, "", Api::gl_core, true});
  all.push_back({100, "", Api::gles, false});
  for (const int number : {300, 310, 320}) all.push_back({number, " es", Api::gles, true});
  return all;
}

// `statements` are the last ones of the vertex shader.
GLuint version_program(Test& t, const Version& version, const std::string& statements = {}) {
  const std::string head = fmt::format("#version {}{}\n{}", version.number, version.profile,
                                       (version.api == Api::gles ? "precision highp float;\n" : ""));
  const std::string in = version.has_in_out ? "in" : "attribute";
  const std::string out = version.has_in_out ? "out" : "varying";
  Sources sources;
  sources.vertex =
      head + in + " vec4 position; " + in + " vec3 normal; " + in + " vec3 weights; " + in + " float triangle; " + in +
      " vec2 texcoord;\nuniform vec4 tint;\n" + out + " vec3 normal_out; " + out + " vec3 weights_out; " + out +
      " float triangle_out; " + out + " vec2 texture_out; " + out +
      " vec4 colour;\nvoid main() { gl_Position = position; normal_out = normal; weights_out = weights;\n"
      "  triangle_out = triangle; texture_out = texcoord;\n"
      "  colour = tint * vec4(weights.x * weights.x, weights.y * weights.y, weights.z * weights.z, 1.0);\n" +
      statements + "}\n";
  sources.fragment = head + (version.has_in_out ? "in vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n"
                                                : "varying vec4 colour; void main() { gl_FragColor = colour; }\n");
  sources.captured = {"gl_Position", "normal_out", "weights_out", "triangle_out", "texture_out"};
  std::string log;
  const GLuint program = try_program(sources, log);
  if (program == 0) t.not_supported("this version does not build here: " + log);
  const std::pair<GLuint, const char*> locations[] = {{at_position, "position"},
                                                      {at_normal, "normal"},
                                                      {at_weights, "weights"},
                                                      {at_extra, "triangle"},
                                                      {at_texture, "texcoord"}};
  for (const auto& [location, name] : locations) gl.BindAttribLocation(program, location, name);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  gl.Uniform4f(gl.GetUniformLocation(program, "tint"), 1, 0.75F, 0.5F, 1);
  return program;
}

Picture picture_of(GLsizei count) {
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, count);
  return read_picture(surface_size, surface_size);
}

void check_outputs(Test& t, const Version& version) {
  const GLuint program = version_program(t, version);
  upload(one_triangle({4, 1, 2}));
  const Picture expected = picture_of(3);
  refine_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
  require_refinable(t, program);
  t.expect_same_picture(picture_of(3), expected, "refined outputs give the unrefined picture", 2, 16);
  t.expect(capture_surface(t, one_triangle()).size() > 3, "the triangle is refined");
}

void check_inputs(Test& t, const Version& version) {
  version_program(t, version);
  // The square of a linear weight is not linear, so a finer mesh shows.
  const Mesh mesh = one_triangle();
  Mesh finer;
  constexpr int n = 8;
  const auto at = [&](int i, int j) {
    const Vec3 w = {1 - static_cast<float>(i + j) / n, static_cast<float>(i) / n, static_cast<float>(j) / n};
    MeshVertex vertex;
    for (std::size_t k = 0; k < 4; ++k)
      vertex.position[k] = reference::refined(w, mesh[0].position[k], mesh[1].position[k], mesh[2].position[k]);
    vertex.weights = w;
    finer.push_back(vertex);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      at(i, j), at(i + 1, j), at(i, j + 1);
      if (i + j + 1 < n) at(i + 1, j), at(i + 1, j + 1), at(i, j + 1);
    }
  upload(finer);
  const Picture expected = picture_of(static_cast<GLsizei>(finer.size()));
  upload(mesh);
  refine_uniformly(3);
  t.expect_same_picture(picture_of(3), expected, "refined inputs give the picture of 64 triangles", 2, 16);
}

void check_curved(Test& t, const Version& version) {
  version_program(t, version);
  const Mesh mesh = bent_mesh();
  upload(mesh);
  refine_uniformly(2, GL_CURVED_PN_ARK);
  expect_surface(t, capture_surface(t, mesh), mesh, {}, reference::curved_pn);
}

// Later versions reserve these words. An implementation may use them in its additions, by an extension.
void check_later_words(Test& t, const Version& version) {
  version_program(t, version,
                  "  float precise = 0.5; float sample = 2.0; float patch = 1.0; float buffer = 1.0;\n"
                  "  colour *= precise * sample * patch * buffer;\n");
  const Mesh mesh = bent_mesh();
  upload(mesh);
  const Picture plain = picture_of(6);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  t.expect_same_picture(picture_of(6), plain, "refined outputs give the unrefined picture", 2, 16);
  refine_uniformly(2, GL_CURVED_PN_ARK);
  expect_surface(t, capture_surface(t, mesh), mesh, {}, reference::curved_pn);
}

Case version_case(const Version& version, const char* leaf, std::vector<std::string> clauses,
                  void (*check)(Test&, const Version&)) {
  std::string name = fmt::format("ark.glsl.{}_{}.{}", name_of(version.api), version.number, leaf);
  for (char& c : name) c = c == '-' ? '_' : c;
  return {.name = name,
          .clauses = std::move(clauses),
          .plan = "A vertex shader of this version: " + std::string(leaf) + ".",
          .wrong = "The implementation's additions do not suit this version: the shader is drawn unrefined.",
          .apis = {version.api},
          .is_optional = true,
          .check = [version, check](Test& t) { check(t, version); }};
}

}  // namespace

Cases glsl_versions_cases() {
  Cases cases;
  for (const Version& version : versions()) {
    cases.push_back(version_case(version, "outputs", {"11.R.6-8", "11.R.6-14"}, check_outputs));
    cases.push_back(version_case(version, "inputs", {"11.R.6-4", "11.R.10-1"}, check_inputs));
    cases.push_back(version_case(version, "curved", {"11.R.7-1"}, check_curved));
    if (version.api != Api::gles && version.number < 400)
      cases.push_back(version_case(version, "later_words", {"11.R.7-1", "11.R.6-8"}, check_later_words));
  }
  return cases;
}

}  // namespace glark::conformance
