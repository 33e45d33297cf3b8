// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

constexpr char pn_source[] =
#include "glark/core/refine/epilogue/pn.glsl.inc"
    ;
constexpr char scalar_tagged_source[] =
#include "glark/core/refine/epilogue/scalar_tagged_pn.glsl.inc"
    ;
constexpr char displacement_source[] =
#include "glark/core/refine/epilogue/displacement.glsl.inc"
    ;

const InputVariable* find_vector(const EpiloguePlan& plan, capture::Role role) {
  for (const InputVariable& input : plan.inputs) {
    const NumericType& type = *input.type;
    const bool vector = type.scalar == Scalar::float32 && type.columns == 1 && type.rows >= 3 && !input.field.is_array;
    if (input.field.role == role && vector) return &input;
  }
  return nullptr;
}

std::string arguments(const EpiloguePlan& plan, const InputVariable& input, const std::string& before,
                      const std::string& after) {
  std::string text;
  for (int corner = 0; corner < 3; ++corner) text += ", " + before + corner_expression(plan, input, 0, corner) + after;
  return text;
}

// The w of a vec4 stays linear.
std::string with_linear_w(const EpiloguePlan& plan, const InputVariable& input, const std::string& curved,
                          TypeSet& mixed_types) {
  if (input.type->rows == 3) return curved;
  mixed_types.insert("float");
  const std::string w = arguments(plan, input, "", ".w").substr(2);
  return "vec4(" + curved + ", @mix(" + w + "))";
}

// Shortest text that reads back as the same number, always with a point.
std::string literal(float value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
  const std::string text(digits.data(), end);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string tagged_corner(const EpiloguePlan& plan, int corner) {
  const InputVariable& position = *pn_position(plan);
  const core::ScalarTags& constant = plan.constant_tags;
  const std::string discontinuity =
      plan.discontinuity ? resized(plan, *plan.discontinuity, corner, 4) : std::string("vec4(0.0, 0.0, 0.0, 1.0)");
  const std::string tags = plan.scalar_tags ? resized(plan, *plan.scalar_tags, corner, 3)
                                            : "vec3(" + literal(constant.sharpness) + ", " + literal(constant.tension) +
                                                  ", " + literal(constant.bias) + ")";
  const std::string name = "@c" + std::to_string(corner);
  return "  @StCorner " + name + " = @st_corner(" + resized(plan, position, corner, 4) + ", " +
         resized(plan, *pn_normal(plan), corner, 3) + ", " + discontinuity + ", " + tags + ");\n";
}

// Of the tagged corners; those that welding found are in the record.
std::string find_controls(const EpiloguePlan& plan) {
  if (plan.control_offset < 0) return "  @st_controls(@c0, @c1, @c2);\n";
  struct Control {
    const char* name;
    int near;
    int far;
    int offset;
  };
  static constexpr Control controls[] = {{"b210", 0, 1, 0}, {"b120", 1, 0, 3}, {"b021", 1, 2, 0},
                                         {"b012", 2, 1, 3}, {"b102", 2, 0, 0}, {"b201", 0, 2, 3}};
  std::string text;
  for (const Control& control : controls) {
    text += std::string("  @st_") + control.name + " = @st_welded_control(@c" + std::to_string(control.near) + ", @c" +
            std::to_string(control.far) + ", " +
            corner_vector(plan, plan.control_offset + control.offset, control.near) + ");\n";
  }
  return text;
}

std::string fill_by_scalar_tagged_pn(const EpiloguePlan& plan, TypeSet& mixed_types) {
  const InputVariable& position = *pn_position(plan);
  const InputVariable& normal = *pn_normal(plan);
  const std::string corners = "(@weights, @c0, @c1, @c2)";
  const std::string points = "@st_position(@weights, @c0.position.xyz, @c1.position.xyz, @c2.position.xyz)";
  return tagged_corners(plan) + find_controls(plan) + "  " + position.global + " = " +
         with_linear_w(plan, position, points, mixed_types) + ";\n  " + normal.global + " = " +
         with_linear_w(plan, normal, "@st_normal" + corners, mixed_types) + ";\n";
}

}  // namespace

const InputVariable* pn_position(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::position); }
const InputVariable* pn_normal(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::normal); }

std::string resized(const EpiloguePlan& plan, const InputVariable& input, int corner, int rows) {
  static constexpr std::array<const char*, 4> swizzles = {"", "", ".xy", ".xyz"};
  std::string value = corner_expression(plan, input, 0, corner);
  if (input.type->rows == rows) return value;
  return rows == 4 ? "vec4(" + value + ", 1.0)" : value + swizzles.at(static_cast<std::size_t>(rows));
}

std::string tagged_corners(const EpiloguePlan& plan) {
  return tagged_corner(plan, 0) + tagged_corner(plan, 1) + tagged_corner(plan, 2);
}

std::string pn_functions(const EpiloguePlan& plan) {
  std::string source = pn_source;
  if (plan.scalar_tagged() || plan.displaced()) source += scalar_tagged_source;
  if (plan.displaced()) source += displacement_source;
  Tokens tokens = tokenize(source);
  rename_identifiers(tokens, [](const std::string& name) {
    return name.starts_with("glark_") ? "@" + name.substr(6) : std::string();
  });
  for (Token& token : tokens) {
    if (token.before.find('/') != std::string::npos) token.before = "\n";
  }
  return to_text(tokens) + "\n";
}

namespace {

// b210, b120, b021, b012, b102, b201: of edge k, that towards the next corner, then that of the next corner towards this one.
std::string welded_controls(const EpiloguePlan& plan) {
  std::string text;
  for (int edge = 0; edge < 3; ++edge) {
    text += ", " + corner_vector(plan, plan.control_offset, edge) + ", " +
            corner_vector(plan, plan.control_offset + 3, (edge + 1) % 3);
  }
  return text;
}

}  // namespace

std::string fill_by_pn(const EpiloguePlan& plan, TypeSet& mixed_types) {
  if (plan.scalar_tagged()) return fill_by_scalar_tagged_pn(plan, mixed_types);
  const InputVariable& position = *pn_position(plan);
  const InputVariable& normal = *pn_normal(plan);
  const bool homogeneous = position.type->rows == 4;
  const std::string points =
      homogeneous ? arguments(plan, position, "", "") : arguments(plan, position, "vec4(", ", 1.0)");
  const std::string normals = arguments(plan, normal, "", normal.type->rows == 4 ? ".xyz" : "");
  const std::string flat_points = arguments(plan, position, "", homogeneous ? ".xyz" : "");
  const std::string curved = plan.control_offset >= 0 ? "@pn_patch(@weights" + flat_points + welded_controls(plan) + ")"
                                                      : "@pn_position(@weights" + points + normals + ")";
  const std::string tilted = "@pn_normal(@weights" + flat_points + normals + ")";
  return "  " + position.global + " = " + with_linear_w(plan, position, curved, mixed_types) + ";\n" +  //
         "  " + normal.global + " = " + with_linear_w(plan, normal, tilted, mixed_types) + ";\n";
}

}  // namespace glark::refine
