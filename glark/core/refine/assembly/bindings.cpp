// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace glark::refine::assembly {
namespace {

// A row of a table: a path without its first part, and its GLSL. "[]" takes an index, which replaces "#".
struct Row {
  std::string_view path;
  std::string_view glsl;
  int count = 1;  // the index is below it
};

constexpr Row attributes[] = {
    {"position", "gl_Vertex"},
    {"normal", "vec4(gl_Normal, 1.0)"},
    {"color", "gl_Color"},
    {"color.primary", "gl_Color"},
    {"color.secondary", "gl_SecondaryColor"},
    {"fogcoord", "vec4(gl_FogCoord, 0.0, 0.0, 1.0)"},
    {"texcoord", "gl_MultiTexCoord0"},
    {"texcoord[]", "gl_MultiTexCoord#", 8},
};

// A '@' stands for Front or Back: the path may name the face after its first part.
constexpr Row states[] = {
    {"material.ambient", "gl_@Material.ambient"},
    {"material.diffuse", "gl_@Material.diffuse"},
    {"material.specular", "gl_@Material.specular"},
    {"material.emission", "gl_@Material.emission"},
    {"material.shininess", "vec4(gl_@Material.shininess, 0.0, 0.0, 1.0)"},
    {"light[].ambient", "gl_LightSource[#].ambient", 8},
    {"light[].diffuse", "gl_LightSource[#].diffuse", 8},
    {"light[].specular", "gl_LightSource[#].specular", 8},
    {"light[].position", "gl_LightSource[#].position", 8},
    {"light[].attenuation",
     "vec4(gl_LightSource[#].constantAttenuation, gl_LightSource[#].linearAttenuation, "
     "gl_LightSource[#].quadraticAttenuation, gl_LightSource[#].spotExponent)",
     8},
    {"light[].spot.direction", "vec4(gl_LightSource[#].spotDirection, gl_LightSource[#].spotCosCutoff)", 8},
    {"light[].half", "gl_LightSource[#].halfVector", 8},
    {"lightmodel.ambient", "gl_LightModel.ambient"},
    {"lightmodel.scenecolor", "gl_@LightModelProduct.sceneColor"},
    {"lightprod[].ambient", "gl_@LightProduct[#].ambient", 8},
    {"lightprod[].diffuse", "gl_@LightProduct[#].diffuse", 8},
    {"lightprod[].specular", "gl_@LightProduct[#].specular", 8},
    {"texgen[].eye.s", "gl_EyePlaneS[#]", 8},
    {"texgen[].eye.t", "gl_EyePlaneT[#]", 8},
    {"texgen[].eye.r", "gl_EyePlaneR[#]", 8},
    {"texgen[].eye.q", "gl_EyePlaneQ[#]", 8},
    {"texgen[].object.s", "gl_ObjectPlaneS[#]", 8},
    {"texgen[].object.t", "gl_ObjectPlaneT[#]", 8},
    {"texgen[].object.r", "gl_ObjectPlaneR[#]", 8},
    {"texgen[].object.q", "gl_ObjectPlaneQ[#]", 8},
    {"fog.color", "gl_Fog.color"},
    {"fog.params", "vec4(gl_Fog.density, gl_Fog.start, gl_Fog.end, gl_Fog.scale)"},
    {"clip[].plane", "gl_ClipPlane[#]", 8},
    {"point.size", "vec4(gl_Point.size, gl_Point.sizeMin, gl_Point.sizeMax, gl_Point.fadeThresholdSize)"},
    {"point.attenuation",
     "vec4(gl_Point.distanceConstantAttenuation, gl_Point.distanceLinearAttenuation, "
     "gl_Point.distanceQuadraticAttenuation, 1.0)"},
};

constexpr Row results[] = {
    {"position", "gl_Position"},
    {"color", "gl_FrontColor"},
    {"color.primary", "gl_FrontColor"},
    {"color.secondary", "gl_FrontSecondaryColor"},
    {"color.front", "gl_FrontColor"},
    {"color.front.primary", "gl_FrontColor"},
    {"color.front.secondary", "gl_FrontSecondaryColor"},
    {"color.back", "gl_BackColor"},
    {"color.back.primary", "gl_BackColor"},
    {"color.back.secondary", "gl_BackSecondaryColor"},
    {"fogcoord", "gl_FogFragCoord"},
    {"pointsize", "gl_PointSize"},
    {"texcoord", "gl_TexCoord[0]"},
    {"texcoord[]", "gl_TexCoord[#]", 8},
};

std::string replaced(std::string_view text, char letter, std::string_view by) {
  std::string result;
  for (const char c : text) {
    if (c == letter) {
      result += by;
    } else {
      result += c;
    }
  }
  return result;
}

// "light[].spot.direction"
std::string pattern_of(Path path) {
  std::string pattern;
  for (const PathPart& part : path) {
    pattern += (pattern.empty() ? "" : ".") + part.name + (part.indexed ? "[]" : "");
  }
  return pattern;
}

int index_of(Path path) {
  const auto part = std::find_if(path.begin(), path.end(), [](const PathPart& p) { return p.indexed; });
  return part != path.end() ? part->first : 0;
}

bool has_range(Path path) {
  return std::any_of(path.begin(), path.end(), [](const PathPart& part) { return part.last != part.first; });
}

// The GLSL of the row that matches, or an empty text.
std::string look_up(std::span<const Row> table, Path path) {
  const std::string pattern = pattern_of(path);
  const int index = index_of(path);
  for (const Row& row : table) {
    if (row.path == pattern && index < row.count && !has_range(path)) {
      return replaced(row.glsl, '#', std::to_string(index));
    }
  }
  return {};
}

// Takes the part that names a face out of the path.
std::string_view take_face(std::vector<PathPart>& path) {
  if (path.size() < 2 || (path[1].name != "front" && path[1].name != "back")) {
    return "Front";
  }
  const std::string_view face = path[1].name == "front" ? "Front" : "Back";
  path.erase(path.begin() + 1);
  return face;
}

// The GLSL of a matrix with these suffixes, whose columns are the rows that the assembly program names.
struct MatrixName {
  std::string plain;
  std::string inverse;
  std::string transpose;
  std::string inverse_transpose;
  int program_matrix = -1;
};

std::optional<MatrixName> matrix_name(const PathPart& part) {
  const auto built_in = [](const std::string& name, const std::string& index) {
    return MatrixName{name + index, name + "Inverse" + index, name + "Transpose" + index,
                      name + "InverseTranspose" + index};
  };
  const std::string index = std::to_string(part.first);
  if (part.name == "modelview" && part.first == 0) return built_in("gl_ModelViewMatrix", "");
  if (part.name == "projection" && !part.indexed) return built_in("gl_ProjectionMatrix", "");
  if (part.name == "mvp" && !part.indexed) return built_in("gl_ModelViewProjectionMatrix", "");
  if (part.name == "texture" && part.first < 8) return built_in("gl_TextureMatrix", "[" + index + "]");
  if (part.name == "program" && part.indexed && part.first < 32) {
    const std::string name = "assembly_matrix_" + index;
    return MatrixName{name, "inverse(" + name + ")", "transpose(" + name + ")", "transpose(inverse(" + name + "))",
                      part.first};
  }
  return std::nullopt;
}

// "matrix.NAME[.inverse|.transpose|.invtrans][.row[a..b]]". GLSL indexes columns, so row i is column i of the
// transposed matrix.
std::vector<Vector> matrix_rows(Path path) {
  std::size_t at = 2;
  const std::optional<MatrixName> name = path.size() >= at ? matrix_name(path[1]) : std::nullopt;
  if (!name) return {};
  std::string matrix = name->transpose;
  if (at < path.size() && path[at].name != "row") {
    const std::string& change = path[at++].name;
    if (change != "inverse" && change != "transpose" && change != "invtrans") return {};
    matrix = change == "inverse" ? name->inverse_transpose : change == "transpose" ? name->plain : name->inverse;
  }
  int first = 0;
  int last = 3;
  if (at < path.size() && path[at].name == "row" && path[at].indexed) {
    first = path[at].first;
    last = path[at++].last;
  }
  if (at != path.size() || first > last || last > 3) return {};
  std::vector<Vector> rows;
  for (int row = first; row <= last; ++row) {
    rows.push_back({.text = fmt::format("{}[{}]", matrix, row), .matrix = name->program_matrix});
  }
  return rows;
}

std::vector<Vector> program_parameters(Path path) {
  constexpr int most_parameters = 1 << 16;
  if (path.size() != 1 || !path[0].indexed || path[0].first > path[0].last || path[0].last >= most_parameters)
    return {};
  const Bank bank = path[0].name == "env" ? Bank::environment : path[0].name == "local" ? Bank::local : Bank::none;
  std::vector<Vector> vectors;
  for (int index = path[0].first; bank != Bank::none && index <= path[0].last; ++index) {
    vectors.push_back({.text = {}, .bank = bank, .index = index});
  }
  return vectors;
}

}  // namespace

