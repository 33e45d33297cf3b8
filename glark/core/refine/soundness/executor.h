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
  // The roots of the syntax trees, one for each shader object.
  explicit Executor(const std::vector<TIntermNode*>& roots);

  // Runs the initialisers of globals, then main. Returns false if the stage is too large.
  bool run();
  Run& state() { return run_; }

 private:
  struct Function {
    std::size_t unit = 0;
    glslang::TIntermAggregate* definition = nullptr;
  };

  Shape call(glslang::TIntermAggregate& call) override;
  Shape call_unknown(glslang::TIntermAggregate& call);
  void pass_arguments(glslang::TIntermAggregate& call, const glslang::TIntermSequence& parameters, std::size_t unit);
  void take_results(const glslang::TIntermSequence& arguments, const glslang::TIntermSequence& parameters,
                    std::size_t unit);
  Call execute_body(const Function& function, const glslang::TType& result);

  void execute(TIntermNode* node);
  void execute_selection(glslang::TIntermSelection& node);
  void execute_loop(glslang::TIntermLoop& node);
  void execute_pass(glslang::TIntermLoop& node);
  void execute_switch(glslang::TIntermSwitch& node);
  void execute_branch(glslang::TIntermBranch& node);
  void leave(bool to_next_pass);
  bool too_long() const;

  std::vector<TIntermNode*> roots_;
  std::map<std::string, Function> functions_;  // by mangled name
  Run run_;
  Evaluator evaluator_;
};

}  // namespace glark::refine
