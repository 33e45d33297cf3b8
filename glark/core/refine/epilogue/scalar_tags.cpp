// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

// The shortest text that reads back as the same number, always with a decimal point.
std::string literal(float value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
  const std::string text(digits.data(), end);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string tagged_corner(const EpiloguePlan& plan, int corner) {
  const InputVariable& position = *position_of(plan);
  const core::ScalarTags& constant = plan.constant_tags;
  const std::string discontinuity =
      plan.discontinuity ? resized(plan, *plan.discontinuity, corner, 4) : std::string("vec4(0.0, 0.0, 0.0, 1.0)");
  const std::string tags = plan.scalar_tags ? resized(plan, *plan.scalar_tags, corner, 3)
                                            : "vec3(" + literal(constant.sharpness) + ", " + literal(constant.tension) +
                                                  ", " + literal(constant.bias) + ")";
  const std::string name = "@c" + std::to_string(corner);
  return "  @StCorner " + name + " = @st_corner(" + resized(plan, position, corner, 4) + ", " +
         resized(plan, *normal_of(plan), corner, 3) + ", " + discontinuity + ", " + tags + ");\n";
}

// Control points follow from the tagged corners. If edges are welded, the record holds those of untagged corners.
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

}  // namespace

std::string tagged_corners(const EpiloguePlan& plan) {
  return tagged_corner(plan, 0) + tagged_corner(plan, 1) + tagged_corner(plan, 2);
}

std::string fill_from_tagged_surface(const EpiloguePlan& plan, TypeSet& mixed_types) {
  const InputVariable& position = *position_of(plan);
  const InputVariable& normal = *normal_of(plan);
  const std::string corners = "(@weights, @c0, @c1, @c2)";
  const std::string points = "@st_position(@weights, @c0.position.xyz, @c1.position.xyz, @c2.position.xyz)";
  return tagged_corners(plan) + find_controls(plan) + "  " + position.global + " = " +
         with_linear_w(plan, position, points, mixed_types) + ";\n  " + normal.global + " = " +
         with_linear_w(plan, normal, "@st_normal" + corners, mixed_types) + ";\n";
}

}  // namespace glark::refine
