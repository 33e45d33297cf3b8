// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which input CURVED_PN_ARK takes for the position, and which for the normal (11.R.7, issue 16).
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

// `position` at location 0 and `decoy` at location 7 hold the same values: only the one that is taken for the position
// is curved.
struct NameCase {
  std::string leaf;
  std::string first;         // type and name of the input at location 0
  std::string second;        // of the decoy at location 7, declared after the first
  std::string normal;        // type and name of the normal
  std::string other_normal;  // of a decoy at location 5; may be empty
  bool is_first_curved;
  bool is_second_curved;
  GLuint normal_location = 8;  // or at_normal, before the second input
};

const NameCase name_cases[] = {
    {"position.position", "vec4 position", "vec4 decoy", "vec3 normal", "", true, false},
    {"position.part_of_name", "vec4 a_Position_os", "vec4 decoy", "vec3 normal", "", true, false},
    {"position.upper_case", "vec4 POSITION", "vec4 decoy", "vec3 normal", "", true, false},
    {"position.vec3", "vec3 inPosition", "vec4 decoy", "vec3 normal", "", true, false},
    {"position.vertex", "vec4 decoy", "vec4 aVertex", "vec3 normal", "", false, true},
    {"position.pos", "vec4 decoy", "vec4 in_pos", "vec3 normal", "", false, true},
    {"position.vert", "vec4 decoy", "vec4 vert", "vec3 normal", "", false, true},
    {"position.coord", "vec4 decoy", "vec3 coord3d", "vec3 normal", "", false, true},
    {"position.location_0", "vec4 decoy", "vec4 other", "vec3 normal", "", true, false},
    {"position.order.position_before_vertex", "vec4 vertex_thing", "vec4 position", "vec3 normal", "", false, true},
    {"position.order.vertex_before_pos", "vec4 pos", "vec4 Vertex", "vec3 normal", "", false, true},
    {"position.order.pos_before_vert", "vec4 vert", "vec4 Pos", "vec3 normal", "", false, true},
    {"position.order.vert_before_coord", "vec4 coord", "vec4 myvert", "vec3 normal", "", false, true},
    {"position.order.coord_before_location_0", "vec4 thing", "vec4 Coord", "vec3 normal", "", false, true},
    {"position.order.first_of_two", "vec4 position_one", "vec4 position_two", "vec3 normal", "", true, false},
    {"position.type.vec2_does_not_count", "vec2 position", "vec4 vertex", "vec3 normal", "", false, true},
    {"position.type.integer_does_not_count", "ivec3 position", "vec4 vertex", "vec3 normal", "", false, true},
    {"normal.normal", "vec4 position", "vec4 decoy", "vec3 a_NORMAL", "", true, false},
    {"normal.nrm", "vec4 position", "vec4 decoy", "vec3 inNrm", "", true, false},
    {"normal.norm", "vec4 position", "vec4 decoy", "vec3 vnorm", "", true, false},
    {"normal.vec4", "vec4 position", "vec4 decoy", "vec4 normal", "", true, false},
    {"normal.order.normal_before_nrm", "vec4 position", "vec4 decoy", "vec3 Normal", "vec3 nrm", true, false},
    {"normal.order.nrm_before_norm", "vec4 position", "vec4 decoy", "vec3 nrm", "vec3 norm", true, false},
    {"position.texture_coordinate_is_none", "vec3 texcoord", "vec4 my_coord", "vec3 normal", "", false, true},
    {"position.texture_position_is_none", "vec3 texturePosition", "vec4 pos", "vec3 normal", "", false, true},
    {"normal.normalize_does_not_count", "vec4 position", "vec4 decoy", "vec3 norm", "vec3 normalize_me", true, false},
    {"normal.normalised_alone", "vec4 position", "vec4 decoy", "vec3 is_normalised", "", false, false},
    {"normal.none", "vec4 position", "vec4 decoy", "vec3 n", "", false, false},
};

// The words of each role, the preferred ones first. Some contain others: "vertex" and "vert".
const std::vector<std::string> position_words = {"position", "vertex", "pos", "vert", "coord"};
const std::vector<std::string> normal_words = {"normal", "nrm", "norm"};

// Names with this word, in the manners of several programs.
std::string named_with(const std::string& word, std::size_t turn) {
  std::string changed = word;
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  switch (turn % 5) {
    case 0: return word;
    case 1: return "a_" + word;
    case 2: return word + "_0";
    case 3: changed[0] = upper(changed[0]); return "in" + changed;
    default: std::transform(changed.begin(), changed.end(), changed.begin(), upper); return changed + "3D";
  }
}

std::string input_with(const std::string& word, std::size_t turn) {
  return (turn % 2 == 0 ? "vec4 " : "vec3 ") + named_with(word, turn);
}

