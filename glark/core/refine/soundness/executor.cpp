// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/executor.h"

namespace glark::refine {
namespace {

using glslang::TIntermAggregate;
using glslang::TIntermBranch;
using glslang::TIntermLoop;
using glslang::TIntermSelection;
using glslang::TIntermSequence;
using glslang::TIntermSwitch;

constexpr std::size_t most_steps = 400000;
constexpr std::size_t deepest_call = 64;
constexpr const char* main_function = "main(";

bool is_function(TIntermNode* node) {
  return node->getAsAggregate() != nullptr && node->getAsAggregate()->getOp() == glslang::EOpFunction;
}

bool is_list(const TIntermAggregate& node) {
  return node.getOp() == glslang::EOpSequence || node.getOp() == glslang::EOpScope;
}

bool writes(const glslang::TIntermTyped& parameter) {
  const glslang::TStorageQualifier storage = parameter.getQualifier().storage;
  return storage == glslang::EvqOut || storage == glslang::EvqInOut;
}

const TIntermSequence& parameters_of(TIntermAggregate& function) {
  return function.getSequence()[0]->getAsAggregate()->getSequence();
}

}  // namespace

Executor::Executor(const std::vector<TIntermNode*>& roots)
    : roots_(roots), run_(roots.size()), evaluator_(run_, *this) {
  for (std::size_t unit = 0; unit < roots.size(); ++unit) {
    TIntermAggregate* const root = roots[unit] != nullptr ? roots[unit]->getAsAggregate() : nullptr;
    if (root == nullptr) continue;
    if (is_function(root)) functions_[root->getName().c_str()] = {unit, root};
    for (TIntermNode* node : root->getSequence()) {
      if (is_function(node)) functions_[node->getAsAggregate()->getName().c_str()] = {unit, node->getAsAggregate()};
    }
  }
}

bool Executor::too_long() const { return run_.steps > most_steps; }

bool Executor::run() {
  for (std::size_t unit = 0; unit < roots_.size(); ++unit) {
    TIntermAggregate* const root = roots_[unit] != nullptr ? roots_[unit]->getAsAggregate() : nullptr;
    if (root == nullptr || is_function(root)) continue;
    run_.calls.push_back({.unit = unit});
    for (TIntermNode* node : root->getSequence()) {
      const bool linker_objects =
          node->getAsAggregate() != nullptr && node->getAsAggregate()->getOp() == glslang::EOpLinkerObjects;
      if (!is_function(node) && !linker_objects) execute(node);
    }
    run_.calls.pop_back();
  }
  const auto main = functions_.find(main_function);
  if (main == functions_.end()) return false;
  run_.calls.push_back({});
  execute_body(main->second, main->second.definition->getType());
  run_.calls.pop_back();
  return !too_long();
}

// Begins in the state of the caller and leaves the state after the function.
Call Executor::execute_body(const Function& function, const glslang::TType& result) {
  const Value outside = run_.control;
  run_.control = run_.whole_control();
  run_.calls.push_back({.unit = function.unit, .result = shape_of(result)});
  const TIntermSequence& parts = function.definition->getSequence();
  for (std::size_t i = 1; i < parts.size(); ++i) execute(parts[i]);
  Call finished = std::move(run_.calls.back());
  run_.calls.pop_back();
  run_.control = outside;
  run_.memory.join(run_.memory.state(), finished.at_return);
  return finished;
}

Shape Executor::call(TIntermAggregate& call) {
  const auto found = functions_.find(call.getName().c_str());
  if (found == functions_.end() || run_.calls.size() > deepest_call || too_long()) return call_unknown(call);
  const Function& function = found->second;
  const TIntermSequence& parameters = parameters_of(*function.definition);
  pass_arguments(call, parameters, function.unit);
  Shape result = execute_body(function, call.getType()).result;
  take_results(call.getSequence(), parameters, function.unit);
  return result;
}

void Executor::pass_arguments(TIntermAggregate& call, const TIntermSequence& parameters, std::size_t unit) {
  std::vector<Shape> values;
  for (TIntermNode* argument : call.getSequence()) values.push_back(evaluator_.evaluate(argument));
  for (std::size_t i = 0; i < parameters.size() && i < values.size(); ++i) {
    run_.memory.at(run_.memory.variable(*parameters[i]->getAsSymbolNode(), unit)) = std::move(values[i]);
  }
}

void Executor::take_results(const TIntermSequence& arguments, const TIntermSequence& parameters, std::size_t unit) {
  for (std::size_t i = 0; i < parameters.size() && i < arguments.size(); ++i) {
    const glslang::TIntermSymbol& parameter = *parameters[i]->getAsSymbolNode();
    if (writes(parameter)) evaluator_.store(arguments[i], run_.memory.at(run_.memory.variable(parameter, unit)));
  }
}

// Nothing is known about what the function does with its arguments.
Shape Executor::call_unknown(TIntermAggregate& call) {
  Value all;
  for (TIntermNode* argument : call.getSequence()) all = worse(all, merged(evaluator_.evaluate(argument)));
  all = run_.notes.worsened(all, Variation::undefined, run_.place(call.getLoc().line), "unknown function");
  const glslang::TQualifierList& qualifiers = call.getQualifierList();
  for (std::size_t i = 0; i < qualifiers.size() && i < call.getSequence().size(); ++i) {
    const bool written = qualifiers[i] == glslang::EvqOut || qualifiers[i] == glslang::EvqInOut;
    if (written) evaluator_.store(call.getSequence()[i], {all, {}});
  }
  return shape_of(call.getType(), all);
}

void Executor::execute(TIntermNode* node) {
  if (node == nullptr || too_long()) return;
  TIntermAggregate* const aggregate = node->getAsAggregate();
  TIntermSelection* const selection = node->getAsSelectionNode();
  if (aggregate != nullptr && is_list(*aggregate)) {
    for (TIntermNode* statement : aggregate->getSequence()) execute(statement);
  } else if (selection != nullptr && selection->getBasicType() == glslang::EbtVoid) {
    execute_selection(*selection);
  } else if (TIntermLoop* const loop = node->getAsLoopNode()) {
    execute_loop(*loop);
  } else if (TIntermSwitch* const choice = node->getAsSwitchNode()) {
    execute_switch(*choice);
  } else if (TIntermBranch* const branch = node->getAsBranchNode()) {
    execute_branch(*branch);
  } else {
    evaluator_.evaluate(node);
  }
}

void Executor::execute_selection(TIntermSelection& node) {
  const Value outside = run_.control;
  run_.control = worse(outside, evaluator_.condition(node.getCondition()));
  Memory::State& state = run_.memory.state();
  const Memory::State before = state;
  execute(node.getTrueBlock());
  const Memory::State after_true = std::exchange(state, before);
  execute(node.getFalseBlock());
  run_.memory.join(state, after_true);
  run_.control = outside;
}

void Executor::execute_pass(TIntermLoop& node) {
  if (node.testFirst() && node.getTest() != nullptr) {
    run_.control = worse(run_.control, evaluator_.condition(node.getTest()));
  }
  execute(node.getBody());
  Breakable& loop = run_.calls.back().breakables.back();
  run_.memory.join(run_.memory.state(), std::exchange(loop.at_continue, {{}, true}));
  if (node.getTerminal() != nullptr) evaluator_.evaluate(node.getTerminal());
  if (!node.testFirst() && node.getTest() != nullptr) {
    run_.control = worse(run_.control, evaluator_.condition(node.getTest()));
  }
}

void Executor::execute_loop(TIntermLoop& node) {
  const Value outside = run_.control;
  run_.calls.back().breakables.push_back({.loop = true});
  Memory::State reached = run_.memory.state();
  for (bool changed = true; changed && !too_long();) {
    const Value before = worse(run_.control, run_.calls.back().breakables.back().control);
    execute_pass(node);
    const Value after = worse(run_.control, run_.calls.back().breakables.back().control);
    changed = run_.memory.join(reached, run_.memory.state());
    changed = changed || after.variation != before.variation || after.inputs != before.inputs;
    run_.memory.state() = reached;
  }
  run_.memory.join(run_.memory.state(), run_.calls.back().breakables.back().at_break);
  run_.calls.back().breakables.pop_back();
  run_.control = outside;
}

void Executor::execute_switch(TIntermSwitch& node) {
  const Value outside = run_.control;
  run_.control = worse(outside, evaluator_.condition(node.getCondition()));
  run_.calls.back().breakables.push_back({});
  const Memory::State before = run_.memory.state();
  for (TIntermNode* statement : node.getBody()->getSequence()) {
    TIntermBranch* const branch = statement->getAsBranchNode();
    const bool label =
        branch != nullptr && (branch->getFlowOp() == glslang::EOpCase || branch->getFlowOp() == glslang::EOpDefault);
    if (label) {
      run_.memory.join(run_.memory.state(), before);
    } else {
      execute(statement);
    }
  }
  run_.memory.join(run_.memory.state(), before);
  run_.memory.join(run_.memory.state(), run_.calls.back().breakables.back().at_break);
  run_.calls.back().breakables.pop_back();
  run_.control = outside;
}

void Executor::execute_branch(TIntermBranch& node) {
  switch (node.getFlowOp()) {
    case glslang::EOpReturn: {
      Shape value = evaluator_.evaluate(node.getExpression());
      Call& current = run_.calls.back();  // calls within the expression may have moved it
      const Value control = run_.whole_control();
      worsen(value, control);
      if (!run_.memory.state().dead) join(current.result, value);
      current.control = worse(current.control, control);
      run_.memory.join(current.at_return, run_.memory.state());
      run_.memory.state().dead = true;
      return;
    }
    case glslang::EOpBreak: leave(false); return;
    case glslang::EOpContinue: leave(true); return;
    default: return;
  }
}

void Executor::leave(bool to_next_pass) {
  std::vector<Breakable>& breakables = run_.calls.back().breakables;
  std::size_t i = breakables.size();
  while (i > 0 && to_next_pass && !breakables[i - 1].loop) --i;
  if (i == 0) return;
  Breakable& left = breakables[i - 1];
  left.control = worse(left.control, run_.whole_control());
  run_.memory.join(to_next_pass ? left.at_continue : left.at_break, run_.memory.state());
  run_.memory.state().dead = true;
}

}  // namespace glark::refine
