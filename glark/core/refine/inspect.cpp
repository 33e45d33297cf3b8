// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "glark/core/refine/derive.h"
#include "glark/core/refine/epilogue/epilogue.h"
#include "glark/core/refine/glsl/frontend.h"
#include "glark/core/refine/glsl/rewrite.h"
#include "glark/core/refine/soundness/soundness.h"

namespace glark::refine {
namespace {

bool writes_memory_by_name(const Tokens& tokens) {
  return std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.kind == TokenKind::identifier &&
           (token.text.starts_with("imageStore") || token.text.starts_with("imageAtomic") ||
            token.text.starts_with("atomic") || token.text == "buffer");
  });
}

// glslang may misunderstand a shader that asks for an extension that glslang does not know.
bool uses_unknown_extension(const Tokens& tokens) {
  for (const Token& token : tokens) {
    if (directive_name(token) != "extension") continue;
    const Tokens words = tokenize(std::string_view(token.text).substr(1));
    if (words.size() > 2 && !words[1].is("all") && !frontend_knows_extension(words[1].text)) return true;
  }
  return false;
}

void note_system_values(const std::set<std::string>& names, VertexStageTraits& traits) {
  for (const std::string& name : names) {
    const BuiltInInput* const input = built_in_input(name);
    if (input == nullptr || !input->system_value) continue;
    traits.system_values.insert(std::string(input->field));
    traits.reads_vertex_id = traits.reads_vertex_id || input->field == "gl_VertexID";
  }
}

// Notes which system values are read, and how the outputs depend on the attributes.
void note_data_flow(const std::vector<VertexUnit>& units, const std::vector<Parsed>& parsed,
                    const std::set<std::string>& constants, VertexStageTraits& traits) {
  constexpr const char* unknown = "the vertex stage could not be analysed";
  if (!std::all_of(parsed.begin(), parsed.end(), [](const Parsed& unit) { return unit.ok; })) {
    IdentifierSet mentioned;
    for (const VertexUnit& unit : units) collect_identifiers(unit.tokens, mentioned);
    note_system_values({mentioned.begin(), mentioned.end()}, traits);
    traits.variation.outputs = {{"gl_Position", Variation::undefined, unknown}};
    return;
  }
  std::vector<const SyntaxTree*> trees;
  for (const Parsed& unit : parsed) trees.push_back(unit.tree.get());
  note_system_values(reached_names(trees), traits);
  const StageVariation too_large{{{"gl_Position", Variation::undefined, unknown}}};
  traits.variation = find_variation(trees, constants).value_or(too_large);
}

// Notes which outputs are interpolated. `variation` has an entry for each member of a structure, but only one for all
// elements of an array.
void note_interpolation(const std::vector<OutputVariable>& outputs, const std::vector<Structure>& structures,
                        StageVariation& variation) {
  for (const OutputVariable& output : outputs) {
    const Interpolation interpolation = is_flat(output, structures) ? Interpolation::never
                                        : output.by_shade_model     ? Interpolation::unless_flat_shaded
                                                                    : Interpolation::always;
    const std::string path = without_indices(output.path);
    for (OutputVariation& part : variation.outputs)
      if (part.path == path || part.path.starts_with(path + ".")) part.interpolation = interpolation;
  }
}

Inspection inspect(const std::vector<std::string>& sources, bool es, const std::vector<std::string>& extensions,
                   const std::set<std::string>& constants) {
  Inspection result;
  std::vector<VertexUnit> units;
  if (!read_units(sources, es, extensions, units, result.error)) return result;
  const std::size_t main_unit = find_main_unit(units);
  if (main_unit == units.size()) {
    result.error = "no vertex shader defines main()";
    return result;
  }
  std::vector<Structure> structures;
  std::vector<Parsed> all_parsed;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Tokens& tokens = units[i].tokens;
    Parsed parsed = parse_vertex_shader(to_text(tokens), es);
    const bool unknown = !parsed.ok && (parsed.limited || uses_unknown_extension(tokens));
    if (!parsed.ok && !unknown) {
      result.error =
          units.size() == 1 ? "vertex shader: " + parsed.error : fmt::format("vertex shader {}: {}", i, parsed.error);
      return result;
    }
    if (unknown ? writes_memory_by_name(tokens) : parsed.writes_memory) result.traits.has_side_effects = true;
    structures.insert(structures.end(), units[i].interface.structures.begin(), units[i].interface.structures.end());
    all_parsed.push_back(std::move(parsed));
  }
  note_data_flow(units, all_parsed, constants, result.traits);
  const std::vector<OutputVariable> outputs = collect_outputs(units, main_unit, {});
  note_interpolation(outputs, structures, result.traits.variation);
  result.traits.writes_cull_distance = std::any_of(
      outputs.begin(), outputs.end(), [](const OutputVariable& output) { return output.path == "gl_CullDistance"; });
  result.traits.writes_integers = std::any_of(outputs.begin(), outputs.end(), [](const OutputVariable& output) {
    const NumericType* const numeric = numeric_type(std::string_view(output.type));
    return !output.flat && !output.path.starts_with("gl_") && numeric != nullptr && !numeric->interpolates();
  });
  result.traits.writes_flat_outputs = std::any_of(
      outputs.begin(), outputs.end(), [&](const OutputVariable& output) { return is_flat(output, structures); });
  result.traits.copies_provoking_vertex = std::any_of(
      outputs.begin(), outputs.end(),
      [&](const OutputVariable& output) { return is_flat(output, structures) || has_integers(output, structures); });
  result.ok = true;
  return result;
}

}  // namespace

Inspection inspect_vertex_stage(const std::vector<std::string>& vertex_sources, bool es,
                                const std::vector<std::string>& extensions, const std::set<std::string>& constants) {
  try {
    return inspect(vertex_sources, es, extensions, constants);
  } catch (const std::exception& exception) {
    Inspection failed;
    failed.error = std::string("inspection failed: ") + exception.what();
    return failed;
  }
}

}  // namespace glark::refine
