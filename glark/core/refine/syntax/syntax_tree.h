// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The syntax tree of one vertex shader object. glslang parses the shader and writes its tree as text; this is the tree
// that the text describes. The classes of glslang's own tree are not part of its public interface.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glark/core/refine/syntax/type.h"

namespace glark::refine {

enum class NodeKind {
  sequence,        // statements
  linker_objects,  // the interface of the shader
  function,        // `words` is its mangled name; the first child has the parameters, the others are the body
  parameters,
  call,  // of a function of the application; `words` is its mangled name
  selection,
  loop,
  switch_statement,  // the children are the condition and the body
  case_label,        // "case" or "default"
  return_statement,
  break_statement,
  continue_statement,
  constant,   // of `count` numbers
  symbol,     // a variable; `words` is its name
  operation,  // `words` says which: "add", "vector swizzle"
};

// What a child of a selection or a loop is.
enum class Role { none, condition, true_case, false_case, test, body, terminal };

struct SyntaxNode {
  NodeKind kind = NodeKind::operation;
  Role role = Role::none;
  int line = 0;
  std::string words;
  std::string member;          // "direct index for structure" has the name of the member
  const Type* type = nullptr;  // never null in a tree; constants have no known type
  long long first_number = 0;  // of a constant of integers
  std::size_t count = 0;       // numbers of a constant
  int local = -1;              // the number of a local variable or a parameter; -1 for global ones
  bool shares_name = false;    // a local variable with the same name and type as one of an outer scope
  bool tests_first = true;     // of a loop
  std::vector<SyntaxNode> children;

  bool is(std::string_view expected) const { return kind == NodeKind::operation && words == expected; }
  const SyntaxNode* part(Role wanted) const;  // null if there is none
};

class SyntaxTree {
 public:
  // `text` is what glslang writes. `shadowing`: names of local variables that hide others.
  SyntaxTree(std::string_view text, const std::set<std::string>& shadowing);

  // Functions, initialisers of global variables, and the linker objects.
  const std::vector<SyntaxNode>& parts() const { return parts_; }

 private:
  std::unordered_map<std::string, Type> types_;  // by text; nodes refer to them
  std::vector<SyntaxNode> parts_;
};

// Does the shader write images, atomic counters or buffer blocks?
bool writes_memory(const SyntaxTree& tree);

// An operation such as "+=" or "++", which writes its first operand.
bool modifies_operand(const SyntaxNode& node);
// An index, a member or a swizzle: a part of its first operand.
bool selects_part(const SyntaxNode& node);

}  // namespace glark::refine
