// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which input is the texture coordinate of displacement (11.R.7b), where several names have one of its words.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr GLuint at_later = 8;
constexpr float height = 0.5F;

// The preferred words first. "texcoord" and "texture" contain "tex".
const std::vector<std::string> coordinate_words = {"texcoord", "texture", "tex", "uv"};

// The names of two inputs. The first holds coordinates of a place where the height map is 0, the later one of a place where it
// is not: the picture shows which of them is taken for the texture coordinates.
struct CoordinateNames {
  std::string leaf;
  std::string first;
  std::string later;
  bool is_later_taken;
};

std::string coordinate_with(const std::string& word, std::size_t turn) {
  const std::string types[] = {"vec2 ", "vec3 ", "vec4 "};
  const std::string names[] = {"my_" + word, word + "_0", "A_" + word + "1"};
  return types[turn % 3] + names[turn / 3 % 3];
}

std::vector<CoordinateNames> coordinate_names() {
  std::vector<CoordinateNames> all;
  std::size_t turn = 0;
  for (std::size_t i = 0; i < coordinate_words.size(); ++i)
    for (std::size_t j = i + 1; j < coordinate_words.size(); ++j) {
      const std::string& better = coordinate_words[i];
      const std::string& worse = coordinate_words[j];
      const std::string leaf = better + "." + worse;
      all.push_back({leaf, coordinate_with(worse, turn), coordinate_with(better, turn + 4), true});
      all.push_back({leaf + ".first", coordinate_with(better, turn + 1), coordinate_with(worse, turn + 5), false});
      all.push_back({leaf + ".both", "vec2 " + worse + "_one", "vec2 " + worse + "_" + better, true});
      ++turn;
    }
  for (const std::string& word : coordinate_words) {
    all.push_back({word + ".twice", "vec2 " + word + "_one", "vec2 " + word + "_two", false});
    all.push_back({word + ".not_vertex", "vec2 vertex_data", "vec2 my_" + word, true});
    all.push_back({word + ".not_upper_vertex", "vec4 aVertexData", "vec2 " + word + "_0", true});
    all.push_back({word + ".not_float", "float " + word + "_one", "vec2 " + word + "_two", true});
    all.push_back({word + ".not_integer", "ivec2 " + word + "_one", "vec2 " + word + "_two", true});
  }
  all.push_back({"tex.behind_vertex", "vec2 my_uv", "vec2 vertex_tex", true});
  all.push_back({"tex.in_vertex_texcoord", "vec2 my_texture", "vec2 vertexTexCoord", true});
  return all;
}

std::string name_of_input(const std::string& declaration) { return declaration.substr(declaration.find(' ') + 1); }

// The first component of an input of any type.
std::string component_of(const std::string& declaration) {
  const std::string name = name_of_input(declaration);
  return "float(" + name + (declaration.starts_with("float") ? ")" : ".x)");
}

struct HeightVertex {
  Vec4 position;
};

void check_coordinate(Test& t, const CoordinateNames& names) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 4) in " +
                    names.first + ";\nlayout(location = 8) in " + names.later +
                    ";\nout vec4 colour;\n"
                    "void main() { colour = vec4(normal, " +
                    component_of(names.first) + " + " + component_of(names.later) + ");\n  gl_Position = position; }\n",
          .captured = {"gl_Position"}}));
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh) {
    vertex.texture = {0.25F, 0.25F};
    vertex.colour = {0.75F, 0.75F, 0, 1};
  }
  upload(mesh, false);
  gl.VertexAttribPointer(at_later, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offsetof(MeshVertex, colour)));
  gl.EnableVertexAttribArray(at_later);
  if (names.first.starts_with("ivec")) {
    gl.DisableVertexAttribArray(at_texture);
    gl.VertexAttribI4i(at_texture, 0, 0, 0, 1);
  }
  std::vector<GLubyte> heights(16, 0);
  for (std::size_t i = 12; i < 16; ++i) heights[i] = 255;  // the texel above and to the right
  bind_nearest_texture(3, 2, heights);
  refine_uniformly(2);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 3);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, height);
  const auto vertices = capture_as<HeightVertex>(t, 400, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.require(vertices.size() == std::size_t{16} * 3, "the triangle is refined");
  for (const HeightVertex& vertex : vertices)
    if (!t.expect_near(vertex.position[2], names.is_later_taken ? height : 0, 1e-5,
                       (names.is_later_taken ? names.later : names.first) + " is the coordinate"))
      return;
}

}  // namespace

Cases coordinate_names_cases() {
  Cases cases;
  for (const CoordinateNames& names : coordinate_names())
    cases.push_back({.name = "ark.displacement.names." + names.leaf,
                     .clauses = {"11.R.7b-10"},
                     .plan = "A program with the inputs " + names.first + " and " + names.later +
                             ", which find different heights: which of them was taken?",
                     .wrong = "The first of both, or one whose word is less preferred.",
                     .check = [names](Test& t) { check_coordinate(t, names); }});
  return cases;
}

}  // namespace glark::conformance
