// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program may find its GL functions in many ways. glark wraps them in each case, and the picture is the same.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/shim/process.h"

namespace glark::test {
namespace {

constexpr char drawn[] = "color 255 0 0\nerror 0\nextension yes\n";

std::string program(const std::string& name) { return PROGRAM_FOLDER "/" + name; }

}  // namespace

TEST(Reach, WithoutTheShimThereIsNoExtension) {
  EXPECT_NE(run(program("shim_linked")).output.find("extension no"), std::string::npos);
}

TEST(Reach, ByLinking) {
  const Outcome outcome = run_preloaded(program("shim_linked"));
  EXPECT_EQ(outcome.output, drawn);
}

TEST(Reach, ALibraryThatIsLinkedBehindGlIsTold) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the run time of a sanitizer must be the first library of the process";
#endif
  const Outcome wrong = run(program("shim_wrong_order"));
  EXPECT_TRUE(wrong.output.starts_with("glark: this program was linked with libGLARK.so behind ")) << wrong.output;
  EXPECT_NE(wrong.output.find("name -lGLARK before the GL library"), std::string::npos) << wrong.output;
  EXPECT_EQ(wrong.output.find("glark: ", 1), std::string::npos) << wrong.output;  // once
  EXPECT_NE(wrong.output.find("extension no"), std::string::npos) << wrong.output;
  EXPECT_EQ(run(program("shim_right_order")).output, drawn);
  EXPECT_EQ(run_preloaded(program("shim_wrong_order")).output, drawn);
  EXPECT_EQ(run("GLARK_LOG=error " + program("shim_wrong_order")).output.find("glark: "), std::string::npos);
}

class ReachByLookup : public testing::TestWithParam<const char*> {};

TEST_P(ReachByLookup, TheWrapperIsFound) {
  const Outcome outcome = run_preloaded(program("shim_unlinked ") + GetParam());
  EXPECT_EQ(outcome.output, std::string("glDrawArrays is ours\nglClear is the driver's\nglDrawARP is ours\n") + drawn);
}

INSTANTIATE_TEST_SUITE_P(Ways, ReachByLookup, testing::Values("dlsym", "dlvsym", "get_proc"),
                         [](const auto& way) { return std::string(way.param); });

TEST(Reach, ThroughAPluginThatIsLinked) {
  EXPECT_EQ(run_preloaded(program("shim_unlinked plugin ") + PLUGIN).output, drawn);
}

TEST(Reach, DeepBindIsDropped) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer refuses RTLD_DEEPBIND before we can drop it";
#endif
  EXPECT_EQ(run_preloaded(program("shim_unlinked deepbind ") + PLUGIN).output, drawn);
}

TEST(Reach, NextIsPassedThroughAndAnUnseenContextIsAdopted) {
  EXPECT_EQ(run_preloaded(program("shim_next_main")).output, "next glDrawArrays is the driver's\nadopted yes\n");
}

TEST(Reach, EglInBothApis) {
  const Outcome without = run(program("shim_egl"));
  if (without.status == 3) GTEST_SKIP() << "no EGL without a surface here";
  EXPECT_EQ(run_preloaded(program("shim_egl")).output, "gl extension yes\nes extension yes\n");
}

TEST(Reach, ThreadsThatShareAndDestroyContexts) {
  const Outcome outcome = run_preloaded(program("shim_threads"));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output, "done\n");
}

TEST(Dump, OriginalAndDerivedShadersLieSideBySideUnderTheHashOfTheStatistics) {
  const std::string folder = PROGRAM_FOLDER "/shaders/of it";
  const std::string statistics = PROGRAM_FOLDER "/dump.json";
  std::filesystem::remove_all(PROGRAM_FOLDER "/shaders");
  const Outcome outcome = run_preloaded(
      program("shim_linked"),
      "GLARK_ENABLE=1 GLARK_REFINE=linear GLARK_EVERYTHING=1 GLARK_CONFIG=/dev/null GLARK_STATS=" + statistics +
          " GLARK_DUMP_SHADERS='" + folder + "'");
  EXPECT_EQ(outcome.output, drawn);
  const auto shaders = nlohmann::json::parse(read_file(statistics))["shaders"];
  ASSERT_EQ(shaders.size(), 1u) << shaders;
  EXPECT_EQ(shaders.begin().value()["seen"], shaders.begin().value()["refined"]);
  const std::string name = folder + "/fixed-" + shaders.begin().key();
  EXPECT_NE(read_file(name + ".original.vert").find("void main"), std::string::npos);
  EXPECT_NE(read_file(name + ".linear.vert").find("glark_lattice"), std::string::npos);
}

