// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs make, share, move (between threads and processes) and leave contexts in many ways. They must see the same
// colours, errors and debug messages without the shim, with the shim off, and with refinement.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/shim/process.h"

namespace glark::test {
namespace {

struct Case {
  const char* name;
  int refined;  // draws of the process that writes the statistics last
};

std::string program(const std::string& name) { return PROGRAM_FOLDER "/shim_contexts " + name; }

}  // namespace

class Contexts : public testing::TestWithParam<Case> {};

TEST_P(Contexts, TheProgramSeesTheSame) {
  const Outcome without = run(program(GetParam().name));
  if (without.status == 3) GTEST_SKIP() << "no such context here";
  ASSERT_EQ(without.status, 0) << without.output;

  const Outcome off = run_preloaded(program(GetParam().name));
  EXPECT_EQ(off.status, 0);
  EXPECT_EQ(off.output, without.output);

  const std::string file =
      testing::TempDir() + "contexts" + std::to_string(getpid()) + GetParam().name + std::string(".json");
  const Outcome refined =
      run_preloaded(program(GetParam().name),
                    "GLARK_ENABLE=1 GLARK_REFINE=linear GLARK_EVERYTHING=1 GLARK_CONFIG=/dev/null GLARK_STATS=" + file);
  EXPECT_EQ(refined.status, 0);
  EXPECT_EQ(refined.output, without.output);
  const nlohmann::json statistics = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(statistics["draws"]["refined"], GetParam().refined);
  std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Cases, Contexts,
                         testing::Values(Case{"robust", 2}, Case{"no_error", 1}, Case{"debug", 12}, Case{"share", 3},
                                         Case{"uniform", 3}, Case{"move", 2}, Case{"terminate", 3}, Case{"process", 2}),
                         [](const auto& given) { return std::string(given.param.name); });

// The context of the widget shows nothing itself. A mesh waits for two frames; the other four are curved.
void expect_draws(const std::string& program, int waiting, int refined) {
  const std::string file = testing::TempDir() + "widget" + std::to_string(getpid()) + ".json";
  const Outcome outcome = run_preloaded(
      program,
      "GLARK_ENABLE=1 GLARK_REFINE=smooth GLARK_WAIT=1 GLARK_LEVEL=2 GLARK_CONFIG=/dev/null GLARK_STATS=" + file);
  if (outcome.status == 3) GTEST_SKIP() << "no such context here";
  EXPECT_EQ(outcome.output, "error 0\n");
  const nlohmann::json draws = nlohmann::json::parse(read_file(file))["draws"];
  EXPECT_EQ(draws["refined"], refined);
  EXPECT_EQ(draws["passed_through"]["mesh_waits"], waiting);
  std::filesystem::remove(file);
}

TEST(Widgets, TheirFramesEndWhenAnotherContextShowsThem) { expect_draws(PROGRAM_FOLDER "/shim_widget", 2, 4); }

// After eight frames of the other context, the swap at the start no longer counts.
TEST(Widgets, ASwapAtTheStartDelaysThem) { expect_draws(PROGRAM_FOLDER "/shim_widget swapped", 9, 5); }

}  // namespace glark::test