std::optional<Vector> vertex_attribute(Path path) {
  const Path rest = path.subspan(1);
  const bool generic = rest.size() == 1 && rest[0].name == "attrib" && rest[0].indexed && !has_range(rest);
  if (generic && rest[0].first > 0) {
    return Vector{.text = fmt::format("assembly_attribute_{}", rest[0].first), .generic = rest[0].first};
  }
  const std::string text = generic ? "gl_Vertex" : look_up(attributes, rest);  // generic attribute 0 is the position
  return text.empty() ? std::nullopt : std::optional(Vector{.text = text});
}

std::vector<Vector> parameters(Path path) {
  const Path rest = path.subspan(1);
  if (path[0].name == "program") return program_parameters(rest);
  if (path[0].name != "state" || rest.empty()) return {};
  if (rest[0].name == "matrix") return matrix_rows(rest);
  std::vector<PathPart> parts(rest.begin(), rest.end());
  const std::string_view face = take_face(parts);
  if (parts[0].name == "texgen" && !parts[0].indexed) parts[0].indexed = true;  // of texture unit 0
  const std::string text = look_up(states, parts);
  if (text.empty()) return {};
  return {{.text = replaced(text, '@', face)}};
}

std::optional<Output> result(Path path) {
  const std::string name = look_up(results, path.subspan(1));
  if (name.empty()) return std::nullopt;
  return Output{name, name == "gl_FogFragCoord" || name == "gl_PointSize"};
}

}  // namespace glark::refine::assembly
