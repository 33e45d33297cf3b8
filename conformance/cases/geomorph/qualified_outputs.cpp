// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14) of outputs with every qualifier, alone, in arrays, structures and blocks: all that are neither flat
// nor integers move by (11.R.8). With LINEAR_OUTPUTS_ARK they are refined by section 11.R.6.
#include <fmt/core.h>
#include <cmath>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/support/geomorph.h"

namespace glark::conformance {
namespace {

struct Qualified {
  const char* leaf;
  const char* output;                  // declares it; its vec4 comes from `b`
  const char* assigned = "bend = b;";  // in the vertex stage
  const char* captured = "bend";
  const char* input = nullptr;  // of the fragment stage; null: `output`, with "in"
  const char* read = "bend";
  Apis apis = every_api;
  bool is_noperspective = false;
};

constexpr Qualified qualified_outputs[] = {
    {.leaf = "smooth", .output = "smooth out vec4 bend;", .input = "smooth in vec4 bend;"},
    {.leaf = "centroid", .output = "centroid out vec4 bend;", .input = "centroid in vec4 bend;"},
    {.leaf = "sample", .output = "sample out vec4 bend;", .input = "sample in vec4 bend;"},
    {.leaf = "smooth_centroid", .output = "smooth centroid out vec4 bend;", .input = "smooth centroid in vec4 bend;"},
    {.leaf = "invariant", .output = "invariant out vec4 bend;", .input = "in vec4 bend;"},
    {.leaf = "precise", .output = "precise out vec4 bend;", .input = "in vec4 bend;"},
    {.leaf = "highp", .output = "out highp vec4 bend;", .input = "in highp vec4 bend;"},
    {.leaf = "location",
     .output = "layout(location = 3) out vec4 bend;",
     .input = "layout(location = 3) in vec4 bend;"},
    {.leaf = "noperspective",
     .output = "noperspective out vec4 bend;",
     .input = "noperspective in vec4 bend;",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_centroid",
     .output = "noperspective centroid out vec4 bend;",
     .input = "noperspective centroid in vec4 bend;",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_sample",
     .output = "noperspective sample out vec4 bend;",
     .input = "noperspective sample in vec4 bend;",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_array",
     .output = "noperspective out vec4 bends[2];",
     .assigned = "bends[0] = vec4(0.0); bends[1] = b;",
     .captured = "bends[1]",
     .input = "noperspective in vec4 bends[2];",
     .read = "(bends[0] + bends[1])",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_matrix",
     .output = "noperspective out mat4 bends;",
     .assigned = "bends = mat4(b, b, b, b);",
     .captured = "bends",
     .input = "noperspective in mat4 bends;",
     .read = "bends[3]",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_structure",
     .output = "struct Bent { vec4 value; }; noperspective out Bent bent;",
     .assigned = "bent.value = b;",
     .captured = "bent.value",
     .input = "struct Bent { vec4 value; }; noperspective in Bent bent;",
     .read = "bent.value",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "noperspective_member",
     .output = "out Bent { vec4 other; noperspective vec4 value; } bent;",
     .assigned = "bent.other = vec4(1.0); bent.value = b;",
     .captured = "Bent.value",
     .input = "in Bent { vec4 other; noperspective vec4 value; } bent;",
     .read = "(bent.other * bent.value)",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "matrix",
     .output = "out mat2 bends;",
     .assigned = "bends = mat2(b.xy, b.zw);",
     .captured = "bends",
     .input = "in mat2 bends;",
     .read = "vec4(bends[0], bends[1])"},
    {.leaf = "array",
     .output = "out float bends[4];",
     .assigned = "for (int i = 0; i < 4; ++i) bends[i] = b[i];",
     .captured = "bends",
     .input = "in float bends[4];",
     .read = "vec4(bends[0], bends[1], bends[2], bends[3])"},
    {.leaf = "noperspective_floats",
     .output = "noperspective out float bends[4];",
     .assigned = "for (int i = 0; i < 4; ++i) bends[i] = b[i];",
     .captured = "bends",
     .input = "noperspective in float bends[4];",
     .read = "vec4(bends[0], bends[1], bends[2], bends[3])",
     .apis = desktop_apis,
     .is_noperspective = true},
    {.leaf = "clip_distance",
     .output = "out float gl_ClipDistance[4];",
     .assigned = "for (int i = 0; i < 4; ++i) gl_ClipDistance[i] = b[i];",
     .captured = "gl_ClipDistance",
     .input = "",
     .read = "vec4(1.0)",
     .apis = desktop_apis},
    {.leaf = "centroid_member",
     .output = "out Bent { vec4 other; centroid vec4 value; } bent;",
     .assigned = "bent.other = vec4(1.0); bent.value = b;",
     .captured = "Bent.value",
     .input = "in Bent { vec4 other; centroid vec4 value; } bent;",
     .read = "(bent.other * bent.value)"},
};

// The outputs are those of morph_program(), but for the declaration of `bend`. gl_Position has the w that `w` says.
GLuint qualified_program(Test& t, const Qualified& kind, const std::string& w, const std::string& b) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 4) in vec2 place;\n"
                    "layout(location = 2) in vec3 weights; out vec2 place_out;\n" +
                    std::string(kind.output) +
                    "\nvoid main() { float x = place.x; float y = place.y; place_out = place;\n"
                    "  vec4 b = " +
                    b + "; " + kind.assigned + "\n  gl_Position = position * " + w + "; }\n",
          .fragment = std::string(kind.input) + "\nout vec4 pixel; void main() { pixel = abs(" + kind.read + "); }",
          .captured = {"gl_Position", "place_out", kind.captured}});
}

