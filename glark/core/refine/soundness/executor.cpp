// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/executor.h"

#include <utility>

namespace glark::refine {
namespace {

constexpr std::size_t most_steps = 400000;
constexpr std::size_t deepest_call = 64;
constexpr const char* main_function = "main(";

bool writes(const SyntaxNode& parameter) {
  return parameter.type->storage == StorageClass::output || parameter.type->storage == StorageClass::inout;
}

const std::vector<SyntaxNode>& parameters_of(const SyntaxNode& function) { return function.children.front().children; }

}  // namespace

Executor::Executor(const std::vector<const SyntaxTree*>& trees)
    : trees_(trees), run_(trees.size()), evaluator_(run_, *this) {
  for (std::size_t unit = 0; unit < trees.size(); ++unit) {
    for (const SyntaxNode& part : trees[unit]->parts()) {
      if (part.kind == NodeKind::function && !part.children.empty()) functions_[part.words] = {unit, &part};
    }
  }
}

bool Executor::too_long() const { return run_.steps > most_steps; }

bool Executor::run() {
  for (std::size_t unit = 0; unit < trees_.size(); ++unit) {
    run_.calls.push_back({.unit = unit});
    for (const SyntaxNode& part : trees_[unit]->parts()) {
      if (part.kind != NodeKind::function && part.kind != NodeKind::linker_objects) execute(part);
    }
    run_.calls.pop_back();
  }
  const auto main = functions_.find(main_function);
  if (main == functions_.end()) return false;
  run_.calls.push_back({});
  execute_body(main->second);
  run_.calls.pop_back();
  return !too_long();
}

// Begins in the state of the caller and leaves the state after the function.
Call Executor::execute_body(const Function& function) {
  const Value outside = run_.control;
  run_.control = run_.whole_control();
  run_.calls.push_back({.unit = function.unit, .result = shape_of(*function.definition->type)});
  const std::vector<SyntaxNode>& parts = function.definition->children;
  for (std::size_t i = 1; i < parts.size(); ++i) execute(parts[i]);
  Call finished = std::move(run_.calls.back());
  run_.calls.pop_back();
  run_.control = outside;
  run_.memory.join(run_.memory.state(), finished.at_return);
  return finished;
}

Shape Executor::call(const SyntaxNode& call) {
  const auto found = functions_.find(call.words);
  if (found == functions_.end()) return call_unknown(call, nullptr);
  const Function& function = found->second;
  if (run_.calls.size() > deepest_call || too_long()) return call_unknown(call, function.definition);
  const std::vector<SyntaxNode>& parameters = parameters_of(*function.definition);
  pass_arguments(call, parameters, function.unit);
  Shape result = execute_body(function).result;
  take_results(call.children, parameters, function.unit);
  return result;
}

void Executor::pass_arguments(const SyntaxNode& call, const std::vector<SyntaxNode>& parameters, std::size_t unit) {
  std::vector<Shape> values;
  for (const SyntaxNode& argument : call.children) values.push_back(evaluator_.evaluate(argument));
  for (std::size_t i = 0; i < parameters.size() && i < values.size(); ++i) {
    run_.memory.at(run_.memory.variable(parameters[i], unit)) = std::move(values[i]);
  }
}

void Executor::take_results(const std::vector<SyntaxNode>& arguments, const std::vector<SyntaxNode>& parameters,
                            std::size_t unit) {
  for (std::size_t i = 0; i < parameters.size() && i < arguments.size(); ++i) {
    if (!writes(parameters[i])) continue;
    evaluator_.store(arguments[i], run_.memory.at(run_.memory.variable(parameters[i], unit)));
  }
}

// Nothing is known about what the function does with its arguments. Without a definition it may write each of them.
Shape Executor::call_unknown(const SyntaxNode& call, const SyntaxNode* definition) {
  Value all;
  for (const SyntaxNode& argument : call.children) all = worse(all, merged(evaluator_.evaluate(argument)));
  all = run_.notes.worsened(all, Variation::undefined, run_.place(call.line), "unknown function");
  for (std::size_t i = 0; i < call.children.size(); ++i) {
    const bool written =
        definition == nullptr || i >= parameters_of(*definition).size() || writes(parameters_of(*definition)[i]);
    if (written) evaluator_.store(call.children[i], {all, {}});
  }
  return shape_of(*call.type, all);
}

void Executor::execute(const SyntaxNode& node) {
  if (too_long()) return;
  switch (node.kind) {
    case NodeKind::sequence:
      for (const SyntaxNode& statement : node.children) execute(statement);
      return;
    case NodeKind::selection:
      if (node.type->basic == BasicType::none) return execute_selection(node);
      break;
    case NodeKind::loop: return execute_loop(node);
    case NodeKind::switch_statement: return execute_switch(node);
    case NodeKind::return_statement: return execute_return(node);
    case NodeKind::break_statement: return leave(false);
    case NodeKind::continue_statement: return leave(true);
    default: break;
  }
  evaluator_.evaluate(node);
}

void Executor::execute_if_any(const SyntaxNode* node) {
  if (node != nullptr) execute(*node);
}

void Executor::add_condition(const SyntaxNode* node) {
  if (node != nullptr) run_.control = worse(run_.control, evaluator_.condition(*node));
}

void Executor::execute_selection(const SyntaxNode& node) {
  const Value outside = run_.control;
  add_condition(node.part(Role::condition));
  Memory::State& state = run_.memory.state();
  const Memory::State before = state;
  execute_if_any(node.part(Role::true_case));
  const Memory::State after_true = std::exchange(state, before);
  execute_if_any(node.part(Role::false_case));
  run_.memory.join(state, after_true);
  run_.control = outside;
}

void Executor::execute_pass(const SyntaxNode& node) {
  if (node.tests_first) add_condition(node.part(Role::test));
  execute_if_any(node.part(Role::body));
  Breakable& loop = run_.calls.back().breakables.back();
  run_.memory.join(run_.memory.state(), std::exchange(loop.at_continue, {{}, true}));
  if (const SyntaxNode* const terminal = node.part(Role::terminal)) evaluator_.evaluate(*terminal);
  if (!node.tests_first) add_condition(node.part(Role::test));
}

void Executor::execute_loop(const SyntaxNode& node) {
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

void Executor::execute_switch(const SyntaxNode& node) {
  if (node.children.size() != 2) return;
  const Value outside = run_.control;
  add_condition(&node.children[0]);
  run_.calls.back().breakables.push_back({});
  const Memory::State before = run_.memory.state();
  for (const SyntaxNode& statement : node.children[1].children) {
    if (statement.kind == NodeKind::case_label) {
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

void Executor::execute_return(const SyntaxNode& node) {
  Shape value = node.children.empty() ? Shape{} : evaluator_.evaluate(node.children[0]);
  Call& current = run_.calls.back();  // calls within the expression may have moved it
  const Value control = run_.whole_control();
  worsen(value, control);
  if (!run_.memory.state().dead) join(current.result, value);
  current.control = worse(current.control, control);
  run_.memory.join(current.at_return, run_.memory.state());
  run_.memory.state().dead = true;
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