// Each pair of words, the preferred one behind the other and before it. Then names that have two words: the preferred
// one counts, wherever it stands in the name.
void add_position_pairs(std::vector<NameCase>& all) {
  std::size_t turn = 0;
  for (std::size_t i = 0; i < position_words.size(); ++i)
    for (std::size_t j = i + 1; j < position_words.size(); ++j) {
      const std::string& better = position_words[i];
      const std::string& worse = position_words[j];
      const std::string leaf = "position.pair." + better + "." + worse;
      all.push_back({leaf, input_with(worse, turn), input_with(better, turn + 1), "vec3 normal", "", false, true});
      all.push_back(
          {leaf + ".first", input_with(better, turn + 2), input_with(worse, turn + 3), "vec3 normal", "", true, false});
      for (std::size_t k = 0; k < position_words.size(); ++k) {
        if (k == i || k == j) continue;
        const std::string both = turn % 2 == 0 ? worse + "_" + better : better + "_" + worse;
        all.push_back({leaf + ".with." + position_words[k], "vec4 " + position_words[k] + "_one", "vec4 " + both,
                       "vec3 normal", "", k < i, i < k});
        ++turn;
      }
      // A normal whose name has the lesser word, too, comes before the position.
      all.push_back({leaf + ".in_normal", "vec4 decoy", input_with(better, turn), "vec3 " + worse + "_normal", "",
                     false, true, at_normal});
      ++turn;
    }
  // A normal with the same word comes behind the position.
  for (const std::string& word : position_words)
    for (const std::string& normal : normal_words)
      all.push_back({"position." + word + ".before." + word + "_" + normal, input_with(word, turn++), "vec4 decoy",
                     "vec3 " + word + "_" + normal, "", true, false});
}

void add_normal_pairs(std::vector<NameCase>& all) {
  std::size_t turn = 0;
  for (std::size_t i = 0; i < normal_words.size(); ++i)
    for (std::size_t j = i + 1; j < normal_words.size(); ++j) {
      const std::string& better = normal_words[i];
      const std::string& worse = normal_words[j];
      const std::string leaf = "normal.pair." + better + "." + worse;
      for (const std::size_t step : {0U, 1U, 2U})
        all.push_back({leaf + "." + std::to_string(step), "vec4 position", "vec4 decoy",
                       "vec3 " + named_with(better, turn + step), "vec3 " + named_with(worse, turn + 2 * step), true,
                       false});
      for (std::size_t k = 0; k < normal_words.size(); ++k) {
        if (k <= i || k == j) continue;
        all.push_back({leaf + ".with." + normal_words[k], "vec4 position", "vec4 decoy", "vec3 " + worse + "_" + better,
                       "vec3 " + normal_words[k] + "_one", true, false});
      }
      ++turn;
    }
}

std::vector<NameCase> all_name_cases() {
  std::vector<NameCase> all(std::begin(name_cases), std::end(name_cases));
  add_position_pairs(all);
  add_normal_pairs(all);
  return all;
}

struct NamedVertex {
  Vec4 first;
  Vec4 second;
  Vec3 weights;
  float triangle;
};

std::string name_in(const std::string& declaration) { return declaration.substr(declaration.find(' ') + 1); }

// An input of any type, as a vec4.
std::string as_vec4(const std::string& declaration) {
  std::string name = name_in(declaration);
  const std::string type = declaration.substr(0, declaration.find(' '));
  if (type == "vec4") return name;
  if (type == "vec3") return "vec4(" + name + ", 1.0)";
  if (type == "ivec3") return "vec4(vec3(" + name + "), 1.0)";
  return "vec4(" + name + ", 0.0, 1.0)";
}

GLuint named_program(Test& t, const NameCase& names) {
  const std::string other = names.other_normal;
  std::string text = "layout(location = 0) in " + names.first + ";\nlayout(location = 7) in " + names.second + ";\n";
  // The decoy is declared first and has the lower location, so only the order of preference can decide.
  if (!other.empty()) text += "layout(location = 5) in " + other + ";\n";
  text += "layout(location = " + std::to_string(names.normal_location) + ") in " + names.normal +
          ";\nlayout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
          "out vec4 first_out; out vec4 second_out; out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
          "void main() { first_out = " +
          as_vec4(names.first) + "; second_out = " + as_vec4(names.second) +
          ";\n  weights_out = weights; triangle_out = triangle; colour = vec4(" + name_in(names.normal) + ".xyz, 1.0)" +
          (other.empty() ? "" : " + vec4(" + name_in(other) + ", 0.0)") +
          ";\n  gl_Position = first_out + second_out; }\n";
  return build_program(t, {.vertex = text, .captured = {"first_out", "second_out", "weights_out", "triangle_out"}});
}

void extra_attribute(GLuint location, GLint components, std::size_t offset) {
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offset));
  gl.EnableVertexAttribArray(location);
}

bool is_near(const Vec4& a, const reference::Vector& b) {
  return std::abs(a[0] - b.x) < 2e-6 && std::abs(a[1] - b.y) < 2e-6 && std::abs(a[2] - b.z) < 2e-6;
}

