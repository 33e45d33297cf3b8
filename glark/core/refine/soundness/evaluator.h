// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Abstract values of expressions.
#pragma once

#include <glslang/Include/intermediate.h>

#include <optional>
#include <vector>

#include "glark/core/refine/soundness/operations.h"
#include "glark/core/refine/soundness/run.h"

namespace glark::refine {

// Executes a function of the application.
class FunctionCalls {
 public:
  virtual ~FunctionCalls() = default;
  virtual Shape call(glslang::TIntermAggregate& call) = 0;
};

class Evaluator {
 public:
  Evaluator(Run& run, FunctionCalls& functions) : run_(run), functions_(functions) {}

  Shape evaluate(TIntermNode* node);
  // Writes to a variable, or to a part of it. Conditions around the statement decide, too.
  void store(TIntermNode* target, Shape value);
  // The condition of a selection or a loop, to be added to Run::control.
  Value condition(TIntermNode* node) { return merged(evaluate(node)); }

 private:
  // A variable, or a part of it.
  struct Target {
    int variable = -1;
    std::vector<std::size_t> path;                       // parts of parts
    std::optional<std::vector<std::size_t>> components;  // of a vector
    bool shared = false;                                 // with other elements: they keep their values, too
    Value index;                                         // which element
  };

  Shape read(glslang::TIntermSymbol& symbol);
  Shape evaluate_binary(glslang::TIntermBinary& node);
  Shape evaluate_unary(glslang::TIntermUnary& node);
  Shape evaluate_aggregate(glslang::TIntermAggregate& node);
  Shape evaluate_selection(glslang::TIntermSelection& node);
  Shape evaluate_part(glslang::TIntermBinary& node);
  Shape evaluate_swizzle(glslang::TIntermBinary& node);
  Shape evaluate_assignment(glslang::TIntermBinary& node);
  Shape evaluate_texture(glslang::TIntermAggregate& node, const Value& arguments);
  Shape construct(const glslang::TType& type, const std::vector<Shape>& arguments);
  Shape convert(glslang::TIntermUnary& node, const Shape& operand);
  Shape operate(glslang::TIntermOperator& node, const Operation& operation, const std::vector<Shape>& arguments);
  Value apply(const Operation& operation, const std::vector<Value>& arguments, int line);
  Value as_index(const Value& value, int line);
  Target target(TIntermNode* node);
  Target target_part(glslang::TIntermBinary& node);

  Run& run_;
  FunctionCalls& functions_;
};

}  // namespace glark::refine
