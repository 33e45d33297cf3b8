// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <array>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

// The functions of each refinement that curves positions without tags, by its word. refine/CMakeLists.txt makes the
// list.
struct PatchSource {
  std::string_view word;
  const char* source;
};
constexpr PatchSource patch_sources[] = {
#include "glark/core/refine/epilogue/patches.inc"
};
constexpr char scalar_tagged_source[] =
#include "glark/core/refine/epilogue/scalar_tagged_pn.glsl.inc"
    ;
constexpr char displacement_source[] =
#include "glark/core/refine/epilogue/displacement.glsl.inc"
    ;

std::string patch_source(std::string_view word) {
  for (const PatchSource& patch : patch_sources) {
    if (patch.word == word) return patch.source;
  }
  return {};
}

const InputVariable* find_vector(const EpiloguePlan& plan, capture::Role role) {
  for (const InputVariable& input : plan.inputs) {
    const NumericType& type = *input.type;
    const bool vector = type.scalar == Scalar::float32 && type.columns == 1 && type.rows >= 3 && !input.field.is_array;
    if (input.field.role == role && vector) return &input;
  }
  return nullptr;
}

std::string numbered(const std::string& name, int corner) { return name + std::to_string(corner); }

// Declares the corners @p0 to @p2. Declares their unit normals @n0 to @n2 unless welding has found the control points.
std::string declare_corners(const EpiloguePlan& plan) {
  std::string text;
  for (int corner = 0; corner < 3; ++corner) {
    text += "  vec4 " + numbered("@p", corner) + " = " + resized(plan, *position_of(plan), corner, 4) + ";\n";
    if (plan.control_offset >= 0) continue;
    text += "  vec3 " + numbered("@n", corner) + " = @pn_unit(" + resized(plan, *normal_of(plan), corner, 3) + ");\n";
  }
  return text;
}

// The control point next to corner `near` on the edge to corner `far`.
std::string control(const EpiloguePlan& plan, int near, int far) {
  const bool follows = far == (near + 1) % 3;
  if (plan.control_offset >= 0) return corner_vector(plan, plan.control_offset + (follows ? 0 : 3), near);
  return "@pn_tangent(" + numbered("@p", near) + ", " + numbered("@n", near) + ", " + numbered("@p", far) + ")";
}

// The control points of all edges, as further arguments.
std::string controls(const EpiloguePlan& plan) {
  std::string text;
  for (int corner = 0; corner < 3; ++corner) {
    const int next = (corner + 1) % 3;
    text += ", " + control(plan, corner, next) + ", " + control(plan, next, corner);
  }
  return text;
}

std::string fill_from_patch(const EpiloguePlan& plan, TypeSet& mixed_types) {
  const InputVariable& position = *position_of(plan);
  const InputVariable& normal = *normal_of(plan);
  const std::string patch = "@" + std::string(plan.traits().word) + "_patch" + patch_arguments(plan) + ")";
  std::string text = declare_corners(plan);
  text += "  " + position.global + " = " + with_linear_w(plan, position, patch, mixed_types) + ";\n";
  if (!plan.traits().curves_normals) return text;
  std::string corners = "(@weights, @p0.xyz, @p1.xyz, @p2.xyz";
  for (int corner = 0; corner < 3; ++corner) corners += ", " + resized(plan, normal, corner, 3);
  const bool creased = plan.creased && plan.control_offset >= 0;
  const std::string value = creased ? "@pn_normal_beside_creases" + corners + controls(plan) : "@pn_normal" + corners;
  return text + "  " + normal.global + " = " + with_linear_w(plan, normal, value + ")", mixed_types) + ";\n";
}

}  // namespace

const InputVariable* position_of(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::position); }
const InputVariable* normal_of(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::normal); }

std::string resized(const EpiloguePlan& plan, const InputVariable& input, int corner, int rows) {
  static constexpr std::array<const char*, 4> swizzles = {"", "", ".xy", ".xyz"};
  std::string value = corner_expression(plan, input, 0, corner);
  if (input.type->rows == rows) return value;
  return rows == 4 ? "vec4(" + value + ", 1.0)" : value + swizzles.at(static_cast<std::size_t>(rows));
}

std::string with_linear_w(const EpiloguePlan& plan, const InputVariable& input, const std::string& value,
                          TypeSet& mixed_types) {
  if (input.type->rows == 3) return value;
  mixed_types.insert("float");
  std::string w;
  for (int corner = 0; corner < 3; ++corner) {
    w += (corner == 0 ? "" : ", ") + corner_expression(plan, input, 0, corner) + ".w";
  }
  return "vec4(" + value + ", @mix(" + w + "))";
}

std::string patch_arguments(const EpiloguePlan& plan) {
  std::string text = "(@weights, ";
  if (plan.traits().number.exists()) text += std::string(shape_number_uniform) + ", ";
  return text + "@p0.xyz, @p1.xyz, @p2.xyz" + controls(plan);
}

std::string surface_functions(const EpiloguePlan& plan) {
  std::string source = patch_source("pn");  // begins with what all of them use
  if (plan.traits().takes_tags || plan.displaced()) source += scalar_tagged_source;
  if (plan.displaced()) source += displacement_source;
  if (plan.traits().word != "pn") source += patch_source(plan.traits().word);
  Tokens tokens = tokenize(source);
  rename_identifiers(tokens, [](const std::string& name) {
    return name.starts_with("glark_") ? "@" + name.substr(6) : std::string();
  });
  for (Token& token : tokens) {
    if (token.before.find('/') != std::string::npos) token.before = "\n";
  }
  const bool has_number = plan.curved() && !plan.traits().takes_tags && plan.traits().number.exists();
  const std::string precision = plan.version.es ? "highp " : "";
  const std::string number =
      has_number ? "uniform " + precision + "float " + shape_number_uniform + ";\n" : std::string();
  return number + to_text(tokens) + "\n";
}

std::string fill_from_surface(const EpiloguePlan& plan, TypeSet& mixed_types) {
  return plan.traits().takes_tags ? fill_from_tagged_surface(plan, mixed_types) : fill_from_patch(plan, mixed_types);
}

}  // namespace glark::refine
