// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A place in the words of an assembly program, and the small parts of its grammar that need no symbols.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/refine/assembly/bindings.h"
#include "glark/core/refine/assembly/program.h"
#include "glark/core/refine/assembly/tokens.h"

namespace glark::refine::assembly {

struct SyntaxError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Cursor {
 public:
  explicit Cursor(std::string_view text) : words_(words_of(text)) {}

  const Word& peek() const { return words_[at_]; }
  bool at_number() const { return peek().kind == WordKind::number; }
  Word take();
  // Takes the word if it is next.
  bool accept(std::string_view word);
  void expect(std::string_view word);
  std::string name();
  int integer();
  // Takes '-' or '+'; returns whether it was '-'.
  bool sign();
  // "vertex.attrib[3].x"
  std::vector<PathPart> path();
  // A constant: 0.5 or {1, -2}.
  Vector constant();
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  std::string number();

  std::vector<Word> words_;
  std::size_t at_ = 0;
};

// "xyzw" of the assembly program, "rgba" as well. Empty: the letters are no swizzle.
std::string component_letters(std::string_view letters);

}  // namespace glark::refine::assembly
