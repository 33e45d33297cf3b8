// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <map>

#include "glark/core/refine/soundness/soundness.h"

namespace glark::refine {
namespace {

struct Mentioned {
  std::set<std::string> names;
  std::vector<std::string> called;

  void add(const SyntaxNode& node) {
    if (node.kind == NodeKind::symbol) names.insert(node.words);
    if (node.kind == NodeKind::call) called.push_back(node.words);
    if (node.is("ftransform")) names.insert("gl_Vertex");
    for (const SyntaxNode& child : node.children) add(child);
  }
};

}  // namespace

std::set<std::string> reached_names(const std::vector<const SyntaxTree*>& trees) {
  Mentioned mentioned;
  std::map<std::string, const SyntaxNode*> functions;
  for (const SyntaxTree* tree : trees) {
    for (const SyntaxNode& part : tree->parts()) {
      if (part.kind == NodeKind::function) {
        functions[part.words] = &part;
      } else if (part.kind != NodeKind::linker_objects) {
        mentioned.add(part);  // an initialiser
      }
    }
  }
  mentioned.called.emplace_back("main(");
  while (!mentioned.called.empty()) {
    const auto function = functions.find(mentioned.called.back());
    mentioned.called.pop_back();
    if (function == functions.end()) continue;
    const SyntaxNode* const body = function->second;
    functions.erase(function);
    mentioned.add(*body);
  }
  return mentioned.names;
}

}  // namespace glark::refine
