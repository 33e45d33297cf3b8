// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <map>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

struct BuiltInOutput {
  std::string_view name;
  std::string_view type;
  int default_size = 0;  // size of an array without a known size
  bool color = false;
};
constexpr BuiltInOutput built_in_outputs[] = {
    {"gl_Position", "vec4"},
    {"gl_PointSize", "float"},
    {"gl_ClipVertex", "vec4"},
    {"gl_FogFragCoord", "float"},
    {"gl_FrontColor", "vec4", 0, true},
    {"gl_BackColor", "vec4", 0, true},
    {"gl_FrontSecondaryColor", "vec4", 0, true},
    {"gl_BackSecondaryColor", "vec4", 0, true},
    {"gl_TexCoord", "vec4", 8},
    {"gl_ClipDistance", "float", 8},
    {"gl_CullDistance", "float", 8},
    {"gl_Layer", "int"},
    {"gl_ViewportIndex", "int"},
};

const BuiltInOutput* built_in_output(std::string_view name) {
  const auto* const found = std::find_if(std::begin(built_in_outputs), std::end(built_in_outputs),
                                         [&](const BuiltInOutput& output) { return output.name == name; });
  return found == std::end(built_in_outputs) ? nullptr : found;
}

// The value of a plain integer literal, or -1.
int literal(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \n\t"), text.size());
  const std::size_t end = text.find_last_not_of(" \n\tuU") + 1;
  int value = -1;
  if (begin >= end) return -1;
  const auto result = std::from_chars(text.data() + begin, text.data() + end, value);
  return result.ec == std::errc() && result.ptr == text.data() + end && value >= 0 ? value : -1;
}

// An array declared without a size has the size that its largest index implies. The index must be constant. 0 if no
// literal index is found.
int implied_size(const std::vector<VertexUnit>& units, std::string_view name) {
  int size = 0;
  for (const VertexUnit& unit : units) {
    for (std::size_t i = 0; i + 3 < unit.tokens.size(); ++i) {
      if (!unit.tokens[i].is(name) || !unit.tokens[i + 1].is("[") || unit.tokens[i + 2].is("]")) continue;
      const int index = unit.tokens[i + 3].is("]") ? literal(unit.tokens[i + 2].text) : -1;
      if (index < 0) return 0;
      size = std::max(size, index + 1);
    }
  }
  return size;
}

class Collector {
 public:
  Collector(const std::vector<VertexUnit>& units, const OutputRules& rules) : units_(units), rules_(rules) {
    for (const VertexUnit& unit : units) {
      for (const Token& token : unit.tokens) {
        if (token.kind == TokenKind::identifier) ++occurrences_[token.text];
      }
    }
  }

  std::vector<OutputVariable> collect(std::size_t main_unit) {
    for (std::size_t unit = 0; unit < units_.size(); ++unit) {
      for (const Declaration& declaration : units_[unit].interface.declarations) {
        if (declaration.storage != Storage::output) continue;
        declaration.is_block ? add_block(unit, declaration) : add_variables(unit, declaration.variables);
      }
    }
    for (const BuiltInOutput& output : built_in_outputs) {
      if (!occurrences_.contains(std::string(output.name))) continue;
      Variable variable;
      variable.name = output.name;
      variable.type = output.type;
      if (output.default_size != 0) variable.sizes.emplace_back();
      add(main_unit, variable, "");
    }
    return std::move(outputs_);
  }

 private:
  void add_variables(std::size_t unit, const std::vector<Variable>& variables) {
    for (const Variable& variable : variables) add(unit, variable, "");
  }

  void add_block(std::size_t unit, const Declaration& block) {
    if (block.variables.empty()) {
      for (const Variable& member : block.members) {
        // A member of gl_PerVertex is written only if the stage mentions it elsewhere.
        if (!member.name.starts_with("gl_") || occurrences_[member.name] > 1) add(unit, member, "");
      }
      return;
    }
    const Variable& instance = block.variables.front();
    if (instance.sizes.empty()) {
      for (const Variable& member : block.members) add(unit, member, instance.name + ".");
      return;
    }
    const int count = instance.sizes.size() == 1 ? literal(instance.sizes.front()) : -1;
    for (int i = 0; i < std::max(count, 1); ++i) {
      for (const Variable& member : block.members) add(unit, member, instance.name + "[" + std::to_string(i) + "].");
    }
    if (count < 0)
      outputs_.back().problem = "output block array '" + instance.name + "' has a size that is no plain number";
  }

