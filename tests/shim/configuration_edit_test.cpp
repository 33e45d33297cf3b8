// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/edit/configuration_edit.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "glark/settings/configuration.h"
#include "glark/settings/table.h"

namespace glark::settings {
namespace {

const std::vector<ChangedSetting> level_3{{"level", "3"}};

core::DrawRule some_rule() {
  return {.program = 0x1234, .depth_test = true, .depth_function = GL_LEQUAL, .viewport = std::array{640U, 480U}};
}

// The options of `program` after the text, and no problem.
core::ContextOptions read(const std::string& text, const std::string& program) {
  Settings settings;
  apply_defaults(settings);
  std::vector<std::string> problems;
  const std::vector names{program};
  apply_configuration(text, "test", names, settings, problems);
  EXPECT_TRUE(problems.empty()) << problems.front() << '\n' << text;
  return settings.context;
}

std::string file_text(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class WrittenConfiguration : public testing::Test {
 protected:
  ~WrittenConfiguration() override { std::filesystem::remove_all(folder_); }
  std::string folder_ = testing::TempDir() + "configuration" + std::to_string(getpid());
  std::string file_ = folder_ + "/glark/glark.toml";
};

}  // namespace

TEST(ChangedSettings, OnlyWhatDiffers) {
  const core::ContextOptions before;
  core::ContextOptions after;
  EXPECT_TRUE(changed_settings(before, after).empty());
  after.level = 4;
  after.measure.pixels = 0.1F;
  after.smooth = true;
  after.live.paused = true;
  const std::vector<ChangedSetting> changed = changed_settings(before, after);
  ASSERT_EQ(changed.size(), 3U);
  EXPECT_EQ(changed[0].value, "\"smooth\"");
  EXPECT_EQ(changed[1].key, "level");
  EXPECT_EQ(changed[2].value, "0.1");
}

// Each line that can be written is a value of its setting.
TEST(ChangedSettings, TheirTextsAreRead) {
  core::ContextOptions before;
  core::ContextOptions after;
  after.level = 5;
  after.max_level = 7;
  after.measure = {.pixels = 8, .degrees = 22.5F, .error = 0.25F, .budget = 250000};
  after.geomorph = after.wireframe = after.smooth = true;
  after.refinement = core::Refinement::pn;
  after.crease = 33;
  const std::vector<ChangedSetting> changed = changed_settings(before, after);
  const core::ContextOptions again = read(with_settings("", "prog", changed, {}), "prog");
  EXPECT_EQ(changed.size(), 10U);
  EXPECT_TRUE(changed_settings(after, again).empty());
}

TEST(ConfigurationEdit, AnEmptyFileGetsATable) {
  EXPECT_EQ(with_settings("", "prog", level_3, {}), "[program.prog]\nlevel = 3\n");
}

TEST(ConfigurationEdit, OtherLinesStay) {
  const std::string text =
      "# mine\nlevel = 1\n[program.prog]  # fast\ncrease = 30\n level = 2 # old\n[program.other]\nlevel = 5\n";
  const std::string edited = with_settings(text, "prog", level_3, {});
  EXPECT_EQ(edited, "# mine\nlevel = 1\n[program.prog]  # fast\ncrease = 30\nlevel = 3\n[program.other]\nlevel = 5\n");
  EXPECT_EQ(read(edited, "prog").level, 3U);
  EXPECT_EQ(read(edited, "other").level, 5U);
}

TEST(ConfigurationEdit, ATableWithOtherKeysGetsTheKey) {
  const std::string edited = with_settings("[program.\"my prog\"]\ncrease = 30\n", "my prog", level_3, {});
  EXPECT_EQ(edited, "[program.\"my prog\"]\nlevel = 3\ncrease = 30\n");
}

TEST(ConfigurationEdit, NamesAreQuotedIfTheyMustBe) {
  const std::string edited = with_settings("", "a.b \"c\"", level_3, {});
  EXPECT_EQ(read(edited, "a.b \"c\"").level, 3U) << edited;
}

TEST(ConfigurationEdit, RulesAreAddedAtTheEnd) {
  const std::vector rules{some_rule()};
  const std::string edited = with_settings("[program.prog]\nlevel = 1\n", "prog", level_3, rules);
  const core::ContextOptions options = read(edited, "prog");
  EXPECT_EQ(options.level, 3U);
  EXPECT_EQ(options.rules, rules);
}

TEST(ConfigurationEdit, ATableMayFollowItsRules) {
  const std::vector rules{some_rule()};
  const std::string edited = with_settings(with_settings("", "prog", {}, rules), "prog", level_3, {});
  EXPECT_EQ(read(edited, "prog").level, 3U) << edited;
  EXPECT_EQ(read(edited, "prog").rules, rules);
}

TEST_F(WrittenConfiguration, MakesItsFolder) {
  EXPECT_EQ(write_configuration(file_, "prog", level_3, {}), "");
  EXPECT_EQ(file_text(file_), "[program.prog]\nlevel = 3\n");
}

TEST_F(WrittenConfiguration, ALinkAndItsModeStay) {
  ASSERT_EQ(write_configuration(file_, "prog", level_3, {}), "");
  chmod(file_.c_str(), 0640);
  const std::string link = folder_ + "/link.toml";
  std::filesystem::create_symlink(file_, link);
  EXPECT_EQ(write_configuration(link, "prog", std::vector<ChangedSetting>{{"level", "4"}}, {}), "");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(file_text(file_), "[program.prog]\nlevel = 4\n");
  EXPECT_EQ(std::filesystem::status(file_).permissions(), std::filesystem::perms{0640});
}

TEST_F(WrittenConfiguration, ATextThatWouldBeReadOtherwiseIsRefused) {
  std::filesystem::create_directories(folder_ + "/glark");
  std::ofstream(file_) << "program.prog = { level = 1 }\n";  // an inline table cannot be extended
  const std::string problem = write_configuration(file_, "prog", level_3, {});
  EXPECT_NE(problem.find("edit it by hand"), std::string::npos) << problem;
  EXPECT_EQ(file_text(file_), "program.prog = { level = 1 }\n");
}

TEST_F(WrittenConfiguration, AFolderInItsPlaceIsRefused) {
  std::filesystem::create_directories(file_);
  EXPECT_NE(write_configuration(file_, "prog", level_3, {}).find("folder"), std::string::npos);
  EXPECT_NE(write_configuration("", "prog", level_3, {}), "");
}

TEST(WritableConfiguration, IsInTheUsersFolder) {
  const std::vector<const char*> home{"HOME=/nonexistent", nullptr};
  EXPECT_EQ(writable_configuration(home.data()), "/nonexistent/.config/glark/glark.toml");
  const std::vector<const char*> named{"HOME=/nonexistent", "GLARK_CONFIG=/nonexistent/my.toml", nullptr};
  EXPECT_EQ(writable_configuration(named.data()), "/nonexistent/my.toml");
  const std::vector<const char*> none{nullptr};
  EXPECT_EQ(writable_configuration(none.data()), "");
}

}  // namespace glark::settings
