// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation_source.h"

#include <map>

#include "glark/core/evaluate/vertex_format.h"
#include "glark/core/refine/derive.h"
#include "glark/core/refine/glsl/rewrite.h"

namespace glark::evaluate {
namespace {

// The name of the `number`-th copied input that has no built-in name. The application's refinement shader calls inputs
// by their names; otherwise programs with other names share the text.
std::string name_of(const capture::Field& field, int number, bool keeps_names) {
  return keeps_names ? field.name : capture::copied_input_name(number);
}

// The fields with the names that they have in the copying stage.
capture::Layout renamed(const capture::Layout& layout, bool keeps_names) {
  capture::Layout result = layout;
  int number = 0;
  for (capture::Field& field : result.fields) {
    if (!capture::is_builtin(field) && !field.unread) {
      field.name = name_of(field, number++, keeps_names);
    }
  }
  return result;
}

// `text` with the application's names of the inputs.
std::string with_names(const std::string& text, const std::vector<capture::Field>& copied) {
  refine::Tokens tokens = refine::tokenize(text);
  std::map<std::string, std::string> names;
  int number = 0;
  for (const capture::Field& field : copied) {
    if (!capture::is_builtin(field)) {
      names[capture::copied_input_name(number++)] = field.name;
    }
  }
  refine::rename_identifiers(tokens, [&](const std::string& name) {
    const auto found = names.find(name);
    return found != names.end() ? found->second : std::string();
  });
  return refine::to_text(tokens);
}

// A system value between the corners is that of the derived program, whose draws are other ones.
bool reads_draw(std::string_view refinement_source) {
  return refinement_source.find("ID") != std::string_view::npos ||
         refinement_source.find("gl_Base") != std::string_view::npos;
}

}  // namespace

EvaluationSource evaluation_source(const EvaluationRequest& wanted) {
  const core::DerivedProgram& derived = wanted.derived;
  if (reads_draw(wanted.refinement_source)) {
    return {{}, {}, "the refinement shader may read system values"};
  }
  const std::vector<capture::Field> copied = copied_fields(derived.layout.fields);
  capture::CaptureSources copying = capture::capture_sources(capture::make_layout(copied, false), wanted.language, 0);
  const bool keeps_names = !wanted.refinement_source.empty();
  refine::DeriveRequest request;
  request.vertex_sources = {keeps_names ? with_names(copying.vertex, copied) : copying.vertex};
  request.es = wanted.language == capture::Language::es;
  request.context_glsl_version = request.es ? 320 : 430;
  request.layout = renamed(derived.layout, keeps_names);
  request.refinement = derived.refinement;
  request.discontinuity_field = derived.shape_fields.discontinuity;
  request.scalar_tag_field = derived.shape_fields.scalar_tags;
  request.coordinate_field = derived.shape_fields.coordinate;
  request.scalar_tags = wanted.constant_tags;
  request.placed = wanted.placed;
  request.creased = wanted.creased;
  request.refinement_source = wanted.refinement_source;
  refine::Derivation derivation = refine::derive_vertex_stage(request);
  if (!derivation.ok) {
    return {{}, {}, derivation.error};
  }
  return {std::move(derivation.vertex_sources.front()), std::move(copying.varyings), {}};
}

}  // namespace glark::evaluate