  void add(std::size_t unit, const Variable& variable, const std::string& instance) {
    OutputVariable output;
    output.unit = unit;
    output.path = instance + variable.name;
    if (!names_.insert(output.path).second) return;
    output.type = variable.type;
    output.sizes = variable.sizes;
    output.flat = variable.flat && !rules_.positions.contains(variable.name);
    output.noperspective = variable.noperspective;
    output.unsound = is_unsound(without_indices(output.path));
    const BuiltInOutput* const built_in = built_in_output(variable.name);
    if (built_in != nullptr && built_in->color) {
      output.by_shade_model = !variable.smooth && !variable.noperspective;
      output.flat = output.flat || (output.by_shade_model && rules_.flat_colors);
      output.clamped = rules_.clamp_colors;
    }
    for (std::string& size : output.sizes) {
      if (size.find_first_not_of(" \n\t") != std::string::npos) continue;
      int implied = implied_size(units_, variable.name);
      if (implied == 0 && built_in != nullptr) implied = built_in->default_size;
      if (implied == 0) output.problem = "output array '" + output.path + "' has no size; declare it with one";
      size = std::to_string(implied);
    }
    if (!output.sizes.empty() && implied_size(units_, variable.name) == 0) {
      const NumericType* const numeric = numeric_type(std::string_view(output.type));
      output.indexed_words = numeric != nullptr ? numeric->words() : 4;
      for (const std::string& size : output.sizes) output.indexed_words *= std::max(literal(size), 1);
    }
    outputs_.push_back(std::move(output));
  }

  // A structure is interpolated as a whole.
  bool is_unsound(const std::string& path) const {
    return std::any_of(rules_.unsound.begin(), rules_.unsound.end(),
                       [&](const std::string& unsound) { return unsound == path || unsound.starts_with(path + "."); });
  }

  const std::vector<VertexUnit>& units_;
  const OutputRules rules_;
  std::map<std::string, int> occurrences_;
  std::set<std::string> names_;
  std::vector<OutputVariable> outputs_;
};

const Structure* find_structure(const std::vector<Structure>& structures, const std::string& name) {
  const auto found =
      std::find_if(structures.begin(), structures.end(), [&](const Structure& s) { return s.name == name; });
  return found == structures.end() ? nullptr : &*found;
}

bool type_interpolates(const std::string& type, const std::vector<Structure>& structures) {
  if (const NumericType* const numeric = numeric_type(std::string_view(type))) return numeric->interpolates();
  const Structure* const structure = find_structure(structures, type);
  return structure == nullptr ||
         std::any_of(structure->members.begin(), structure->members.end(),
                     [&](const Variable& member) { return type_interpolates(member.type, structures); });
}

bool type_has_integers(const std::string& type, const std::vector<Structure>& structures) {
  if (const NumericType* const numeric = numeric_type(std::string_view(type))) return !numeric->interpolates();
  const Structure* const structure = find_structure(structures, type);
  return structure != nullptr &&
         std::any_of(structure->members.begin(), structure->members.end(),
                     [&](const Variable& member) { return type_has_integers(member.type, structures); });
}

// A statement over the same element of several variables.
using Paths = std::vector<std::string>;

class Statements {
 public:
  Statements(const EpiloguePlan& plan, TypeSet& mixed_types) : plan_(plan), mixed_types_(mixed_types) {}

  // paths[0] = paths[1], element by element: GLSL 1.10 and ES 1.00 do not assign arrays.
  std::string copy(const std::vector<std::string>& sizes, const Paths& paths) {
    return for_elements(sizes, 0, paths,
                        [](const Paths& element) { return "  " + element[0] + " = " + element[1] + ";\n"; });
  }

  // paths[0] = the greatest of paths[1..3]: a triangle is culled if all its corners are below 0 (OpenGL 4.5, 13.5).
  std::string greatest(const std::vector<std::string>& sizes, const Paths& paths) {
    return for_elements(sizes, 0, paths, [](const Paths& element) {
      return "  " + element[0] + " = max(" + element[1] + ", max(" + element[2] + ", " + element[3] + "));\n";
    });
  }

  // paths[0] = the interpolation of paths[1..3]
  std::string interpolate(const std::string& type, const std::vector<std::string>& sizes, const Paths& paths) {
    return for_elements(sizes, 0, paths, [&](const Paths& element) { return interpolate_element(type, element); });
  }

