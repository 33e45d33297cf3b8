// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/completion.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>

#include "glark/tool/help_topics.h"

namespace glark::tool {
namespace {

const std::vector<CommandLine> commands{{"run", "Run a program"}, {"help", "Explain"}};
const std::vector<std::string> topics{"level", "no_surface"};

std::string output_of(const std::string& command) {
  std::array<char, 4096> part{};
  std::string text;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

// Returns bash's completions of the last word.
std::string completed(const std::string& words) {
  const std::string file = testing::TempDir() + "glark_completion_" + std::to_string(getpid());
  std::ofstream(file) << bash_completion(commands, topics);
  std::string output = output_of("bash -c 'source " + file + "; COMP_WORDS=(" + words +
                                 "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _glark; "
                                 "((${#COMPREPLY[@]} == 0)) || printf \"%s \" \"${COMPREPLY[@]}\"'");
  std::remove(file.c_str());
  return output;
}

}  // namespace

TEST(Completion, WordsOfASettingAreItsValues) {
  const std::vector<std::string> log = words_of(*settings::find_setting("log"));
  EXPECT_EQ(log, (std::vector<std::string>{"error", "warning", "info", "debug"}));
  const std::vector<std::string> refine = words_of(*settings::find_setting("refine"));
  EXPECT_NE(std::find(refine.begin(), refine.end(), "smooth"), refine.end());
  EXPECT_NE(std::find(refine.begin(), refine.end(), "pn"), refine.end());
  EXPECT_TRUE(words_of(*settings::find_setting("level")).empty());
  EXPECT_TRUE(words_of(*settings::find_setting("wireframe")).empty());
  EXPECT_EQ(words_of(*settings::find_setting("leave-draws")).front(), "screen-quads");
  const std::vector<std::string> keys = words_of(*settings::find_setting("overlay-key"));
  EXPECT_EQ(keys.front(), "F1");
  EXPECT_NE(std::find(keys.begin(), keys.end(), "F12"), keys.end()) << "a range names each key";
}

TEST(Completion, BashCompletesCommandsOptionsAndValues) {
  EXPECT_EQ(completed("glark r"), "run ");
  EXPECT_EQ(completed("glark run --wiref"), "--wireframe ");
  EXPECT_EQ(completed("glark run --log d"), "debug ");
  EXPECT_EQ(completed("glark help no"), "no_surface ");
  EXPECT_EQ(completed("glark run --level 2 --log inf"), "info ");
}

TEST(Completion, BashLeavesTheProgramsArgumentsAlone) {
  EXPECT_EQ(completed("glark run --level 2 prog --wiref"), "");
  EXPECT_EQ(completed("glark run -- prog --wiref"), "");
}

TEST(Completion, ZshHasEachOption) {
  const std::string script = zsh_completion(commands, topics);
  for (const settings::Setting& setting : settings::table())
    EXPECT_NE(script.find("--" + std::string(setting.key) + "["), std::string::npos) << setting.key;
  EXPECT_NE(script.find(":LEVEL:(error warning info debug)'"), std::string::npos);
}

TEST(HelpTopics, EachHasAPage) {
  const std::vector<std::string> names = help_topics();
  EXPECT_GT(names.size(), 60U);
  for (const std::string& name : names) {
    const auto page = help_on(name, false);
    ASSERT_TRUE(page) << name;
    EXPECT_NE(page->find(name), std::string::npos);
    EXPECT_EQ(page->find('\033'), std::string::npos);
  }
}

TEST(HelpTopics, OptionsMayHaveTheirDashes) {
  EXPECT_EQ(help_on("--crease", false), help_on("crease", false));
  EXPECT_NE(help_on("crease", true)->find("\033[1m"), std::string::npos);
  EXPECT_EQ(help_on("creese", false), std::nullopt);
  EXPECT_EQ(nearest_topic("creese"), "crease");
}

}  // namespace glark::tool
