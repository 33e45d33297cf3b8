// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation_source.h"

#include "glark/core/refine/derive.h"

namespace glark::evaluate {
namespace {

// The fields with the names that they have in the copying stage. Built-in inputs keep their names.
capture::Layout renamed(const capture::Layout& layout) {
  capture::Layout result = layout;
  int number = 0;
  for (capture::Field& field : result.fields) {
    if (!capture::is_builtin(field)) {
      field.name = capture::copied_input_name(number++);
    }
  }
  return result;
}

}  // namespace

EvaluationSource evaluation_source(const capture::Layout& layout, core::Refinement refinement,
                                   const core::ScalarTags& tags, capture::Language language) {
  capture::CaptureSources copying = capture::capture_sources(capture::make_layout(layout.fields, false), language, 0);
  refine::DeriveRequest request;
  request.vertex_sources = {copying.vertex};
  request.es = language == capture::Language::es;
  request.context_glsl_version = request.es ? 320 : 430;
  request.layout = renamed(layout);
  request.refinement = refinement;
  request.scalar_tags = tags;
  request.placed = false;
  refine::Derivation derivation = refine::derive_vertex_stage(request);
  if (!derivation.ok) {
    return {{}, {}, derivation.error};
  }
  return {std::move(derivation.vertex_sources.front()), std::move(copying.varyings), {}};
}

}  // namespace glark::evaluate
