// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined vertices that move between levels (docs/explanation/depths.md, Geomorphing). Based on: H. Hoppe, Progressive
// Meshes, 1996, section 3.2 (geomorphs), over the lattice of a pattern.
#include "glark/core/pattern/pieces.glsl.h"
#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

// Depths are in levels here. They are dyadic, so ceil and differences are exact. The place of a vertex alone determines
// whether it is odd and where its neighbours are, so all pieces agree.
constexpr const char* place_text = R"(vec3 @weights;
vec3 @parent0;
vec3 @parent1;
vec3 @parent2;
bool @has_third_parent;
float @fraction;
float @least;
float @inner;
int @shallow_edge;
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
vec3 @turned(vec3 at, int edge) { return edge == 0 ? at : (edge == 1 ? at.yzx : at.zxy); }
vec3 @turned_back(vec3 at, int edge) { return edge == 0 ? at : (edge == 1 ? at.zxy : at.yzx); }
float @middle_of_group(float along, float size, float n) {
  float first = size * floor(along / size);
  return 0.5 * (max(first, 1.0) + min(first + (size - 1.0), n - 2.0));
}
float @merged(float along, float n, float depth) {
  float size = n * @segments(depth).y;
  if (size < 1.0) return along;
  float fine = @middle_of_group(along, size, n);
  if (depth == 0.0) return fine;
  float coarse = @middle_of_group(along, 2.0 * size, n);
  return coarse + (1.0 - (ceil(depth) - depth)) * (fine - coarse);
}
int @row_of(vec3 at) {
  int row = @shallow_edge;
  for (int i = 0; i < 2; ++i) {
    if (@turned(at, row).z > 1.5) row = row == 2 ? 0 : row + 1;
  }
  return row;
}
vec3 @place_in_ring(vec3 at, vec2 n) {
  int row = @row_of(at);
  float merged = @merged(@turned(at, row).y, n.x, row == @shallow_edge ? @least : @inner);
  return @turned_back(vec3((n.x - merged) - 1.0, merged, 1.0), row) * n.y;
}
vec3 @place_in_coarser_ring(vec3 at, vec2 n) {
  if (n.x < 5.0) return @centre;
  int row = @row_of(at);
  float half_n = 0.5 * n.x;
  float along = clamp(floor(0.5 * @turned(at, row).y), 1.0, half_n - 2.0);
  return @place_in_ring(@turned_back(vec3((half_n - along) - 1.0, along, 1.0), row), n * vec2(0.5, 2.0));
}
vec3 @place_beside_ring(vec3 place, vec2 n) {
  vec3 at = place * (0.5 * n.x);
  if (min(min(at.x, at.y), at.z) > 1.25) return place;
  vec3 coarse = @place_in_ring(at, n * vec2(0.5, 2.0));
  return coarse + (1.0 - (ceil(@inner) - @inner)) * (place - coarse);
}
void @place_inside(vec3 depths) {
  @least = min(min(depths.x, depths.y), depths.z);
  float most = max(max(depths.x, depths.y), depths.z);
  float middle = max(min(depths.x, depths.y), min(max(depths.x, depths.y), depths.z));
  @inner = max(@least, min(middle, @lifted));
  if (@inner <= 1.0) {
    @place_in_centre(min(most, 1.0));
    return;
  }
  @shallow_edge = depths.x == @least ? 0 : (depths.y == @least ? 1 : 2);
  float share = 1.0 - (ceil(@inner) - @inner);
  vec2 n = @segments(@inner);
  vec3 at = @weights * n.x;
  if (min(min(at.x, at.y), at.z) < 1.5 && @inner <= 6.0) {
    @weights = @place_in_ring(at, n);
    if (share == 1.0) return;
    vec3 coarse = @place_in_coarser_ring(at, n);
    @weights = coarse + share * (@weights - coarse);
    return;
  }
  if (@odd(at.x)) @between(@odd(at.y) ? vec3(n.y, -n.y, 0.0) : vec3(n.y, 0.0, -n.y), @inner);
  else if (@odd(at.y)) @between(vec3(0.0, n.y, -n.y), @inner);
  if (@least >= @lifted || share == 1.0) return;
  if (@fraction < 1.0) {
    @parent0 = @place_beside_ring(@parent0, n);
    @parent1 = @place_beside_ring(@parent1, n);
  } else {
    @weights = @place_beside_ring(@weights, n);
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
  else @place_inside(depths);
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

std::string morph_place_function() {
  return "const float @lifted = " + std::to_string(pattern::lifted_interior) + ".0;\n" + place_text;
}

// The stage runs at the parents first, because outputs that are not mixed must end with the vertex's own values.
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

// Functions that add a share of a value to a sum. The sum replaces the value at the end.
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
