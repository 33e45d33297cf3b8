// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/memory.h"

#include <utility>

namespace glark::refine {
namespace {

void add_outputs(const std::string& path, const Type& type, const Shape& shape,
                 std::vector<std::pair<std::string, Value>>& outputs) {
  if (!type.is_structure()) {
    outputs.emplace_back(path, merged(shape));
    return;
  }
  for (std::size_t i = 0; i < type.members.size() && i < shape.parts.size(); ++i) {
    add_outputs(path + "." + type.members[i].name, type.members[i].type, shape.parts[i], outputs);
  }
}

}  // namespace

bool is_anonymous_block(const SyntaxNode& symbol) {
  return symbol.kind == NodeKind::symbol && symbol.words.starts_with("anon@");
}

bool is_input(const SyntaxNode& symbol) { return symbol.local < 0 && symbol.type->storage == StorageClass::input; }

int Memory::find(const Key& key, const Type& type, const std::string& output) {
  const auto [entry, added] = numbers_.try_emplace(key, static_cast<int>(variables_.size()));
  if (added) variables_.push_back({&type, output});
  return entry->second;
}

int Memory::variable(const SyntaxNode& symbol, std::size_t unit) {
  if (symbol.local >= 0) return find({std::to_string(unit) + " ", symbol.local}, *symbol.type, {});
  const bool output = symbol.type->storage == StorageClass::output;
  return find({symbol.words, 0}, *symbol.type, output ? symbol.words : std::string());
}

int Memory::block_member(const Type& block, const std::string& name) {
  const Type& member = block.members[block.member(name).value()].type;
  return find({name, 0}, member, block.storage == StorageClass::output ? name : std::string());
}

Shape& Memory::at(int variable) {
  extend(state_, variables_.size());
  return state_.shapes[static_cast<std::size_t>(variable)];
}

void Memory::extend(State& state, std::size_t count) const {
  while (state.shapes.size() < count) state.shapes.push_back(shape_of(*variables_[state.shapes.size()].type));
}

bool Memory::join(State& into, const State& other) const {
  if (other.dead) return false;
  if (into.dead) {
    into = other;
    return true;
  }
  extend(into, other.shapes.size());
  bool changed = false;
  for (std::size_t i = 0; i < other.shapes.size(); ++i) {
    changed = refine::join(into.shapes[i], other.shapes[i]) || changed;
  }
  return changed;
}

std::vector<std::pair<std::string, Value>> Memory::outputs() {
  extend(state_, variables_.size());
  std::vector<std::pair<std::string, Value>> result;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Variable& variable = variables_[i];
    if (!variable.output.empty()) add_outputs(variable.output, *variable.type, state_.shapes[i], result);
  }
  return result;
}

}  // namespace glark::refine
