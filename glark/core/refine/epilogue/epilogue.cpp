// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/epilogue/epilogue.h"

#include <algorithm>

namespace glark::refine {
namespace {

// The built-in refinement of the inputs and the runs of the application's main.
class MainText {
 public:
  explicit MainText(const EpiloguePlan& plan) : plan_(plan) {}

  std::string text() {
    if (plan_.at_corner) return "void main() {\n" + fill_from_corner(plan_, 0) + run() + "}\n";
    std::string main = "void main() {\n  @place();\n";
    if (plan_.stored) main += "  @find_record();\n";
    main += run_at_corners();
    const std::string end = finish() + "}\n";
    if (plan_.interpolates_outputs()) return main + end;
    std::string evaluate = "  @interpolate();\n";
    if (!plan_.refinement_source.empty()) evaluate += "  @fill_corners();\n  @refine();\n";
    evaluate += run();
    if (!plan_.morphing) return main + evaluate + end;
    return "void @evaluate() {\n" + evaluate + "}\n" + main + run_between_parents(plan_) + end;
  }

 private:
  // Saves the outputs that are interpolated or flat.
  std::string run_at_corners() const {
    if (plan_.outputs.empty()) return {};
    if (!plan_.runs_at_corners()) {
      return fill_from_corner(plan_, plan_.provoking_corner) + run() + for_output_units("save0");
    }
    std::string text;
    for (int corner = 0; corner < 3; ++corner) {
      text += fill_from_corner(plan_, corner) + run() + for_output_units("save" + std::to_string(corner));
      if (plan_.has_screen_outputs()) text += "  @corner_w[" + std::to_string(corner) + "] = gl_Position.w;\n";
    }
    return text;
  }

  std::string finish() const {
    const std::string text = for_output_units("finish");
    return plan_.has_screen_outputs() ? text + "  @weigh_by_w();\n" + finish_screen_outputs() : text;
  }

  std::string run() const {
    std::string text;
    for (std::size_t unit = 0; unit < plan_.resets.size(); ++unit) {
      if (plan_.resets[unit]) text += "  @reset_" + std::to_string(unit) + "();\n";
    }
    return text + "  @application_main();\n";
  }

  std::string for_output_units(const std::string& function) const {
    std::string text;
    for (std::size_t unit = 0; unit < plan_.resets.size(); ++unit) {
      if (unit_has_outputs(plan_, unit)) text += "  @" + function + "_" + std::to_string(unit) + "();\n";
    }
    return text;
  }

  std::string finish_screen_outputs() const {
    std::string text;
    for (std::size_t unit = 0; unit < plan_.resets.size(); ++unit) {
      if (unit_has_screen_outputs(plan_, unit)) text += "  @finish_screen_" + std::to_string(unit) + "();\n";
    }
    return text;
  }

  const EpiloguePlan& plan_;
};

std::string prototypes_of_other_units(const EpiloguePlan& plan) {
  std::string text;
  for (std::size_t unit = 0; unit < plan.resets.size(); ++unit) {
    if (unit == plan.main_unit) continue;
    const std::string suffix = "_" + std::to_string(unit) + "();\n";
    if (plan.resets[unit]) text += "void @reset" + suffix;
    text += prototypes_of_morphed_unit(plan, unit);
    if (!unit_has_outputs(plan, unit)) continue;
    const int slots = plan.runs_at_corners() ? 3 : 1;
    for (int slot = 0; slot < slots; ++slot) text += "void @save" + std::to_string(slot) + suffix;
    text += "void @finish" + suffix;
    if (unit_has_screen_outputs(plan, unit)) text += "void @finish_screen" + suffix;
  }
  return text;
}

// Barycentrics of the refined vertex, from the lattice and the placement of its piece. All values are dyadic, so they
// are exact.
constexpr const char* place_function = R"(vec3 @weights;
void @place() {
  vec2 lattice = glark_lattice * 0.000030517578125;
  vec3 local = vec3((1.0 - lattice.x) - lattice.y, lattice);
  vec2 tile = glark_patch.w < 0.5 ? local.yz : (glark_patch.w < 1.5 ? local.xy : local.zx);
  vec2 uv = glark_patch.xy + glark_patch.z * tile;
  @weights = vec3((1.0 - uv.x) - uv.y, uv);
}
)";

// The same for a piece that covers the whole triangle.
constexpr const char* cover_function = R"(vec3 @weights;
void @place() {
  vec2 lattice = glark_lattice * 0.000030517578125;
  @weights = vec3((1.0 - lattice.x) - lattice.y, lattice);
}
)";

// Converts barycentrics of the triangle in clip space to those of its image on the screen, for `noperspective` outputs.
// The sums pair as in @mix.
constexpr const char* screen_function = R"(vec3 @corner_w;
void @weigh_by_w() {
  @precise vec3 scaled = @weights * @corner_w;
  @precise float sum = (scaled.x + scaled.y) + scaled.z;
  if (sum != 0.0) @weights = scaled / sum;
}
)";

