// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "glark/core/refine/syntax/syntax_tree.h"

namespace glark::refine {
namespace {

class MemoryWrites {
 public:
  explicit MemoryWrites(const SyntaxTree& tree) {
    for (const SyntaxNode& part : tree.parts()) {
      if (part.kind == NodeKind::function) functions_[part.words] = &part;
    }
  }

  bool found_in(const SyntaxNode& node) const {
    if (node.kind == NodeKind::linker_objects) return false;
    const bool found = (node.kind == NodeKind::operation && operation_writes(node)) ||
                       (node.kind == NodeKind::call && call_writes(node));
    return found ||
           std::any_of(node.children.begin(), node.children.end(), [&](const auto& child) { return found_in(child); });
  }

 private:
  static bool operation_writes(const SyntaxNode& node) {
    const std::string_view words = node.words;
    if (words.starts_with("imageStore") || words.starts_with("imageAtomic") || words.starts_with("Atomic")) return true;
    return modifies_operand(node) && !node.children.empty() && is_in_buffer(node.children.front());
  }

  // A function of another shader object may write each of its arguments.
  bool call_writes(const SyntaxNode& call) const {
    const auto function = functions_.find(call.words);
    for (std::size_t i = 0; i < call.children.size(); ++i) {
      const bool written = function == functions_.end() || writes_parameter(*function->second, i);
      if (written && is_in_buffer(call.children[i])) return true;
    }
    return false;
  }

  static bool writes_parameter(const SyntaxNode& function, std::size_t index) {
    const std::vector<SyntaxNode>& parameters = function.children.front().children;
    if (index >= parameters.size()) return true;
    const StorageClass storage = parameters[index].type->storage;
    return storage == StorageClass::output || storage == StorageClass::inout;
  }

  static bool is_in_buffer(const SyntaxNode& node) {
    const SyntaxNode* part = &node;
    while (selects_part(*part)) part = &part->children.front();
    return part->kind == NodeKind::symbol && part->type->storage == StorageClass::buffer;
  }

  std::map<std::string, const SyntaxNode*> functions_;
};

}  // namespace

bool modifies_operand(const SyntaxNode& node) {
  const std::string_view words = node.words;
  return node.kind == NodeKind::operation &&
         (words.ends_with("second child into first child") || words == "move second child to first child" ||
          words.ends_with("-Increment") || words.ends_with("-Decrement"));
}

bool selects_part(const SyntaxNode& node) {
  return (node.is("direct index") || node.is("indirect index") || node.is("direct index for structure") ||
          node.is("vector swizzle") || node.is("matrix swizzle")) &&
         node.children.size() == 2;
}

bool writes_memory(const SyntaxTree& tree) {
  const MemoryWrites writes(tree);
  return std::any_of(tree.parts().begin(), tree.parts().end(),
                     [&](const SyntaxNode& part) { return writes.found_in(part); });
}

}  // namespace glark::refine