  // clear: paths[0] = 0. add: paths[0] += share * paths[1]. take: paths[1] = paths[0]. Skips what is not
  // floating-point.
  enum class Portion { clear, add, take };
  std::string portion(Portion kind, const std::string& type, const std::vector<std::string>& sizes,
                      const Paths& paths) {
    return for_elements(sizes, 0, paths, [&](const Paths& element) { return portion_of_element(kind, type, element); });
  }

 private:
  std::string portion_of_element(Portion kind, const std::string& type, const Paths& paths) {
    const NumericType* const numeric = numeric_type(std::string_view(type));
    if (numeric != nullptr && numeric->interpolates()) {
      mixed_types_.insert(std::string(numeric->name));
      if (kind == Portion::clear) return "  " + paths[0] + " = " + type + "(0.0);\n";
      if (kind == Portion::take) return "  " + paths[1] + " = " + paths[0] + ";\n";
      return "  " + paths[0] + " = @add(" + paths[0] + ", " + paths[1] + ", share);\n";
    }
    const Structure* const structure = find_structure(plan_.structures, type);
    if (structure == nullptr) return {};
    std::string text;
    for (const Variable& member : structure->members) {
      Paths members = paths;
      for (std::string& path : members) path += "." + member.name;
      text += portion(kind, member.type, member.sizes, members);
    }
    return text;
  }

  template <typename Leaf>
  std::string for_elements(const std::vector<std::string>& sizes, std::size_t dimension, const Paths& paths,
                           const Leaf& leaf) {
    if (dimension == sizes.size()) return leaf(paths);
    const int count = literal(sizes[dimension]);
    std::string text;
    // Arrays of implied size may be indexed by constants only, so short ones are unrolled.
    if (count >= 0 && count <= 16) {
      for (int i = 0; i < count; ++i)
        text += for_elements(sizes, dimension + 1, indexed(paths, std::to_string(i)), leaf);
      return text;
    }
    const std::string index = "@i" + std::to_string(loops_++);
    // Backwards: Mesa 25 takes a loop in order for a copy of the whole array, and then reads the original where it has
    // changed.
    text = "  for (int " + index + " = int(" + sizes[dimension] + ") - 1; " + index + " >= 0; --" + index + ") {\n";
    text += for_elements(sizes, dimension + 1, indexed(paths, index), leaf);
    return text + "  }\n";
  }

  static Paths indexed(Paths paths, const std::string& index) {
    for (std::string& path : paths) path += "[" + index + "]";
    return paths;
  }

  std::string interpolate_element(const std::string& type, const Paths& paths) {
    const NumericType* const numeric = numeric_type(std::string_view(type));
    if (numeric != nullptr && numeric->interpolates()) {
      mixed_types_.insert(std::string(numeric->name));
      const std::string mixed = "@mix(" + paths[1] + ", " + paths[2] + ", " + paths[3] + ")";
      if (paths[0] == "gl_Position") return "  " + paths[0] + " = " + mixed + ";\n";
      // Values that agree at all corners stay the same to the last bit: fragment shaders may compare them.
      return "  " + paths[0] + " = " + paths[1] + " == " + paths[2] + " && " + paths[1] + " == " + paths[3] + " ? " +
             paths[1] + " : " + mixed + ";\n";
    }
    const Structure* const structure = find_structure(plan_.structures, type);
    if (structure == nullptr) return "  " + paths[0] + " = " + paths[1 + plan_.provoking_corner] + ";\n";
    std::string text;
    for (const Variable& member : structure->members) {
      Paths members = paths;
      for (std::string& path : members) path += "." + member.name;
      text += interpolate(member.type, member.sizes, members);
    }
    return text;
  }

  const EpiloguePlan& plan_;
  TypeSet& mixed_types_;
  int loops_ = 0;
};

std::string declaration(const OutputVariable& output, const std::string& name) {
  std::string text = output.type + " " + name;
  for (const std::string& size : output.sizes) text += "[" + size + "]";
  return text + ";\n";
}

}  // namespace

std::vector<OutputVariable> collect_outputs(const std::vector<VertexUnit>& units, std::size_t main_unit,
                                            const OutputRules& rules) {
  return Collector(units, rules).collect(main_unit);
}

std::string without_indices(std::string path) {
  const std::size_t begin = path.find('[');
  if (begin != std::string::npos) path.erase(begin, path.find(']') - begin + 1);
  return path;
}

bool is_flat(const OutputVariable& output, const std::vector<Structure>& structures) {
  return output.flat || !type_interpolates(output.type, structures);
}

bool has_integers(const OutputVariable& output, const std::vector<Structure>& structures) {
  return type_has_integers(output.type, structures);
}

