// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

// GLSL before 1.30 needs an extension to ask for the size of a texture. Without it, slopes assume 256 texels a side.
std::string texel_functions(const GlslVersion& version) {
  const bool sized = version.at_least(130, 300);
  const std::string map = height_map_uniform;
  const std::string range = height_range_uniform;
  const std::string lookup = (sized ? "textureLod(" : "texture2DLod(") + map + ", coordinate, 0.0)";
  const std::string texel = "float @texel(vec2 coordinate) {\n  @precise float texel = " + range + ".x * dot(" +
                            lookup + ", " + height_channel_uniform + ") + " + range + ".y;\n  return texel;\n}\n";
  const std::string size = "vec2 @texel_size() { return 1.0 / vec2(";
  if (sized) return texel + size + "textureSize(" + map + ", 0)); }\n";
  return texel + "#ifdef GL_EXT_gpu_shader4\n" + size + "textureSize2D(" + map + ", 0)); }\n#else\n" +
         "vec2 @texel_size() { return vec2(0.00390625); }\n#endif\n";
}

// The words that welding has written for each corner, as further arguments.
std::string of_corners(const EpiloguePlan& plan, int first, int words) {
  std::string text;
  for (int corner = 0; corner < 3; ++corner) {
    text += ", " + corner_vector(plan, plan.border_offset + first, corner, words);
  }
  return text;
}

// Moves the position `p` along the normal `n`. On the border of a welded triangle, all triangles share the direction
// and the height.
std::string move(const EpiloguePlan& plan, const std::string& p, const std::string& n, TypeSet& mixed_types) {
  if (plan.border_offset < 0) return "  " + p + " = @displaced_position(" + p + ", " + n + ", @t);\n";
  mixed_types.insert("vec3");
  const std::string normals = of_corners(plan, 0, 3);
  const std::string normal =
      plan.traits().curves_normals
          ? "@pn_normal(@weights, @c0.position.xyz, @c1.position.xyz, @c2.position.xyz" + normals + ")"
          : "@mix(" + normals.substr(2) + ")";
  return "  if (@on_border(@weights)) " + p + " = @displaced_position(" + p + ", " + normal +
         ", @border_coordinate(@weights" + of_corners(plan, 3, 2) + of_corners(plan, 5, 4) + "));\n" +  //
         "  else " + p + " = @displaced_position(" + p + ", " + n + ", @t);\n";
}

// Declares @slopes: the slopes of the surface before displacement.
std::string find_slopes(const EpiloguePlan& plan) {
  const std::string corners = "(@weights, @c0, @c1, @c2);\n";
  if (plan.traits().takes_tags) return "  @Slopes @slopes = @curved_slopes" + corners;
  std::string linear = "  @Slopes @slopes = @linear_slopes" + corners;
  if (!plan.curved()) return linear;
  return linear + "  @" + std::string(plan.traits().word) + "_slopes" + patch_arguments(plan) +
         ", @slopes.position_u, @slopes.position_v);\n";
}

}  // namespace

std::string displacement_uniforms(const EpiloguePlan& plan) {
  const std::string precision = plan.version.es ? "highp " : "";
  return "uniform " + precision + "sampler2D " + height_map_uniform + ";\nuniform vec4 " + height_channel_uniform +
         ";\nuniform vec2 " + height_range_uniform + ";\n" + texel_functions(plan.version);
}

std::string displace(const EpiloguePlan& plan, TypeSet& mixed_types) {
  const InputVariable& position = *position_of(plan);
  const InputVariable& normal = *normal_of(plan);
  mixed_types.insert("vec2");
  std::string text = plan.traits().takes_tags ? std::string() : tagged_corners(plan);
  for (int corner = 0; corner < 3; ++corner) {
    text += "  vec2 @t" + std::to_string(corner) + " = " + resized(plan, *plan.coordinate, corner, 2) + ";\n";
  }
  const std::string p = position.global + (position.type->rows == 4 ? ".xyz" : "");
  const std::string n = normal.global + (normal.type->rows == 4 ? ".xyz" : "");
  return text + "  vec2 @t = @mix(@t0, @t1, @t2);\n" + find_slopes(plan) + move(plan, p, n, mixed_types) + "  " +  //
         n + " = @displaced_normal(@slopes, " + n + ", @t, @t1 - @t0, @t2 - @t0);\n";
}

}  // namespace glark::refine
