// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/memory.h"

#include <glslang/Include/intermediate.h>

#include <utility>

namespace glark::refine {
namespace {

bool is_local(const glslang::TQualifier& qualifier) {
  switch (qualifier.storage) {
    case glslang::EvqTemporary:
    case glslang::EvqConst:
    case glslang::EvqIn:
    case glslang::EvqOut:
    case glslang::EvqInOut:
    case glslang::EvqConstReadOnly: return true;
    default: return false;
  }
}

bool is_output(const glslang::TQualifier& qualifier) {
  switch (qualifier.storage) {
    case glslang::EvqVaryingOut:
    case glslang::EvqPosition:
    case glslang::EvqPointSize:
    case glslang::EvqClipVertex: return true;
    default: return false;
  }
}

void add_outputs(const std::string& path, const glslang::TType& type, const Shape& shape,
                 std::vector<std::pair<std::string, Value>>& outputs) {
  if (!type.isStruct()) {
    outputs.emplace_back(path, merged(shape));
    return;
  }
  const glslang::TTypeList& members = *type.getStruct();
  for (std::size_t i = 0; i < members.size() && i < shape.parts.size(); ++i) {
    add_outputs(path + "." + members[i].type->getFieldName().c_str(), *members[i].type, shape.parts[i], outputs);
  }
}

}  // namespace

bool is_anonymous_block(const glslang::TIntermSymbol& symbol) { return symbol.getName().compare(0, 5, "anon@") == 0; }

bool is_input(const glslang::TIntermSymbol& symbol) {
  switch (symbol.getQualifier().storage) {
    case glslang::EvqVaryingIn:
    case glslang::EvqVertexId:
    case glslang::EvqInstanceId: return true;
    default: return false;
  }
}

int Memory::find(const Key& key, const glslang::TType& type, const std::string& output) {
  const auto [entry, added] = numbers_.try_emplace(key, static_cast<int>(variables_.size()));
  if (added) variables_.push_back({&type, output});
  return entry->second;
}

int Memory::variable(const glslang::TIntermSymbol& symbol, std::size_t unit) {
  const glslang::TQualifier& qualifier = symbol.getQualifier();
  const std::string name = symbol.getName().c_str();
  if (is_local(qualifier)) return find({std::to_string(unit) + " ", symbol.getId()}, symbol.getType(), {});
  return find({name, 0}, symbol.getType(), is_output(qualifier) ? name : std::string());
}

int Memory::block_member(const glslang::TType& block, std::size_t index) {
  const glslang::TType& member = *(*block.getStruct())[index].type;
  const std::string name = member.getFieldName().c_str();
  return find({name, 0}, member, is_output(block.getQualifier()) ? name : std::string());
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