bool unit_has_outputs(const EpiloguePlan& plan, std::size_t unit) {
  return std::any_of(plan.outputs.begin(), plan.outputs.end(),
                     [&](const OutputVariable& output) { return output.unit == unit; });
}

bool unit_has_screen_outputs(const EpiloguePlan& plan, std::size_t unit) {
  return plan.runs_at_corners() &&
         std::any_of(plan.outputs.begin(), plan.outputs.end(), [&](const OutputVariable& output) {
           return output.unit == unit && output.noperspective && !is_flat(output, plan.structures);
         });
}

bool EpiloguePlan::runs_at_corners() const {
  return interpolates_outputs() ||
         std::any_of(outputs.begin(), outputs.end(), [](const OutputVariable& output) { return output.unsound; });
}

bool EpiloguePlan::has_screen_outputs() const {
  for (std::size_t unit = 0; unit < resets.size(); ++unit) {
    if (unit_has_screen_outputs(*this, unit)) return true;
  }
  return false;
}

std::string morph_functions(const EpiloguePlan& plan, std::size_t unit, TypeSet& added_types) {
  if (!unit_has_morphed_outputs(plan, unit)) return {};
  using Portion = Statements::Portion;
  Statements statements(plan, added_types);
  std::string variables;
  std::string begin;
  std::string gather;
  std::string settle;
  for (std::size_t i = 0; i < plan.morphed.size(); ++i) {
    const OutputVariable& output = plan.morphed[i];
    if (output.unit != unit) continue;
    const std::string sum = "@sum_" + std::to_string(i);
    const std::string value = output.clamped ? "clamp(" + output.path + ", 0.0, 1.0)" : output.path;
    variables += declaration(output, sum);
    begin += statements.portion(Portion::clear, output.type, output.sizes, {sum});
    gather += statements.portion(Portion::add, output.type, output.sizes, {sum, value});
    settle += statements.portion(Portion::take, output.type, output.sizes, {sum, output.path});
  }
  const std::string suffix = "_" + std::to_string(unit);
  return variables + "void @begin" + suffix + "() {\n" + begin + "}\nvoid @gather" + suffix + "(float share) {\n" +
         gather + "}\nvoid @settle" + suffix + "() {\n" + settle + "}\n";
}

// If some outputs are interpolated, there are three slots, one per corner. Otherwise slot 0 holds the flat outputs of
// the provoking corner.
std::string output_functions(const EpiloguePlan& plan, std::size_t unit, TypeSet& mixed_types) {
  if (!unit_has_outputs(plan, unit)) return {};
  const bool interpolated = plan.runs_at_corners();
  Statements statements(plan, mixed_types);
  std::string variables;
  std::string saves[3];
  std::string finish;
  std::string finish_screen;
  for (std::size_t i = 0; i < plan.outputs.size(); ++i) {
    const OutputVariable& output = plan.outputs[i];
    if (output.unit != unit) continue;
    const bool copied = !interpolated || is_flat(output, plan.structures);
    Paths paths = {output.path};
    for (int slot = 0; slot < (interpolated ? 3 : 1); ++slot) {
      const std::string saved = "@saved" + std::to_string(slot) + "_" + std::to_string(i);
      paths.push_back(saved);
      if (interpolated && copied && slot != plan.provoking_corner) continue;
      variables += declaration(output, saved);
      const std::string& written = output.written.empty() ? output.path : output.written;
      saves[slot] += output.clamped ? "  " + saved + " = clamp(" + written + ", 0.0, 1.0);\n"
                                    : statements.copy(output.sizes, {saved, written});
    }
    const std::string& source = paths[interpolated ? 1 + plan.provoking_corner : 1];
    if (copied) {
      finish += statements.copy(output.sizes, {output.path, source});
    } else if (output.path == "gl_CullDistance") {
      finish += statements.greatest(output.sizes, paths);
    } else {
      (output.noperspective ? finish_screen : finish) += statements.interpolate(output.type, output.sizes, paths);
    }
  }
  const std::string suffix = "_" + std::to_string(unit);
  std::string text = variables;
  for (int slot = 0; slot < (interpolated ? 3 : 1); ++slot) {
    text += "void @save" + std::to_string(slot) + suffix + "() {\n" + saves[slot] + "}\n";
  }
  text += "void @finish" + suffix + "() {\n" + finish + "}\n";
  if (finish_screen.empty()) return text;
  return text + "void @finish_screen" + suffix + "() {\n" + finish_screen + "}\n";
}

}  // namespace glark::refine
