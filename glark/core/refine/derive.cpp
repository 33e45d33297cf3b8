// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/derive.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "glark/core/refine/epilogue/epilogue.h"
#include "glark/core/refine/refinement_check.h"
#include "glark/core/refine/refinement_source.h"

namespace glark::refine {
namespace {

std::string with_prefix(const std::string& text, const std::string& prefix) {
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    if (c == '@') {
      result += prefix;
    } else {
      result += c;
    }
  }
  return result;
}

class Deriver {
 public:
  explicit Deriver(const DeriveRequest& request) : request_(request) {}

  Derivation derive() {
    Derivation result;
    if (read() && plan()) {
      write();
      for (const VertexUnit& unit : units_) result.vertex_sources.push_back(to_text(unit.tokens));
      result.ok = true;
      result.corner_outputs = !plan_.outputs.empty();
    } else {
      result.error = error_;
    }
    result.prefix = prefix_;
    return result;
  }

 private:
  // A compiler turns each non-constant index into a choice among all elements, here for three corners. That takes
  // minutes.
  static constexpr int most_indexed_words = 48;

  bool read() {
    if (!read_units(request_.vertex_sources, request_.es, request_.extensions, units_, error_)) return false;
    plan_.main_unit = find_main_unit(units_);
    if (plan_.main_unit == units_.size()) {
      error_ = "no vertex shader defines main()";
      return false;
    }
    for (const VertexUnit& unit : units_) collect_identifiers(unit.tokens, application_identifiers_);
    refinement_tokens_ = tokenize(request_.refinement_source);
    all_identifiers_ = application_identifiers_;
    collect_identifiers(refinement_tokens_, all_identifiers_);
    for (const Token& token : refinement_tokens_) {  // macros may use inputs that nothing else mentions
      if (token.kind == TokenKind::directive) collect_identifiers(tokenize(token.text.substr(1)), all_identifiers_);
    }
    // Displacement and curves read a normal, even if the stage does not.
    if (request_.coordinate_field >= 0 || core::traits_of(request_.refinement).curves_positions) {
      for (const capture::Field& field : request_.layout.fields) {
        if (field.role == capture::Role::normal) all_identifiers_.insert(field.name);
      }
    }
    prefix_ = free_prefix(all_identifiers_);
    return resolve_collisions();
  }

  // The application may use names that the contract fixes. Its variable gets another name, unless the API can see it.
  bool resolve_collisions() {
    IdentifierSet fixed = {lattice_input,      patch_input,         records_block,          words_member,
                           first_word_uniform, height_map_uniform,  height_channel_uniform, height_range_uniform,
                           instance_input,     shape_number_uniform};
    for (int i = 0; i < request_.layout.chunk_count(); ++i) fixed.insert(chunk_input_prefix + std::to_string(i));
    for (const std::string& name : application_identifiers_) {
      const bool ours =
          !request_.refinement_source.empty() && (name == "ark_barycentric" || name.starts_with("ark_corner_"));
      if (!ours && !fixed.contains(name)) continue;
      if (is_visible_to_api(name)) {
        error_ = fmt::format("'{}' is a name that glark needs; rename this uniform, output or block", name);
        return false;
      }
      new_names_.of[name] = prefix_ + "application_" + name;
    }
    return true;
  }

  bool is_visible_to_api(const std::string& name) const {
    const auto named = [&](const Variable& variable) { return variable.name == name; };
    for (const VertexUnit& unit : units_) {
      for (const Declaration& d : unit.interface.declarations) {
        if (d.storage != Storage::uniform && d.storage != Storage::output && d.storage != Storage::buffer) continue;
        if (d.block_name == name || std::any_of(d.variables.begin(), d.variables.end(), named) ||
            std::any_of(d.members.begin(), d.members.end(), named)) {
          return true;
        }
      }
    }
    return false;
  }

