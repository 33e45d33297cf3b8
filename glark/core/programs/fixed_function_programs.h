// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function vertex stage as programs: one program for each state and each fragment program that it was drawn
// with.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "glark/core/programs/derived_programs.h"
#include "glark/core/refine/fixed_function/state.h"

namespace glark::core {

class FixedFunctionPrograms {
 public:
  FixedFunctionPrograms(const Environment& environment, DerivedPrograms& derived)
      : env_(environment), derived_(derived) {}

  // The program for the current state. `fragment` is the application's program with only fragment stages, or null. The
  // vertices have the parameters `materials` as attributes.
  Program* find(Program* fragment, MaterialSet materials);
  // The program of the last find() without a fragment program, if the state is the same for certain; else null. Materials
  // were not attributes.
  Program* last() const { return env_.state.fixed_function().stale() || fragment_ != 0 ? nullptr : last_; }
  // Reads the current state, if it may have changed.
  const refine::FixedFunctionState& read_state(const Program* fragment);
  // The state that was last read.
  const refine::FixedFunctionState& state() const { return state_; }

  // The application's refinement shader for the fixed-function stage.
  const std::string& refinement_source() const { return refinement_source_; }
  void set_refinement_source(std::string source);

  void discard_derived();             // drops the programs derived from any of these programs
  void forget_fragment(GLuint name);  // the program was linked again or deleted
  void release();

 private:
  refine::FragmentReads fragment_reads(const Program* fragment) const;

  const Environment& env_;
  DerivedPrograms& derived_;
  std::map<std::pair<refine::FixedFunctionState, GLuint>, std::shared_ptr<Program>> programs_;
  refine::FixedFunctionState state_;
  Program* last_ = nullptr;  // of the state, for vertices without materials; null: not known
  GLuint fragment_ = 0;      // fragment program that the state was read for
  std::string refinement_source_;
  std::map<GLuint, std::shared_ptr<ToldNotes>> told_notes_;  // of all states, by fragment program
};

}  // namespace glark::core
