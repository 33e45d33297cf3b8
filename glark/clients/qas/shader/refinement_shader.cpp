// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/qas.h>

#include <algorithm>

namespace glark::qas {
namespace {

constexpr char quadratic[] =
#include "glark/clients/qas/shader/refine.glsl.inc"
    ;

constexpr char quartic[] =
#include "glark/clients/qas/shader/quartic.glsl.inc"
    ;

// "point[1]" at corner 2 is ark_corner_point[2][1].
std::string at_corner(const std::string& input, int corner) {
  const std::size_t end = std::min(input.find('['), input.size());
  return "ark_corner_" + input.substr(0, end) + "[" + std::to_string(corner) + "]" + input.substr(end) + ".xyz";
}

std::string fitted(const std::string& input, const std::string& edge) {
  std::string call = "glark_qas_quadratic(";
  for (int i = 0; i < 3; ++i) call += at_corner(input, i) + ", ";
  for (int i = 0; i < 3; ++i) call += at_corner(edge, i) + (i < 2 ? ", " : ")");
  return call;
}

std::string through_15_points(const std::string& input) {
  const std::string corner = "ark_corner_" + input;
  return "glark_qas_quartic(" + corner + "[0], " + corner + "[1], " + corner + "[2])";
}

// A zero normal stays zero.
std::string with_unit_length(const std::string& input, const std::string& value) {
  return "  vec3 glark_qas_n = " + value + ";\n  " + input +
         ".xyz = dot(glark_qas_n, glark_qas_n) > 0.0 ? normalize(glark_qas_n) : glark_qas_n;\n";
}

}  // namespace

// The shader's own variables begin with a prefix that no input's name may have (11.R.9).
std::string refinement_shader(const ShaderInputs& inputs) {
  std::string body = "  " + inputs.position + ".xyz = " + fitted(inputs.position, inputs.edge_position) + ";\n";
  if (!inputs.normal.empty()) body += with_unit_length(inputs.normal, fitted(inputs.normal, inputs.edge_normal));
  return quadratic + ("void refine() {\n" + body + "}\n");
}

std::string quartic_refinement_shader(const std::string& points, const std::string& normals) {
  std::string body = "  " + points + "[0].xyz = " + through_15_points(points) + ";\n";
  if (!normals.empty()) body += with_unit_length(normals + "[0]", through_15_points(normals));
  return quartic + ("void refine() {\n" + body + "}\n");
}

}  // namespace glark::qas