TEST(Dump, AFolderThatCannotBeMadeIsToldOnceAndThePictureStays) {
  const Outcome outcome = run_preloaded(
      program("shim_linked"),
      "GLARK_ENABLE=1 GLARK_REFINE=linear GLARK_EVERYTHING=1 GLARK_CONFIG=/dev/null GLARK_DUMP_SHADERS=/dev/null/x");
  EXPECT_TRUE(outcome.output.ends_with(drawn)) << outcome.output;
  EXPECT_TRUE(outcome.output.starts_with("glark: error: shaders cannot be written to /dev/null/x")) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 4) << outcome.output;
}

TEST(Configuration, TheTableOfTheProgramIsFoundByItsName) {
  const std::string file = PROGRAM_FOLDER "/own.toml";
  const std::string statistics = PROGRAM_FOLDER "/own.json";
  std::ofstream(file) << "level = 12\neverything = true\n[program.shim_linked]\nleave-alone = true\n";
  const Outcome outcome =
      run_preloaded(program("shim_linked"), "GLARK_ENABLE=1 GLARK_CONFIG=" + file + " GLARK_STATS=" + statistics);
  EXPECT_EQ(outcome.output, "glark: " + file + ":1:9: level is \"12\"; an integer from 0 to 11 is needed\n" + drawn);
  EXPECT_EQ(nlohmann::json::parse(read_file(statistics))["draws"]["refined"], 0);
}

TEST(Statistics, ClassesHaveStateAndVerdict) {
  const std::string file = PROGRAM_FOLDER "/rules.toml";
  const std::string statistics = PROGRAM_FOLDER "/classes-%p.json";
  run("rm -f " PROGRAM_FOLDER "/classes-*.json");
  const auto classes = [&](const std::string& rule) {
    std::ofstream(file) << "[[rule]]\nfixed-function = true\n" + rule;
    run_preloaded(program("shim_linked"), "GLARK_ENABLE=1 GLARK_REFINE=linear GLARK_EVERYTHING=1 GLARK_CONFIG=" + file +
                                              " GLARK_STATS=" + statistics);
    auto json = nlohmann::json::parse(run("cat " PROGRAM_FOLDER "/classes-*.json").output, nullptr, false);
    run("rm -f " PROGRAM_FOLDER "/classes-*.json");
    return json;
  };
  const auto outputs = classes("refine = 'outputs'\n");
  ASSERT_FALSE(outputs.is_discarded());
  ASSERT_EQ(outputs["classes"].size(), 1u) << outputs;
  const auto& entry = outputs["classes"][0];
  EXPECT_EQ(entry["verdict"], "refined");
  EXPECT_EQ(entry["refinement"], "outputs");
  EXPECT_EQ(entry["fixed_function"], true);
  EXPECT_EQ(entry["draws"], outputs["draws"]["refined"]);
  EXPECT_EQ(entry["state"]["depth_only"], false);
  EXPECT_EQ(outputs["contexts"][0]["refinable"], true);
  EXPECT_EQ(outputs["last_frames"].size(), outputs["frames"]);
  for (const auto& frame : outputs["last_frames"]) EXPECT_EQ(frame["passed_through"].size(), 0u) << frame;
}

