// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined vertices that move between levels: docs/architecture.md, Geomorphing. Based on: H. Hoppe, Progressive Meshes, 1996,
// section 3.2 (geomorphs), over the lattice of a pattern.
#include "glark/core/refine/epilogue.h"

namespace glark::refine {
namespace {

// Depths are in levels here: dyadic, so that ceil and differences are exact. What is odd, and what its neighbours are, is told by the
// place of the vertex alone, the same in every piece.
constexpr const char* place_text = R"(vec3 @weights;
vec3 @parent0;
vec3 @parent1;
vec3 @parent2;
bool @has_third_parent;
float @fraction;
bool @odd(float x) { return x - 2.0 * floor(0.5 * x) > 0.5; }
vec2 @segments(float depth) {
  vec2 n = vec2(1.0);
  for (int i = 0; i < 11; ++i) {
    if (float(i) < depth) n *= vec2(2.0, 0.5);
  }
  return n;
}
void @between(vec3 from_first, float depth) {
  @parent0 = @weights - from_first;
  @parent1 = @weights + from_first;
  @fraction = 1.0 - (ceil(depth) - depth);
}
void @place_on_edge(vec3 direction, float along, float depth) {
  vec2 n = @segments(depth);
  if (depth > 0.0 && @odd(along * n.x)) @between(direction * n.y, depth);
}
const vec3 @centre = vec3(0.33331298828125, 0.333343505859375, 0.333343505859375);
void @place_in_centre(float depth) {
  @weights = @centre;
  @fraction = depth;
  @parent0 = vec3(1.0, 0.0, 0.0);
  @parent1 = vec3(0.0, 1.0, 0.0);
  @parent2 = vec3(0.0, 0.0, 1.0);
  @has_third_parent = @fraction < 1.0;
}
vec3 @place_in_coarser_ring(vec3 at, vec2 n) {
  if (n.x < 5.0) return @centre;
  float along = at.z < 1.5 ? at.y : (at.x < 1.5 ? at.z : at.x);
  float coarse = clamp(2.0 * floor(0.5 * along), 2.0, n.x - 4.0);
  vec3 place = vec3((n.x - coarse) - 2.0, coarse, 2.0);
  return (at.z < 1.5 ? place : (at.x < 1.5 ? place.zxy : place.yzx)) * n.y;
}
void @place_inside(float depth) {
  if (depth <= 1.0) {
    @place_in_centre(depth);
    return;
  }
  vec2 n = @segments(depth);
  vec3 at = @weights * n.x;
  if (min(min(at.x, at.y), at.z) < 1.5 && depth <= 6.0) {
    vec3 coarse = @place_in_coarser_ring(at, n);
    @weights = coarse + (1.0 - (ceil(depth) - depth)) * (@weights - coarse);
  } else if (!@odd(at.x)) {
    if (@odd(at.y)) @between(vec3(0.0, n.y, -n.y), depth);
  } else {
    @between(@odd(at.y) ? vec3(n.y, -n.y, 0.0) : vec3(n.y, 0.0, -n.y), depth);
  }
}
void @place() {
  vec2 lattice = glark_lattice * 0.000030517578125;
  vec3 local = vec3((1.0 - lattice.x) - lattice.y, lattice);
  vec3 steps = floor(glark_patch.xyw * vec3(0.0078125, 0.0078125, 0.25));
  vec2 corner = (glark_patch.xy - 128.0 * steps.xy) * 0.015625;
  float rotation = glark_patch.w - 4.0 * steps.z;
  vec2 tile = rotation < 0.5 ? local.yz : (rotation < 1.5 ? local.xy : local.zx);
  vec2 uv = corner + glark_patch.z * tile;
  @weights = vec3((1.0 - uv.x) - uv.y, uv);
  @fraction = 1.0;
  @has_third_parent = false;
  vec3 depths = steps * 0.015625;
  if (@weights.z == 0.0) @place_on_edge(vec3(-1.0, 1.0, 0.0), @weights.y, depths.x);
  else if (@weights.x == 0.0) @place_on_edge(vec3(0.0, -1.0, 1.0), @weights.z, depths.y);
  else if (@weights.y == 0.0) @place_on_edge(vec3(1.0, 0.0, -1.0), @weights.x, depths.z);
  else @place_inside(min(min(depths.x, depths.y), depths.z));
}
)";

std::string calls(const EpiloguePlan& plan, const std::string& function, const std::string& arguments,
                  const std::string& indent) {
  std::string text;
  for (std::size_t unit = 0; unit < plan.resets.size(); ++unit) {
    if (unit_has_morphed_outputs(plan, unit)) {
      text += indent + "@" + function + "_" + std::to_string(unit) + "(" + arguments + ");\n";
    }
  }
  return text;
}

}  // namespace

std::string morph_place_function() { return place_text; }

// At the parents first, so that what is not mixed keeps the values of the vertex itself.
std::string run_between_parents(const EpiloguePlan& plan) {
  if (plan.morphed.empty()) return "  @evaluate();\n";
  std::string text = R"(  if (@fraction < 1.0) {
    vec3 own = @weights;
    float share = @has_third_parent ? (1.0 - @fraction) / 3.0 : 0.5 * (1.0 - @fraction);
    @weights = @parent0;
    @evaluate();
)";
  text += calls(plan, "begin", "", "    ") + calls(plan, "gather", "share", "    ");
  text += "    @weights = @parent1;\n    @evaluate();\n" + calls(plan, "gather", "share", "    ");
  text += "    if (@has_third_parent) {\n      @weights = @parent2;\n      @evaluate();\n" +
          calls(plan, "gather", "share", "      ") + "    }\n";
  text += "    @weights = own;\n    @evaluate();\n" + calls(plan, "gather", "@fraction", "    ");
  return text + calls(plan, "settle", "", "    ") + "  } else {\n    @evaluate();\n  }\n";
}

std::string prototypes_of_morphed_unit(const EpiloguePlan& plan, std::size_t unit) {
  if (!unit_has_morphed_outputs(plan, unit)) return {};
  const std::string suffix = "_" + std::to_string(unit);
  return "void @begin" + suffix + "();\nvoid @gather" + suffix + "(float share);\nvoid @settle" + suffix + "();\n";
}

// A portion of each value is added to a sum, which is put in its place in the end.
std::string add_functions(const TypeSet& types, bool define) {
  std::string text;
  for (const std::string& type : types) {
    text += type + " @add(" + type + " sum, " + type + " value, float share)";
    if (!define) {
      text += ";\n";
      continue;
    }
    const bool wide = numeric_type(type)->scalar == Scalar::float64;
    text += " {\n  @precise " + type + " result = sum + " + (wide ? "double(share)" : "share") +
            " * value;\n  return result;\n}\n";
  }
  return text;
}

bool unit_has_morphed_outputs(const EpiloguePlan& plan, std::size_t unit) {
  for (const OutputVariable& output : plan.morphed) {
    if (output.unit == unit) return true;
  }
  return false;
}

}  // namespace glark::refine
