// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Assembly vertex programs as GLSL: one program for each text, and for each fragment program that it was drawn with.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>

#include "glark/core/programs/derived_programs.h"
#include "glark/core/programs/fixed_function_programs.h"
#include "glark/core/refine/assembly/translate.h"
#include "glark/core/state/assembly/assembly_program.h"

namespace glark::core {

// A translated program of the application.
struct AssemblyStage {
  std::shared_ptr<AssemblyProgram> application;
  refine::assembly::Translation translation;
  std::shared_ptr<Program> program;  // null: it cannot be translated
};

class AssemblyStages {
 public:
  AssemblyStages(const Environment& environment, DerivedPrograms& derived, FixedFunctionPrograms& fixed_function)
      : env_(environment), derived_(derived), fixed_function_(fixed_function) {}

  // The stage of the assembly program that is bound. `fragment` is the application's program with only fragment stages,
  // or null.
  const AssemblyStage& find(Program* fragment);
  // Gives the derived program the parameters that have changed since its last draw.
  void upload(const AssemblyStage& stage, DerivedProgram& derived) const;

  void discard_derived();             // drops the programs derived from any of these programs
  void forget_fragment(GLuint name);  // the program was linked again or deleted
  void release();

 private:
  struct Key {
    const AssemblyProgram* application = nullptr;
    std::uint64_t text = 0;
    GLuint fragment = 0;
    bool clip_planes = false;
    auto operator<=>(const Key&) const = default;
  };

  AssemblyStage make(const std::shared_ptr<AssemblyProgram>& application, const Key& key,
                     const Program* fragment) const;
  void drop_old_texts();
  template <typename Condition>
  void remove_if(const Condition& condition);
  void upload_matrices(const AssemblyStage& stage, DerivedProgram& derived) const;

  const Environment& env_;
  DerivedPrograms& derived_;
  FixedFunctionPrograms& fixed_function_;
  std::map<Key, AssemblyStage> stages_;
};

}  // namespace glark::core
