// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Abstract values of expressions.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "glark/core/refine/soundness/operations.h"
#include "glark/core/refine/soundness/run.h"

namespace glark::refine {

// Executes a function of the application.
class FunctionCalls {
 public:
  virtual ~FunctionCalls() = default;
  virtual Shape call(const SyntaxNode& call) = 0;
};

class Evaluator {
 public:
  Evaluator(Run& run, FunctionCalls& functions) : run_(run), functions_(functions) {}

  Shape evaluate(const SyntaxNode& node);
  // Writes to a variable, or to a part of it. Conditions around the statement decide, too.
  void store(const SyntaxNode& target, Shape value);
  // The condition of a selection or a loop, to be added to Run::control.
  Value condition(const SyntaxNode& node) { return merged(evaluate(node)); }

 private:
  // A variable, or a part of it.
  struct Target {
    int variable = -1;
    std::vector<std::size_t> path;                       // parts of parts
    std::optional<std::vector<std::size_t>> components;  // of a vector
    bool shared = false;                                 // with other values, which may stay
    Value index;                                         // which element
  };

  Shape read(const SyntaxNode& symbol);
  Shape evaluate_operation(const SyntaxNode& node);
  Shape evaluate_logical(const SyntaxNode& node);
  Shape evaluate_known(const SyntaxNode& node);
  Shape evaluate_selection(const SyntaxNode& node);
  Shape evaluate_part(const SyntaxNode& node);
  Shape evaluate_member(const SyntaxNode& node);
  Shape evaluate_swizzle(const SyntaxNode& node);
  Shape evaluate_assignment(const SyntaxNode& node, std::string_view operation);
  Shape evaluate_texture(const SyntaxNode& node, const Value& arguments);
  Shape construct(const Type& type, const std::vector<Shape>& arguments);
  Shape convert(const SyntaxNode& node, const Shape& operand);
  Shape operate(const SyntaxNode& node, const Operation& operation, const std::vector<Shape>& arguments);
  Value apply(const Operation& operation, const std::vector<Value>& arguments, int line);
  Value as_index(const Value& value, int line);
  Target target(const SyntaxNode& node);
  Target target_part(const SyntaxNode& node);

  Run& run_;
  FunctionCalls& functions_;
};

}  // namespace glark::refine