void check_names(Test& t, const NameCase& names) {
  gl.UseProgram(named_program(t, names));
  const Mesh mesh = bent_mesh();
  upload(mesh);
  // The input that must not be taken for the normal is the colour: white for all.
  extra_attribute(5, 3, offsetof(MeshVertex, colour));
  extra_attribute(7, 4, offsetof(MeshVertex, position));
  extra_attribute(8, 3, offsetof(MeshVertex, normal));
  if (names.first.find("ivec") == 0) {
    gl.DisableVertexAttribArray(0);
    gl.VertexAttribI4i(0, 1, 2, 3, 4);
  }
  refine_uniformly(3, GL_CURVED_PN_ARK);
  const auto vertices = capture_as<NamedVertex>(t, 4000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); });
  t.require(vertices.size() == 2U * 64 * 3, "the mesh is refined");
  const bool is_first_checked =
      names.first.find("vec2") == std::string::npos && names.first.find("ivec") == std::string::npos;
  for (const NamedVertex& vertex : vertices) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    const reference::Corners corners = corners_of(mesh, triangle);
    const reference::Vector curved = reference::curved_pn(corners, vertex.weights).position;
    reference::Vector linear;
    for (std::size_t i = 0; i < 3; ++i)
      linear = linear + static_cast<double>(vertex.weights[i]) * reference::vector_of(corners[i].position);
    if (is_first_checked && !t.expect(is_near(vertex.first, names.is_first_curved ? curved : linear),
                                      names.first + (names.is_first_curved ? " is curved" : " is not curved")))
      return;
    if (!t.expect(is_near(vertex.second, names.is_second_curved ? curved : linear),
                  names.second + (names.is_second_curved ? " is curved" : " is not curved")))
      return;
  }
}

Case name_case(const NameCase& names) {
  const bool is_normal = names.leaf.starts_with("normal");
  return {
      .name = "ark.pn.names." + names.leaf,
      .clauses = is_normal ? std::vector<std::string>{"11.R.7-23"} : std::vector<std::string>{"11.R.7-24", "issues-38"},
      .plan = "A program with the inputs " + names.first + ", " + names.second + ", " + names.normal +
              (names.other_normal.empty() ? "" : " and " + names.other_normal) +
              " where the first two have the same values: which of them is curved?",
      .wrong = "Only the usual name is known; case matters; the first candidate wins over the order of preference.",
      .check = [names](Test& t) { check_names(t, names); }};
}

// Fixed-function names come before all others.
void check_built_in(Test& t) {
  const char* const text =
      "attribute vec4 position; attribute vec3 normal; attribute vec3 weights; attribute float triangle;\n"
      "varying vec4 first_out; varying vec4 second_out; varying vec3 weights_out; varying float triangle_out;\n"
      "void main() { first_out = gl_Vertex; second_out = position; weights_out = weights; triangle_out = triangle;\n"
      "  gl_FrontColor = vec4(gl_Normal + normal, 1.0); gl_Position = gl_Vertex; }\n";
  std::string log;
  const GLuint program = try_program({.vertex = std::string("#version 120\n") + text,
                                      .fragment = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n",
                                      .captured = {"first_out", "second_out", "weights_out", "triangle_out"}},
                                     log);
  if (program == 0) t.internal_error(log);
  for (const auto& [location, name] :
       {std::pair<GLuint, const char*>{7, "position"}, {8, "normal"}, {5, "weights"}, {6, "triangle"}})
    gl.BindAttribLocation(program, location, name);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  const Mesh mesh = bent_mesh();
  upload(mesh);
  for (GLuint i = 1; i < 5; ++i) gl.DisableVertexAttribArray(i);
  extra_attribute(5, 3, offsetof(MeshVertex, weights));
  extra_attribute(7, 4, offsetof(MeshVertex, position));
  extra_attribute(8, 3, offsetof(MeshVertex, colour));
  gl.DisableVertexAttribArray(0);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), nullptr);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, normal)));
  gl.EnableClientState(GL_NORMAL_ARRAY);
  refine_uniformly(3, GL_CURVED_PN_ARK);
  const auto vertices = capture_as<NamedVertex>(t, 4000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); });
  t.require(vertices.size() == 2U * 64 * 3, "the mesh is refined");
  for (const NamedVertex& vertex : vertices) {
    const reference::Corners corners = corners_of(mesh, static_cast<std::size_t>(std::lround(vertex.triangle)));
    if (!t.expect(is_near(vertex.first, reference::curved_pn(corners, vertex.weights).position), "gl_Vertex is curved"))
      return;
    const bool is_corner = vertex.weights[0] == 1 || vertex.weights[1] == 1 || vertex.weights[2] == 1;
    const bool is_inside = vertex.weights[0] * vertex.weights[1] * vertex.weights[2] > 0;
    if (!is_corner && is_inside) t.expect(vertex.first != vertex.second, "position is not curved");
  }
}

}  // namespace

Cases pn_input_names_cases() {
  Cases cases;
  for (const NameCase& names : all_name_cases()) cases.push_back(name_case(names));
  cases.push_back({.name = "ark.pn.names.built_in",
                   .clauses = {"11.R.7-3", "11.R.7-23"},
                   .plan = "A vertex stage that reads gl_Vertex, gl_Normal, and inputs named position and normal.",
                   .wrong = "The named input comes before the built-in one.",
                   .apis = compat_only,
                   .check = check_built_in});
  return cases;
}

}  // namespace glark::conformance
