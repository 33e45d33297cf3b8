// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glslang/Include/intermediate.h>

#include <map>

#include "glark/core/refine/soundness/soundness.h"

namespace glark::refine {
namespace {

class NameCollector : public glslang::TIntermTraverser {
 public:
  std::set<std::string> names;
  std::vector<std::string> called;

  void visitSymbol(glslang::TIntermSymbol* symbol) override { names.insert(symbol->getName().c_str()); }
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpFunctionCall) called.emplace_back(node->getName().c_str());
    if (node->getOp() == glslang::EOpFtransform) names.insert("gl_Vertex");
    return true;
  }
};

bool is_a(TIntermNode* node, glslang::TOperator op) {
  return node->getAsAggregate() != nullptr && node->getAsAggregate()->getOp() == op;
}

}  // namespace

std::set<std::string> reached_names(const std::vector<TIntermNode*>& roots) {
  NameCollector collector;
  std::map<std::string, TIntermNode*> functions;
  const auto note = [&](TIntermNode* node) {
    if (is_a(node, glslang::EOpFunction)) {
      functions[node->getAsAggregate()->getName().c_str()] = node;
    } else if (!is_a(node, glslang::EOpLinkerObjects)) {
      node->traverse(&collector);  // an initialiser
    }
  };
  for (TIntermNode* root : roots) {
    if (root == nullptr || root->getAsAggregate() == nullptr) continue;
    if (is_a(root, glslang::EOpFunction)) {
      note(root);
      continue;
    }
    for (TIntermNode* node : root->getAsAggregate()->getSequence()) note(node);
  }
  collector.called.emplace_back("main(");
  while (!collector.called.empty()) {
    const auto function = functions.find(collector.called.back());
    collector.called.pop_back();
    if (function == functions.end()) continue;
    TIntermNode* const body = function->second;
    functions.erase(function);
    body->traverse(&collector);
  }
  return collector.names;
}

}  // namespace glark::refine
