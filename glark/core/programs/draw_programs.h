// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// All GL programs that refined draws run, and the events that change them.
#pragma once

#include <string>

#include "glark/core/programs/assembly_stages.h"
#include "glark/core/programs/capture_programs.h"
#include "glark/core/programs/derived_programs.h"
#include "glark/core/programs/fixed_function_programs.h"
#include "glark/core/programs/program_switch.h"

namespace glark::core {

class DrawPrograms {
 public:
  DrawPrograms(const Environment& environment, capture::CaptureStage& stage);

  DerivedPrograms& derived() { return derived_; }
  FixedFunctionPrograms& fixed_function() { return fixed_function_; }
  const FixedFunctionPrograms& fixed_function() const { return fixed_function_; }
  AssemblyStages& assembly() { return assembly_; }
  const AssemblyStages& assembly() const { return assembly_; }
  CapturePrograms& capture() { return capture_; }
  const ProgramSwitch& in_use() const { return in_use_; }

  // The program that a refinement command names; 0 is fixed function. Returns null if the program was not linked.
  Program* named(GLuint name);
  // The program was linked again or deleted.
  void changed(Program& program, GLuint name);
  // Captures now read the tag from another attribute.
  void tag_attribute_changed();
  void release();

 private:
  const Environment& env_;
  DerivedPrograms derived_;
  FixedFunctionPrograms fixed_function_;
  AssemblyStages assembly_;
  CapturePrograms capture_;
  ProgramSwitch in_use_;
};

}  // namespace glark::core