  bool plan() {
    plan_.version = units_[plan_.main_unit].interface.version;
    plan_.provoking_corner = std::clamp(request_.provoking_corner, 0, 2);
    plan_.corner_words = request_.layout.corner_words;
    plan_.control_offset = request_.layout.control_offset;
    plan_.creased = request_.creased;
    plan_.border_offset = request_.layout.border_offset;
    plan_.placed = request_.placed;
    plan_.stored = request_.stored;
    plan_.at_corner = request_.at_corner;
    plan_.at_points = request_.at_points;
    plan_.chunk_count = plan_.at_corner ? request_.layout.corner_chunk_count() : request_.layout.chunk_count();
    for (const VertexUnit& unit : units_) {
      plan_.structures.insert(plan_.structures.end(), unit.interface.structures.begin(),
                              unit.interface.structures.end());
    }
    if (!plan_inputs()) return false;
    if (plan_.at_corner) {
      plan_resets();
      return true;
    }
    if (!request_.refinement_source.empty()) {
      error_ = find_mistake(refinement_tokens_, {request_.layout.fields, names_of_outputs(), request_.es});
      if (!error_.empty()) return false;
    }
    plan_refinement();
    plan_.outputs = collect_outputs(units_, plan_.main_unit, request_.outputs);
    if (plan_.at_points) {
      std::erase_if(plan_.outputs, [](const OutputVariable& output) { return output.path != "gl_Position"; });
    }
    plan_morphing();
    if (!plan_.interpolates_outputs()) {
      std::erase_if(plan_.outputs, [&](const OutputVariable& output) {
        return !output.unsound && !is_flat(output, plan_.structures);
      });
    }
    if (!can_interpolate_outputs()) return false;
    plan_resets();
    return true;
  }

  // False: error_ says which output cannot be interpolated.
  bool can_interpolate_outputs() {
    int indexed_words = 0;
    for (const OutputVariable& output : plan_.outputs) {
      indexed_words += output.indexed_words;
      if (plan_.runs_at_corners() && indexed_words > most_indexed_words) {
        error_ =
            fmt::format("output array '{}' is too large to be interpolated: its index is not constant", output.path);
        return false;
      }
      if (output.problem.empty()) continue;
      error_ = output.problem;
      return false;
    }
    return true;
  }

  std::set<std::string> names_of_outputs() const {
    std::set<std::string> names;
    for (const Declaration& declaration : units_[plan_.main_unit].interface.declarations)
      if (declaration.storage == Storage::output)
        for (const Variable& variable : declaration.variables) names.insert(variable.name);
    return names;
  }

  // Geomorphing leaves outputs that vary linearly as they are, because it would not change them. It also leaves
  // outputs that cannot be saved.
  void plan_morphing() {
    plan_.morphing = request_.morphing;
    if (!plan_.morphing || plan_.interpolates_outputs()) return;
    plan_.morphed = plan_.outputs;
    std::erase_if(plan_.morphed, [&](const OutputVariable& output) {
      return output.unsound || is_flat(output, plan_.structures) || !output.problem.empty() ||
             output.indexed_words > most_indexed_words;
    });
  }

  bool plan_inputs() {
    for (const capture::Field& field : request_.layout.fields) {
      InputVariable input;
      input.field = field;
      input.type = numeric_type(field.type);
      if (input.type == nullptr) {
        error_ = fmt::format("vertex input '{}' has a type that cannot be refined", field.name);
        return false;
      }
      const BuiltInInput* const built_in = built_in_input(field.name);
      const auto index = static_cast<int>(&field - request_.layout.fields.data());
      if (index == request_.discontinuity_field) plan_.discontinuity = input;
      if (index == request_.scalar_tag_field) plan_.scalar_tags = input;
      if (index == request_.coordinate_field) plan_.coordinate = input;
      if (!is_mentioned(field.name)) continue;
      input.global = built_in != nullptr ? global_name("@", *built_in) : new_names_(field.name);
      plan_.inputs.push_back(std::move(input));
    }
    return true;
  }

  // Returns whether the text mentions the field, by its name or by another name of the same built-in.
  bool is_mentioned(const std::string& field) const {
    if (all_identifiers_.contains(field)) return true;
    return std::any_of(all_identifiers_.begin(), all_identifiers_.end(), [&](const std::string& identifier) {
      const BuiltInInput* const built_in = built_in_input(identifier);
      return built_in != nullptr && built_in->field == field;
    });
  }

