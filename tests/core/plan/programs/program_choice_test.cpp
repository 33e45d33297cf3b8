// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/program_choice.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr ChoiceConditions compatibility{.is_compatibility = true};
constexpr ChoiceConditions core_profile{.is_compatibility = false};

Bindings bound(GLuint program, GLuint pipeline = 0) {
  Bindings bindings;
  bindings.program = program;
  bindings.pipeline = pipeline;
  return bindings;
}

void give_stage(Program& program, GLenum stage) { program.stages.push_back({stage, nullptr}); }

TEST(ProgramChoice, AProgramWithAVertexStage) {
  Program program;
  give_stage(program, GL_VERTEX_SHADER);
  const ProgramChoice choice = choose_program(bound(1), &program, compatibility);
  EXPECT_EQ(choice.cause, std::nullopt);
  EXPECT_EQ(choice.stage, VertexStage::program);
}

// It is unknown whether a program from a binary has a vertex stage. The builder finds out later.
TEST(ProgramChoice, AProgramFromABinary) {
  const Program program;
  EXPECT_EQ(choose_program(bound(1), &program, core_profile).stage, VertexStage::program);
}

TEST(ProgramChoice, AProgramThatWasNotSeen) {
  EXPECT_EQ(choose_program(bound(1), nullptr, compatibility).cause, Cause::no_program);
}

TEST(ProgramChoice, AProgramToWhichGlCannotReturn) {
  Program program;
  program.linked = false;
  EXPECT_EQ(choose_program(bound(1), &program, compatibility).cause, Cause::program_gone);
  program.linked = true;
  program.cause = Cause::program_gone;
  EXPECT_EQ(choose_program(bound(1), &program, compatibility).cause, Cause::program_gone);
}

TEST(ProgramChoice, FragmentsAloneTakeTheFixedFunction) {
  Program program;
  give_stage(program, GL_FRAGMENT_SHADER);
  EXPECT_EQ(choose_program(bound(1), &program, compatibility).stage, VertexStage::fixed_function);
  EXPECT_EQ(choose_program(bound(1), &program, core_profile).cause, Cause::no_program);
}

TEST(ProgramChoice, NoProgramIsTheFixedFunctionOfCompatibilityContexts) {
  EXPECT_EQ(choose_program({}, nullptr, compatibility).stage, VertexStage::fixed_function);
  EXPECT_EQ(choose_program({}, nullptr, core_profile).cause, Cause::no_program);
}

TEST(ProgramChoice, AssemblyProgramsAreTranslatedForProgramsThatDoNotKnow) {
  Bindings enabled;
  enabled.vertex_program = true;
  EXPECT_EQ(choose_program(enabled, nullptr, compatibility).cause, Cause::assembly_program);
  constexpr ChoiceConditions transparent{.is_compatibility = true, .transparent = true};
  EXPECT_EQ(choose_program(enabled, nullptr, transparent).stage, VertexStage::assembly);
  Program program;
  give_stage(program, GL_FRAGMENT_SHADER);
  EXPECT_EQ(choose_program(enabled, &program, transparent).stage, VertexStage::assembly);
  give_stage(program, GL_VERTEX_SHADER);
  EXPECT_EQ(choose_program(enabled, &program, transparent).stage, VertexStage::program);
}

TEST(ProgramChoice, AProgramHasPrecedenceOverAProgramPipeline) {
  Program program;
  give_stage(program, GL_VERTEX_SHADER);
  EXPECT_EQ(choose_program(bound(0, 2), nullptr, compatibility).stage, VertexStage::program_pipeline);
  EXPECT_EQ(choose_program(bound(1, 2), &program, compatibility).stage, VertexStage::program);
}

TEST(ProgramChoice, ProgramPipelinesNeedAVertexStageAndNoTessellation) {
  EXPECT_EQ(check_stages({.programs = {1, 0, 0, 0, 2}}), std::nullopt);
  EXPECT_EQ(check_stages({.programs = {0, 0, 0, 0, 2}}), Cause::program_pipeline);
  EXPECT_EQ(check_stages({.programs = {1, 3, 0, 0, 2}}), Cause::tessellation);
  EXPECT_EQ(check_stages({.programs = {1, 0, 3, 0, 2}}), Cause::tessellation);
}

}  // namespace
}  // namespace glark::core
