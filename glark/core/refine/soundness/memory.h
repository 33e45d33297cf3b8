// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The variables of the vertex stage and their abstract values.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "glark/core/refine/soundness/value.h"
#include "glark/core/refine/syntax/syntax_tree.h"

namespace glark::refine {

// Names of blocks without an instance name begin so; their members are variables by themselves.
bool is_anonymous_block(const SyntaxNode& symbol);
// Inputs of the vertex stage, built-in ones included.
bool is_input(const SyntaxNode& symbol);

class Memory {
 public:
  // The values at one point of the program.
  struct State {
    std::vector<Shape> shapes;  // by variable; a missing one has not been written
    bool dead = false;          // no execution comes here
  };

  // Shader objects of a stage share global variables by name. `unit` tells local ones apart.
  int variable(const SyntaxNode& symbol, std::size_t unit);
  int block_member(const Type& block, const std::string& name);
  // The value in the current state.
  Shape& at(int variable);

  State& state() { return state_; }
  bool join(State& into, const State& other) const;
  // The outputs in the current state, each member of a structure by itself: path and value.
  std::vector<std::pair<std::string, Value>> outputs();

 private:
  using Key = std::pair<std::string, int>;  // the name of a global; else the unit and the number of the variable
  struct Variable {
    const Type* type = nullptr;
    std::string output;  // name, if it is an output
  };
  int find(const Key& key, const Type& type, const std::string& output);
  void extend(State& state, std::size_t count) const;

  std::map<Key, int> numbers_;
  std::vector<Variable> variables_;
  State state_;
};

}  // namespace glark::refine