  void plan_refinement() {
    plan_.refinement = request_.refinement;
    plan_.constant_tags = request_.scalar_tags;
    const bool own = !request_.refinement_source.empty();
    // The application's refinement shader places inputs, so it has nothing to do between outputs.
    if (own && plan_.interpolates_outputs()) plan_.refinement = core::Refinement::linear_inputs;
    if (plan_.curved() && (position_of(plan_) == nullptr || normal_of(plan_) == nullptr)) {
      plan_.refinement = core::Refinement::linear_inputs;
    }
    if (plan_.interpolates_outputs() || position_of(plan_) == nullptr || normal_of(plan_) == nullptr) {
      plan_.coordinate.reset();  // nothing to move, or no direction
    }
    if (plan_.displaced() && plan_.traits().displaced_as) {  // gives the same bits if vertices are untagged
      plan_.refinement = *plan_.traits().displaced_as;
      plan_.discontinuity.reset();
      plan_.scalar_tags.reset();
      plan_.constant_tags = {};
    }
    if (!own) return;
    drop_repeated_uniforms(refinement_tokens_, units_[plan_.main_unit].interface, request_.es);
    NewNames names = new_names_;
    std::erase_if(names.of, [](const auto& entry) { return entry.first.starts_with("ark_"); });
    RefinementSource source = prepare_refinement_source(refinement_tokens_, prefix_, names, plan_.version);
    plan_.refinement_source = std::move(source.text);
    refinement_extensions_ = std::move(source.extensions);
    plan_.refinement_identifiers = std::move(source.identifiers);
  }

  static bool may_need_reset(const Declaration& declaration, const Variable& variable) {
    const bool global = declaration.storage == Storage::none || declaration.storage == Storage::output;
    return global && variable.has_initializer() && !variable.type.empty();
  }

  // Globals keep their values from one run of main to the next. Their initialisers run before the inputs have values.
  void plan_resets() {
    const bool runs_again = !plan_.outputs.empty() || !plan_.morphed.empty() || plan_.interpolates_outputs();
    IdentifierSet varying;
    for (const VertexUnit& unit : units_) {
      for (const Declaration& declaration : unit.interface.declarations) {
        if (declaration.storage != Storage::input) continue;
        for (const Variable& variable : declaration.variables) varying.insert(variable.name);
      }
    }
    for (std::size_t u = 0; u < units_.size(); ++u) {
      const VertexUnit& unit = units_[u];
      resets_.emplace_back();
      idle_inputs_.emplace_back();
      for (const Declaration& declaration : unit.interface.declarations) {
        for (const Variable& variable : declaration.variables) {
          if (declaration.storage == Storage::input && !is_held(variable.name)) idle_inputs_[u].push_back(variable);
          if (!may_need_reset(declaration, variable)) continue;
          const bool depends = mentions_any(unit.tokens, variable, varying);
          if (depends) varying.insert(variable.name);
          if (depends || runs_again) resets_[u].push_back(variable);
        }
      }
      plan_.resets.push_back(!resets_[u].empty() || !idle_inputs_[u].empty());
    }
  }

  bool is_held(const std::string& input) const {
    const std::vector<capture::Field>& fields = request_.layout.fields;
    return std::any_of(fields.begin(), fields.end(), [&](const capture::Field& field) { return field.name == input; });
  }

  static bool mentions_any(const Tokens& tokens, const Variable& variable, const IdentifierSet& names) {
    for (std::size_t i = variable.initializer_begin; i < variable.initializer_end; ++i) {
      const std::string& text = tokens[i].text;
      if (names.contains(text) || text == "ftransform" || built_in_input(text) != nullptr) return true;
      // A call may read an input.
      if (tokens[i].kind == TokenKind::identifier && tokens[i + 1].is("(") &&
          numeric_type(std::string_view(text)) == nullptr)
        return true;
    }
    return false;
  }