constexpr char polynomials[] = "vec4(x * x - 0.25 * y * y, x * y, 0.5 * y * y + x, x * x + x * y)";

using EdgeDepths = std::array<double, 3>;

// A captured matrix has four times the vertex.
std::vector<MorphVertex> capture_qualified(Test& t, const Qualified& kind, const Mesh& mesh) {
  if (std::string(kind.output).find("mat4") == std::string::npos) return capture_morph(t, mesh);
  struct Wide {
    MorphVertex vertex;
    std::array<float, 12> more;
  };
  std::vector<MorphVertex> vertices;
  const auto draw = [&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); };
  for (const Wide& wide : capture_as<Wide>(t, 100000, draw)) vertices.push_back(wide.vertex);
  return vertices;
}

void check_morphed(Test& t, const Qualified& kind) {
  const GLuint program = qualified_program(t, kind, "1.0", polynomials);
  gl.UseProgram(program);
  morph_by_tags(4);
  require_refinable(t, program);
  for (const EdgeDepths& depths : {EdgeDepths{1.5, 1.25, 0.75}, {2.5, 2.75, 2.25}, {0.5, 0.25, 0.5}, {2, 1.5, 2}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    upload(mesh);
    for (int again = 0; again < 2; ++again)
      expect_edges(t, capture_qualified(t, kind, mesh), mesh, depths,
                   fmt::format("depths {} {} {}", depths[0], depths[1], depths[2]));
  }
  t.expect_no_error("the draws");
}

// Corners have w of 1, 2 and 1/2. (11.R.8) holds for noperspective outputs, too: their values come from the vertex
// stage, and only outputs that are refined depend on w.
void check_morphed_beside_w(Test& t, const Qualified& kind) {
  const GLuint program = qualified_program(t, kind, "dot(weights, vec3(1.0, 2.0, 0.5))", polynomials);
  gl.UseProgram(program);
  morph_by_tags(4);
  require_refinable(t, program);
  const EdgeDepths depths = {1.5, 1.25, 0.75};
  const Mesh mesh = morph_triangle(tags_for(depths));
  upload(mesh);
  expect_edges(t, capture_qualified(t, kind, mesh), mesh, depths, "corners of several w");
}

// With LINEAR_OUTPUTS_ARK nothing moves: each output is linear in the weights, or in those of the window.
void check_refined_outputs(Test& t, const Qualified& kind) {
  const GLuint program = qualified_program(t, kind, "dot(weights, vec3(1.0, 2.0, 0.5))", polynomials);
  gl.UseProgram(program);
  morph_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
  require_refinable(t, program);
  const std::array<double, 3> w = {1, 2, 0.5};
  for (const EdgeDepths& depths : {EdgeDepths{1.5, 1.25, 0.75}, {2.5, 2.75, 2.25}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    upload(mesh);
    const auto vertices = capture_qualified(t, kind, mesh);
    t.require(vertices.size() > 3, "the triangle is refined");
    for (const MorphVertex& vertex : vertices) {
      // The place is refined by (11.R.1), so the weights follow from it: places are (0, 0), (3, 1) and (1, 4).
      const double v = (3 * static_cast<double>(vertex.place[1]) - static_cast<double>(vertex.place[0])) / 11;
      const double u = (static_cast<double>(vertex.place[0]) - v) / 3;
      std::array<double, 3> weights = {1 - u - v, u, v};
      if (kind.is_noperspective) {
        const double sum = weights[0] * w[0] + weights[1] * w[1] + weights[2] * w[2];
        for (std::size_t i = 0; i < 3; ++i) weights[i] *= w[i] / sum;
      }
      for (std::size_t i = 0; i < 4; ++i) {
        double expected = 0;
        for (std::size_t k = 0; k < 3; ++k) expected += weights[k] * static_cast<double>(bend_of(mesh[k].texture)[i]);
        if (!t.expect_near(vertex.bend[i], expected, 2e-5, "component " + as_text(i) + " of the output")) return;
      }
    }
  }
}

// Outputs that do not move: the value of the provoking corner.
constexpr Qualified flat_outputs[] = {
    {.leaf = "flat", .output = "flat out vec4 bend;", .input = "flat in vec4 bend;"},
    {.leaf = "flat_array",
     .output = "flat out vec4 bends[2];",
     .assigned = "bends[0] = b; bends[1] = b;",
     .captured = "bends[1]",
     .input = "flat in vec4 bends[2];",
     .read = "bends[1]"},
    {.leaf = "flat_member",
     .output = "out Bent { vec4 other; flat vec4 value; } bent;",
     .assigned = "bent.other = b; bent.value = b;",
     .captured = "Bent.value",
     .input = "in Bent { vec4 other; flat vec4 value; } bent;",
     .read = "bent.value"},
};

void check_flat(Test& t, const Qualified& kind, GLenum refinement) {
  const GLuint program = qualified_program(t, kind, "1.0", polynomials);
  gl.UseProgram(program);
  morph_by_tags(4, refinement);
  require_refinable(t, program);
  const Mesh mesh = morph_triangle({1.5F, 0.75F, 2.25F});
  upload(mesh);
  const auto vertices = capture_morph(t, mesh);
  t.require(vertices.size() > 3, "the triangle is refined");
  for (const MorphVertex& vertex : vertices)
    if (!t.expect(vertex.bend == bend_of(mesh[2].texture), "the value of the provoking corner")) return;
}

}  // namespace

Cases qualified_outputs_cases() {
  Cases cases;
  const auto add = [&](const Qualified& kind, const std::string& name, std::vector<std::string> clauses,
                       const char* plan, const char* wrong, void (*check)(Test&, const Qualified&)) {
    cases.push_back({.name = "ark.geomorph.qualified." + name + "." + kind.leaf,
                     .clauses = std::move(clauses),
                     .plan = plan,
                     .wrong = wrong,
                     .apis = kind.apis,
                     .check = [check, &kind](Test& t) { check(t, kind); }});
  };
  for (const Qualified& kind : qualified_outputs) {
    add(kind, "moved", {"11.R.14-10", "11.R.14-11", "11.R.14-14"},
        "Compare this output with (11.R.8) on edges of several depths, by bits.",
        "An output with this qualifier does not move, or as another one.", check_morphed);
    add(kind, "beside_w", {"11.R.14-10", "11.R.14-14"}, "The same with corners of several w.",
        "The value is divided by w, or refined.", check_morphed_beside_w);
    add(kind, "outputs", {"11.R.14-14", "11.R.6-8", "11.R.6-11"}, "LINEAR_OUTPUTS_ARK with depths between integers.",
        "The output is moved by (11.R.8) although outputs are refined.", check_refined_outputs);
  }
  for (const Qualified& kind : flat_outputs) {
    add(kind, "still", {"11.R.14-14", "11.R.6-12"}, "Depths between integers; the output is flat.",
        "Flat outputs are blended.", [](Test& t, const Qualified& each) { check_flat(t, each, GL_LINEAR_INPUTS_ARK); });
    add(kind, "still_outputs", {"11.R.14-14", "11.R.6-10"}, "The same with LINEAR_OUTPUTS_ARK.",
        "Flat outputs are blended.",
        [](Test& t, const Qualified& each) { check_flat(t, each, GL_LINEAR_OUTPUTS_ARK); });
  }
  return cases;
}

}  // namespace glark::conformance
