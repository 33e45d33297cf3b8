// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark doctor as a user runs it.
#include <gtest/gtest.h>

#include <string>

#include "tests/shim/process.h"

namespace glark::test {
namespace {

const std::string drawing_program = PROGRAM_FOLDER "/shim_linked";

Outcome doctor(const std::string& arguments) {
  return run("env -u DISPLAY GLARK_CONFIG=/dev/null " GLARK_TOOL " doctor " + arguments);
}

void expect(const Outcome& outcome, int status, const std::string& part) {
  EXPECT_EQ(outcome.status, status) << outcome.output;
  EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
}

}  // namespace

TEST(Doctor, AProgramThatIsRefined) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the run time of a sanitizer must be the first library of the process";
#endif
  const Outcome outcome = doctor("--everything --refine linear --seconds 20 -- " + drawing_program);
  expect(outcome, 0, "shim_linked ended by itself after");
  expect(outcome, 0, "  Refined: ");
}

TEST(Doctor, AProgramThatIsLeftAlone) {
  const Outcome outcome = doctor("--leave-alone " + drawing_program);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
}

TEST(Doctor, AChildThatDraws) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the run time of a sanitizer must be the first library of the process";
#endif
  expect(doctor("--everything --refine linear --seconds 20 sh -c '" + drawing_program + " & wait'"), 0,
         "shim_linked (process ");
}

TEST(Doctor, AProgramThatDrawsNothing) {
  expect(doctor("true"), 1, "No process made an OpenGL context that glark sees.");
}

TEST(Doctor, AProgramThatCrashes) { expect(doctor("sh -c 'kill -SEGV $$'"), 1, "was ended by a signal after"); }

TEST(Doctor, AProgramThatDoesNotEndIsStoppedWithItsChildren) {
  const Outcome outcome = doctor("--seconds 0.5 sh -c 'sleep 4321 & trap \"\" TERM; sleep 4322; sleep 4323'");
  expect(outcome, 1, "and was stopped.");
  EXPECT_EQ(run("pgrep -f '^sleep 432[1-3]$'").output, "");
}

TEST(Doctor, WhatCannotBeRun) {
  expect(doctor("no-such-program"), 127, "no-such-program is not found");
  expect(doctor("/etc"), 126, "is a folder");
  expect(doctor("--stats /tmp/s.json true"), 2, "leave out --stats");
  expect(doctor("--seconds 0 true"), 2, "--seconds");
  expect(doctor(""), 2, "glark doctor [OPTIONS] PROGRAM");
}

}  // namespace glark::test
