// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/epilogue.h"

namespace glark::refine {
namespace {

constexpr char pn_source[] =
#include "glark/core/refine/pn.glsl.inc"
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

}  // namespace

const InputVariable* pn_position(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::position); }
const InputVariable* pn_normal(const EpiloguePlan& plan) { return find_vector(plan, capture::Role::normal); }

std::string pn_functions() {
  Tokens tokens = tokenize(pn_source);
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