TEST(Statistics, ARuleLeavesDraws) {
  const std::string file = PROGRAM_FOLDER "/none.toml";
  const std::string statistics = PROGRAM_FOLDER "/none.json";
  std::ofstream(file) << "leave-draws = 'none'\n[[rule]]\nfixed-function = true\nrefine = 'none'\n";
  run_preloaded(program("shim_linked"), "GLARK_ENABLE=1 GLARK_CONFIG=" + file + " GLARK_STATS=" + statistics);
  const auto json = nlohmann::json::parse(read_file(statistics));
  EXPECT_EQ(json["draws"]["refined"], 0);
  EXPECT_EQ(json["draws"]["passed_through"]["rule"], json["draws"]["seen"]);
  EXPECT_EQ(json["classes"][0]["cause"], "rule");
}

TEST(Linker, ResultsAndErrorsAreThoseOfTheProgramAlone) {
  // Only the object that the message names may differ.
  const std::string without_objects = " | sed 's#[^ ]*: undefined#undefined#'";
  EXPECT_EQ(run_preloaded(program("shim_linker") + without_objects).output,
            run(program("shim_linker") + without_objects).output);
}

TEST(Linker, AFunctionThatTheProgramDefinesStaysItsOwn) {
  EXPECT_EQ(run_preloaded(program("shim_own_flush")).output, "flushed 3\n");
}

TEST(Linker, AProgramWithoutGlIsLeftAlone) {
  const std::string statistics = testing::TempDir() + "none.json";
  std::filesystem::remove(statistics);
  const Outcome outcome = run_preloaded("/bin/echo hello", "GLARK_STATS=" + statistics);
  EXPECT_EQ(outcome.output, "hello\n");
  EXPECT_FALSE(std::filesystem::exists(statistics));
}

TEST(Statistics, ADrawIsCounted) {
  const std::string file = testing::TempDir() + "draw" + std::to_string(getpid()) + ".json";
  run_preloaded(program("shim_linked"), "GLARK_ENABLE=1 GLARK_REFINE=linear GLARK_LEVEL=1 GLARK_STATS=" + file);
  const nlohmann::json statistics = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(statistics["draws"]["seen"], 1);
  EXPECT_EQ(statistics["frames"], 1);
}

TEST(Statistics, AFileThatCannotBeWrittenIsAMessageAndNoFailure) {
  const Outcome outcome = run_preloaded(program("shim_linked"), "GLARK_STATS=/nowhere/s.json");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("/nowhere/s.json"), std::string::npos) << outcome.output;
}

TEST(FrameCapture, TheFrameIsWritten) {
  const std::string file = testing::TempDir() + "frame" + std::to_string(getpid()) + ".png";
  run_preloaded(program("shim_linked"), "GLARK_CAPTURE=1:" + file);
  const std::string png = read_file(file);
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[19], 16);  // width
  EXPECT_EQ(png[23], 16);  // height
}

TEST(FrameCapture, AFileThatCannotBeWrittenIsAMessageAndNoFailure) {
  const Outcome outcome = run_preloaded(program("shim_linked"), "GLARK_CAPTURE=1:/nowhere/a.png");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("glark: error: frame 1 cannot be written to /nowhere/a.png: No such file or directory"),
            std::string::npos)
      << outcome.output;
}

TEST(FrameCapture, AFrameThatNeverCameIsTold) {
  const Outcome outcome = run_preloaded(program("shim_linked"), "GLARK_CAPTURE=2:/nowhere/b.png");
  EXPECT_EQ(
      outcome.output,
      "glark: frame 2 was not written to /nowhere/b.png: the program ended after frame 1; choose an earlier one\n" +
          std::string(drawn));
  EXPECT_EQ(run_preloaded("/bin/echo hello", "GLARK_CAPTURE=2:/nowhere/b.png").output, "hello\n");
}

TEST(Settings, ABadValueIsAMessageAndNoFailure) {
  const Outcome outcome = run_preloaded(program("shim_linked"), "GLARK_LEVEL=deep");
  EXPECT_EQ(outcome.output, std::string("glark: GLARK_LEVEL is \"deep\"; an integer from 0 to 11 is needed\n") + drawn);
}

}  // namespace glark::test