  void write() {
    std::vector<std::string> declarations(units_.size());
    for (std::size_t u = 0; u < units_.size(); ++u) declarations[u] = built_in_declarations(u);
    const std::string declarations_in_main = missing_declarations_in_main();
    if (units_.size() == 1) declarations[0] += replace_indexed_outputs(units_[0], prefix_, plan_.outputs);
    for (VertexUnit& unit : units_) rewrite_unit(unit, prefix_, new_names_);
    for (std::size_t u = 0; u < units_.size(); ++u) {
      Tokens& tokens = units_[u].tokens;
      insert_declaration(tokens, with_prefix(declarations[u], prefix_));
      tokens.back().before += with_prefix(reset_function(u), prefix_);
      if (u != plan_.main_unit) tokens.back().before += with_prefix(unit_epilogue(plan_, u), prefix_);
    }
    const MainEpilogue epilogue = main_epilogue(plan_, declarations_in_main);
    Tokens& tokens = units_[plan_.main_unit].tokens;
    tokens.back().before +=
        with_prefix(epilogue.declarations, prefix_) + plan_.refinement_source + with_prefix(epilogue.main, prefix_);
    insert_after_version(tokens,
                         with_prefix(epilogue_header(plan_, all_identifiers_), prefix_) + refinement_extensions_);
  }

  // Globals for the built-in inputs that this unit mentions, or that its main fills.
  std::string built_in_declarations(std::size_t u) const {
    IdentifierSet mentioned;
    collect_identifiers(units_[u].tokens, mentioned);
    if (u == plan_.main_unit) mentioned = all_identifiers_;
    std::set<std::string> lines;
    for (const std::string& name : mentioned) {
      const BuiltInInput* const input = built_in_input(name);
      if (input == nullptr || is_declared(units_[u].interface, name)) continue;
      // The record lacks built-ins that are constant for the draw, or whose value does not matter. Any number will do.
      const bool captured = std::any_of(plan_.inputs.begin(), plan_.inputs.end(), [&](const InputVariable& variable) {
        return variable.field.name == input->field;
      });
      lines.insert(std::string(input->type) + " " + global_name("@", *input) +
                   (captured ? ";\n" : " = " + std::string(input->type) + "(0);\n"));
    }
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
  }

  static bool is_declared(const Interface& interface, const std::string& name) {
    for (const Declaration& declaration : interface.declarations) {
      for (const Variable& variable : declaration.variables) {
        if (variable.name == name) return true;
      }
    }
    return false;
  }

  std::string missing_declarations_in_main() const {
    std::string text;
    for (const InputVariable& input : plan_.inputs) {
      if (built_in_input(input.field.name) != nullptr ||
          is_declared(units_[plan_.main_unit].interface, input.field.name))
        continue;
      text += std::string(input.type->name) + " " + input.global;
      text += input.field.is_array ? "[" + std::to_string(input.field.array_size) + "];\n" : ";\n";
    }
    return text;
  }

  std::string set_to_zero(const Variable& input) const {
    const std::string name = "  " + new_names_(input.name);
    const std::string zero = " = " + input.type + "(0);";
    if (input.sizes.empty()) return name + zero + "\n";
    return "  for (int @i = 0; @i < int(" + input.sizes[0] + "); ++@i) {" + name + "[@i]" + zero + " }\n";
  }

  std::string reset_function(std::size_t u) const {
    if (!plan_.resets[u]) return {};
    std::string text = "\nvoid @reset_" + std::to_string(u) + "() {\n";
    for (const Variable& input : idle_inputs_[u]) text += set_to_zero(input);
    for (const Variable& variable : resets_[u]) {
      text += "  { " + variable.type + " @initial";
      for (const std::string& size : variable.sizes) text += "[" + size + "]";
      text += " = " + to_text(units_[u].tokens, variable.initializer_begin, variable.initializer_end) + "; " +
              new_names_(variable.name) + " = @initial; }\n";
    }
    return text + "}\n";
  }

  const DeriveRequest& request_;
  std::vector<VertexUnit> units_;
  Tokens refinement_tokens_;
  IdentifierSet application_identifiers_;
  IdentifierSet all_identifiers_;
  std::string prefix_;
  NewNames new_names_;
  EpiloguePlan plan_;
  std::vector<std::vector<Variable>> resets_;
  std::vector<std::vector<Variable>>
      idle_inputs_;  // inputs that the application's compiler has removed; they must still be numbers
  std::string refinement_extensions_;
  std::string error_;
};

}  // namespace

Derivation derive_vertex_stage(const DeriveRequest& request) {
  try {
    return Deriver(request).derive();
  } catch (const std::exception& exception) {
    return {false, {}, std::string("derivation failed: ") + exception.what()};
  }
}

}  // namespace glark::refine
