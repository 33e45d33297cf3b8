// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation_source.h"

#include "glark/core/evaluate/vertex_format.h"
#include "glark/core/refine/derive.h"

namespace glark::evaluate {
namespace {

// The fields with the names that they have in the copying stage. Built-in inputs keep their names, and so do fields that
// are not copied.
capture::Layout renamed(const capture::Layout& layout) {
  capture::Layout result = layout;
  int number = 0;
  for (capture::Field& field : result.fields) {
    if (!capture::is_builtin(field) && !field.unread) {
      field.name = capture::copied_input_name(number++);
    }
  }
  return result;
}

}  // namespace

EvaluationSource evaluation_source(const EvaluationRequest& wanted) {
  const core::DerivedProgram& derived = wanted.derived;
  capture::CaptureSources copying =
      capture::capture_sources(capture::make_layout(copied_fields(derived.layout.fields), false), wanted.language, 0);
  refine::DeriveRequest request;
  request.vertex_sources = {copying.vertex};
  request.es = wanted.language == capture::Language::es;
  request.context_glsl_version = request.es ? 320 : 430;
  request.layout = renamed(derived.layout);
  request.refinement = derived.refinement;
  request.discontinuity_field = derived.shape_fields.discontinuity;
  request.scalar_tag_field = derived.shape_fields.scalar_tags;
  request.scalar_tags = wanted.constant_tags;
  request.placed = wanted.placed;
  refine::Derivation derivation = refine::derive_vertex_stage(request);
  if (!derivation.ok) {
    return {{}, {}, derivation.error};
  }
  return {std::move(derivation.vertex_sources.front()), std::move(copying.varyings), {}};
}

}  // namespace glark::evaluate
