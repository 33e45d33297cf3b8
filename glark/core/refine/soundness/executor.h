// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Executes the statements of the vertex stage with abstract values: both ways of each condition, and loops until
// nothing changes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glark/core/refine/soundness/evaluator.h"

namespace glark::refine {

class Executor final : private FunctionCalls {
 public:
  // One tree for each shader object.
  explicit Executor(const std::vector<const SyntaxTree*>& trees);

  // Runs the initialisers of globals, then main. Returns false if the stage is too large.
  bool run();
  Run& state() { return run_; }

 private:
  struct Function {
    std::size_t unit = 0;
    const SyntaxNode* definition = nullptr;
  };

  Shape call(const SyntaxNode& call) override;
  Shape call_unknown(const SyntaxNode& call, const SyntaxNode* definition);
  void pass_arguments(const SyntaxNode& call, const std::vector<SyntaxNode>& parameters, std::size_t unit);
  void take_results(const std::vector<SyntaxNode>& arguments, const std::vector<SyntaxNode>& parameters,
                    std::size_t unit);
  Call execute_body(const Function& function);

  void execute(const SyntaxNode& node);
  void execute_if_any(const SyntaxNode* node);
  void add_condition(const SyntaxNode* node);
  void execute_selection(const SyntaxNode& node);
  void execute_loop(const SyntaxNode& node);
  void execute_pass(const SyntaxNode& node);
  void execute_switch(const SyntaxNode& node);
  void execute_return(const SyntaxNode& node);
  void leave(bool to_next_pass);
  bool too_long() const;

  std::vector<const SyntaxTree*> trees_;
  std::map<std::string, Function> functions_;  // by mangled name
  Run run_;
  Evaluator evaluator_;
};

}  // namespace glark::refine
