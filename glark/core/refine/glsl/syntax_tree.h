// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The syntax tree of one vertex shader object, as glslang has parsed it.
#pragma once

#include <memory>

class TIntermNode;

namespace glslang {
class TShader;
}

namespace glark::refine {

class SyntaxTree {
 public:
  explicit SyntaxTree(std::unique_ptr<glslang::TShader> shader);
  ~SyntaxTree();
  SyntaxTree(const SyntaxTree&) = delete;
  SyntaxTree& operator=(const SyntaxTree&) = delete;

  TIntermNode* root() const;  // null for an empty shader

 private:
  std::unique_ptr<glslang::TShader> shader_;
};

}  // namespace glark::refine
