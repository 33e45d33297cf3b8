// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The subroutines that the program in use has chosen.
#pragma once

#include <utility>

#include "glark/core/state/programs/derived_program.h"

namespace glark::core {

class ChosenSubroutines {
 public:
  // False: they must be read from GL before the next use.
  bool known() const { return known_; }
  void forget() { known_ = false; }
  void set(SubroutineChoice choice) {
    choice_ = std::move(choice);
    known_ = true;
  }
  const SubroutineChoice& choice() const { return choice_; }

 private:
  bool known_ = false;
  SubroutineChoice choice_;
};

}  // namespace glark::core