// Variables that the application's refinement shader reads besides the inputs. The corners of an array A of n elements
// are flattened: element i of corner k is ark_corner_A[k * n + i].
std::string refinement_declarations(const EpiloguePlan& plan) {
  std::string text = "vec3 ark_barycentric;\n";
  std::string fill = "void @fill_corners() {\n  ark_barycentric = @weights;\n";
  for (const InputVariable& input : plan.inputs) {
    const std::string name = "ark_corner_" + input.field.name;
    if (!plan.refinement_identifiers.contains(name)) continue;
    const int elements = input.field.array_size;
    text += std::string(input.type->name) + " " + name + "[" + std::to_string(3 * elements) + "];\n";
    for (int i = 0; i < 3 * elements; ++i) {
      fill += "  " + name + "[" + std::to_string(i) +
              "] = " + corner_expression(plan, input, i % elements, i / elements) + ";\n";
    }
  }
  return text + fill + "}\n";
}

std::string interpolate_function(const EpiloguePlan& plan, TypeSet& mixed_types) {
  std::string text = "void @interpolate() {\n" + fill_by_interpolation(plan, mixed_types);
  if (plan.curved()) text += fill_from_surface(plan, mixed_types);
  if (plan.displaced()) text += displace(plan, mixed_types);
  return text + "}\n";
}

bool uses_integers(const EpiloguePlan& plan) {
  return std::any_of(plan.inputs.begin(), plan.inputs.end(),
                     [](const InputVariable& input) { return input.type->scalar != Scalar::float32; });
}

std::string enable_where_present(const std::string& extension) {
  return "#ifdef " + extension + "\n#extension " + extension + " : enable\n#endif\n";
}

std::string storage_extensions(const EpiloguePlan& plan) {
  const GlslVersion& version = plan.version;
  if (version.es) return {};
  return (plan.at_points && version.number < 130 ? enable_where_present("GL_EXT_gpu_shader4") : "") +
         (version.number < 140
              ? enable_where_present("GL_ARB_draw_instanced") + enable_where_present("GL_ARB_uniform_buffer_object")
              : "") +
         (version.number < 430 ? enable_where_present("GL_ARB_shader_storage_buffer_object") : "") +
         enable_where_present("GL_ARB_shader_draw_parameters");
}

}  // namespace

// `precise` is a keyword from GLSL 4.00 and ES 3.20 on. Earlier versions need an extension, which is not used if the
// application uses the words that the extension reserves.
std::string epilogue_header(const EpiloguePlan& plan, const IdentifierSet& application_identifiers) {
  const GlslVersion& version = plan.version;
  std::string text;
  if (uses_integers(plan) && !version.at_least(330, 300)) text += enable_where_present("GL_ARB_shader_bit_encoding");
  if (plan.stored) text += storage_extensions(plan);
  if (plan.displaced() && !version.at_least(130, 300)) text += enable_where_present("GL_EXT_gpu_shader4");
  if (version.at_least(400, 320)) return text + "#define @precise precise\n";
  const bool words_are_free =
      !application_identifiers.contains("precise") && !application_identifiers.contains("sample");
  if (!words_are_free || !version.at_least(110, 310)) return text + "#define @precise\n";
  const std::string extension = version.es ? "GL_EXT_gpu_shader5" : "GL_ARB_gpu_shader5";
  return text + "#ifdef " + extension + "\n#extension " + extension + " : enable\n#define @precise precise\n" +
         "#else\n#define @precise\n#endif\n";
}

MainEpilogue main_epilogue(const EpiloguePlan& plan, const std::string& declarations_of_inputs) {
  TypeSet mixed_types;
  TypeSet added_types;
  std::string functions = output_functions(plan, plan.main_unit, mixed_types);
  functions += morph_functions(plan, plan.main_unit, added_types);
  if (!plan.interpolates_outputs() && !plan.at_corner) functions += interpolate_function(plan, mixed_types);
  for (std::size_t unit = 0; unit < plan.resets.size(); ++unit) {
    if (unit == plan.main_unit) continue;
    output_functions(plan, unit, mixed_types);  // for the types that it mixes
    morph_functions(plan, unit, added_types);
  }
  MainEpilogue epilogue;
  std::string& text = epilogue.declarations;
  text = "\n";
  if (plan.version.es) text += "precision highp float;\nprecision highp int;\n";
  text += chunk_declarations(plan) + declarations_of_inputs + prototypes_of_other_units(plan);
  if (!plan.at_corner) text += plan.morphing ? morph_place_function() : plan.placed ? place_function : cover_function;
  if (plan.has_screen_outputs()) text += screen_function;
  text += mix_functions(mixed_types, true) + add_functions(added_types, true);
  if (plan.displaced()) text += displacement_uniforms(plan);
  if (plan.curved() || plan.displaced()) text += surface_functions(plan);
  text += functions;
  if (!plan.refinement_source.empty()) text += refinement_declarations(plan);
  epilogue.main = MainText(plan).text();
  return epilogue;
}

std::string unit_epilogue(const EpiloguePlan& plan, std::size_t unit) {
  if (!unit_has_outputs(plan, unit) && !unit_has_morphed_outputs(plan, unit)) return {};
  TypeSet mixed_types;
  TypeSet added_types;
  const std::string functions = output_functions(plan, unit, mixed_types) + morph_functions(plan, unit, added_types);
  return "\n" + mix_functions(mixed_types, false) + add_functions(added_types, false) + functions;
}

}  // namespace glark::refine
