// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An assembly vertex program after parsing. All names are resolved: registers are numbers, and bindings are GLSL text.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glark/core/refine/assembly/instructions.h"

namespace glark::refine::assembly {

// The parameters that the application sets by number.
enum class Bank { none, environment, local };

// A vec4 that the program does not write: an attribute, a parameter or a constant.
struct Vector {
  std::string text;        // GLSL; empty if the vector is in a bank
  Bank bank = Bank::none;  // program.env or program.local
  int index = 0;           // in the bank
  int generic = -1;        // the generic attribute that the text reads
  int matrix = -1;         // the program matrix that the text reads
};

// Four components of a vec4: letters of "xyzw", or '0' and '1' for constants.
struct Swizzle {
  std::array<char, 4> component{'x', 'y', 'z', 'w'};
  std::array<bool, 4> negated{};

  bool operator==(const Swizzle&) const = default;
};

struct Source {
  enum class Kind { vector, temporary, element };
  Kind kind = Kind::vector;
  Vector vector;
  int number = 0;   // of the temporary, or of the array that the element is in
  int address = 0;  // address register that is added to the offset
  int offset = 0;
  Swizzle swizzle;
};

struct Target {
  enum class Kind { temporary, address, output };
  Kind kind = Kind::temporary;
  int number = 0;       // of the register
  std::string output;   // the GLSL variable
  bool scalar = false;  // the output is a float, which takes the x component
  std::string mask = "xyzw";
};

struct Instruction {
  const InstructionRow* row = nullptr;
  Target target;
  std::vector<Source> sources;
};

struct Program {
  bool position_invariant = false;
  std::vector<std::string> temporaries;     // their names
  std::vector<std::string> addresses;       // their names
  std::vector<std::vector<Vector>> arrays;  // those with relative addressing
  std::vector<Instruction> instructions;
};

}  // namespace glark::refine::assembly
