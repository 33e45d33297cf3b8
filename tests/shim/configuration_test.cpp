// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/configuration.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "glark/settings/table.h"

namespace glark::settings {
namespace {

namespace fs = std::filesystem;

struct Applied {
  Settings settings;
  std::vector<std::string> problems;
};

Applied apply(std::string_view text, const std::vector<std::string>& names = {"gears"}) {
  Applied applied;
  apply_configuration(text, "f.toml", names, applied.settings, applied.problems);
  return applied;
}

// A folder of this process, deleted at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("glark-configuration-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string write(const std::string& name, const std::string& text) const {
    const fs::path file = path_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }
  std::string path(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

Parsed parse_with(const std::vector<std::string>& environment) {
  std::vector<const char*> pointers;
  for (const std::string& entry : environment) pointers.push_back(entry.c_str());
  pointers.push_back(nullptr);
  const std::vector<std::string> names{"gears"};
  return parse(pointers.data(), names);
}

}  // namespace

TEST(Configuration, EveryKindOfValueIsTaken) {
  const Applied applied = apply(
      "level = 3\nmax-level = \"7\"\nrefine = \"pn\"\nwireframe = true\nno-weld = true\nnormal = 2\nposition = 'v'\n"
      "leave-shaders = ['00000000000000ff', 'abcdefabcdefabcd']\nleave-draws = [\"blended\", \"overlays\"]\n");
  EXPECT_EQ(applied.problems, std::vector<std::string>());
  const core::ContextOptions& context = applied.settings.context;
  EXPECT_EQ(context.level, 3u);
  EXPECT_EQ(context.max_level, 7u);
  EXPECT_EQ(context.refinement, core::Refinement::pn);
  EXPECT_TRUE(context.wireframe);
  EXPECT_FALSE(context.weld);
  EXPECT_TRUE(core::ContextOptions{}.weld);
  EXPECT_EQ(context.roles, (core::AttributeRoles{"v", "2", ""}));
  EXPECT_EQ(context.left_shaders, (std::vector<std::uint64_t>{0xff, 0xabcdefabcdefabcd}));
  EXPECT_EQ(context.left_draws, core::left_draws::blended | core::left_draws::overlays);
}

TEST(Configuration, TheProgramsTableWinsWhereverItStands) {
  EXPECT_EQ(apply("level = 1\n[program.gears]\nlevel = 4\n[program.other]\nlevel = 5\n").settings.context.level, 4u);
  EXPECT_EQ(apply("[program.gears]\nlevel = 4\n[program]\nother.level = 5\n").settings.context.level, 4u);
}

TEST(Configuration, TheMoreSpecificNameWins) {
  const char* text = "[program.\"view.py\"]\nlevel = 4\n[program.python3]\nlevel = 1\n";
  EXPECT_EQ(apply(text, {"python3", "view.py"}).settings.context.level, 4u);
}

TEST(Configuration, AWrongValueIsNamedWithItsPlaceAndTheRestCounts) {
  const Applied applied = apply("max-level = 5\n  level = 12\nrefine = 'pn'\n[program.gears]\nlevel = 1979-05-27\n");
  EXPECT_EQ(applied.problems, (std::vector<std::string>{
                                  "f.toml:2:11: level is \"12\"; an integer from 0 to 11 is needed",
                                  "f.toml:5:9: level has a value of another kind; an integer from 0 to 11 is needed"}));
  EXPECT_EQ(applied.settings.context.level, 2u);
  EXPECT_EQ(applied.settings.context.max_level, 5u);
  EXPECT_EQ(applied.settings.context.refinement, core::Refinement::pn);
}

TEST(Configuration, AnUnknownKeyIsNamedBesideTheKnownOnes) {
  const Applied applied = apply("levle = 3\nconfig = 'x'\nprogram = 1\n");
  ASSERT_EQ(applied.problems.size(), 3u);
  EXPECT_TRUE(applied.problems[0].starts_with("f.toml:2:10: there is no key \"config\"; the keys are level, max-level"))
      << applied.problems[0];
  EXPECT_TRUE(applied.problems[1].starts_with("f.toml:1:9: there is no key \"levle\"")) << applied.problems[1];
  EXPECT_TRUE(applied.problems[2].starts_with("f.toml:3:11: program is not a table")) << applied.problems[2];
}

TEST(Configuration, ALineThatIsNoTomlLeavesTheOthers) {
  const Applied applied =
      apply("level = \nmax-level = 9\n[program.gears]\nrefine = 'pn'\nlevel = = 3\nwireframe = true");
  ASSERT_EQ(applied.problems.size(), 2u);
  EXPECT_TRUE(applied.problems[0].starts_with("f.toml:1:")) << applied.problems[0];
  EXPECT_TRUE(applied.problems[1].starts_with("f.toml:5:")) << applied.problems[1];
  EXPECT_EQ(applied.settings.context.max_level, 9u);
  EXPECT_EQ(applied.settings.context.refinement, core::Refinement::pn);
  EXPECT_TRUE(applied.settings.context.wireframe);
}

TEST(Configuration, TheKeysAfterAWrongHeaderGoToNoProgram) {
  const Applied applied = apply("[program.gears]\nmax-level = 9\n[program.other\nlevel = 5\n");
  EXPECT_EQ(applied.problems.size(), 1u);
  EXPECT_EQ(applied.settings.context.level, 2u);
  EXPECT_EQ(applied.settings.context.max_level, 9u);
}

TEST(Configuration, ATruncatedFileKeepsWhatIsComplete) {
  const std::string text = "level = 3\n[program.gears]\nmax-level = 9\nposition = \"ver";
  const Applied applied = apply(text);
  EXPECT_EQ(applied.problems.size(), 1u);
  EXPECT_EQ(applied.settings.context.level, 3u);
  EXPECT_EQ(applied.settings.context.max_level, 9u);
  for (std::size_t size = 0; size < text.size(); ++size) apply(text.substr(0, size));
}

TEST(Configuration, HostileFilesAreSurvived) {
  std::string keys = "a";
  for (int i = 0; i < 100000; ++i) keys += ".a";
  EXPECT_EQ(apply(keys + " = 1\n").problems.size(), 1u);
  EXPECT_FALSE(apply("level = " + std::string(100000, '[')).problems.empty());
  EXPECT_FALSE(apply("\xff\xfe\x01").problems.empty());
  EXPECT_FALSE(apply("\xd2\x94 = 1\n").problems.empty());
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "[[x\n";
  EXPECT_LT(apply(many).problems.size(), 100u);
}

TEST(Configuration, VariablesWinOverTheProgramsTable) {
  const Folder folder;
  const std::string file = folder.write("c.toml", "level = 1\nrefine = 'pn'\n[program.gears]\nlevel = 4\n");
  EXPECT_EQ(parse_with({"GLARK_CONFIG=" + file}).settings.context.level, 4u);
  const Parsed parsed = parse_with({"GLARK_CONFIG=" + file, "GLARK_LEVEL=5"});
  EXPECT_EQ(parsed.settings.context.level, 5u);
  EXPECT_EQ(parsed.settings.context.refinement, core::Refinement::pn);
}

TEST(Configuration, IsLookedForInTheXdgFolders) {
  const Folder folder;
  folder.write("system/glark/glark.toml", "level = 1\n");
  const std::string directories = "XDG_CONFIG_DIRS=relative:" + folder.path("none") + ":" + folder.path("system");
  const std::string home = "HOME=" + folder.path("home");
  EXPECT_EQ(parse_with({home, directories}).settings.context.level, 1u);
  folder.write("home/.config/glark/glark.toml", "level = 3\n");
  EXPECT_EQ(parse_with({home, directories}).settings.context.level, 3u);
  folder.write("own/glark/glark.toml", "level = 4\n");
  EXPECT_EQ(parse_with({home, directories, "XDG_CONFIG_HOME=" + folder.path("own")}).settings.context.level, 4u);
}

TEST(Configuration, AFileThatCannotBeReadIsTold) {
  const Folder folder;
  const auto problem = [](const std::string& file) {
    const Parsed parsed = parse_with({"GLARK_CONFIG=" + file});
    return parsed.problems.size() == 1 ? parsed.problems[0] : "";
  };
  EXPECT_EQ(problem("/nowhere/c.toml"),
            "the configuration file /nowhere/c.toml cannot be read: No such file or directory; it is not used");
  EXPECT_NE(problem(folder.path("")).find("it is a folder"), std::string::npos);
  EXPECT_NE(problem("/dev/zero").find("longer than"), std::string::npos);
  EXPECT_TRUE(parse_with({"GLARK_CONFIG=/dev/null"}).problems.empty());
}

TEST(Configuration, EverythingLeavesNothingAlone) {
  const Parsed parsed =
      parse_with({"GLARK_LEAVE_DRAWS=blended", "GLARK_LEAVE_SHADERS=0123456789abcdef", "GLARK_EVERYTHING=1"});
  EXPECT_EQ(parsed.problems.size(), 2u);
  EXPECT_EQ(parsed.settings.context.left_draws, 0u);
  EXPECT_TRUE(parsed.settings.context.left_shaders.empty());
}

TEST(Configuration, OnlyAFileThatIsIdleByItselfIsTold) {
  const Folder folder;
  const std::string alone = "GLARK_CONFIG=" + folder.write("a.toml", "budget = 9\n");
  EXPECT_EQ(parse_with({"GLARK_ENABLE=1", alone}).problems.size(), 1u);
  const std::string whole = "GLARK_CONFIG=" + folder.write("b.toml", "tension = 0.5\nrefine = 'stpn'\n");
  EXPECT_TRUE(parse_with({"GLARK_ENABLE=1", whole, "GLARK_REFINE=pn"}).problems.empty());
}

TEST(Configuration, AWrongKeyIsToldWithTheNearest) {
  const Applied applied = apply("max_level = 3\n");
  ASSERT_EQ(applied.problems.size(), 1u);
  EXPECT_TRUE(
      applied.problems[0].starts_with("f.toml:1:13: there is no key \"max_level\"; is \"max-level\" meant? the keys"))
      << applied.problems[0];
}

TEST(Configuration, RulesOfTheProgramComeFirst) {
  const Applied applied = apply(
      "[[rule]]\ndepth-only = true\nrefine = 'outputs'\n[[rule]]\nblend = false\nviewport = [64, 32]\nrefine = 'none'\n"
      "[[program.gears.rule]]\nprogram = '00000000000000ff'\ndepth-function = 'equal'\nrefine = 'pn'\n");
  EXPECT_EQ(applied.problems, std::vector<std::string>());
  const std::vector<core::DrawRule> expected{
      {.program = 255, .depth_function = GL_EQUAL, .refinement = core::Refinement::pn},
      {.depth_only = true, .refinement = core::Refinement::linear_outputs},
      {.blend = false, .viewport = std::array<unsigned, 2>{64, 32}, .refinement = std::nullopt}};
  EXPECT_EQ(applied.settings.context.rules, expected);
}

TEST(Configuration, AWrongRuleIsNamedWithItsPlaceAndLeftOut) {
  const auto problem = [](const std::string& text) {
    const Applied applied = apply(text);
    EXPECT_TRUE(applied.settings.context.rules.empty());
    return applied.problems.empty() ? std::string() : applied.problems[0];
  };
  EXPECT_TRUE(problem("[[rule]]\ndepthonly = true\nrefine = 'pn'\n")
                  .starts_with("f.toml:2:13: there is no key \"depthonly\" in a rule"));
  EXPECT_EQ(problem("\n[[rule]]\nblend = 'often'\nrefine = 'pn'\n"),
            "f.toml:3:9: blend is not valid; true or false is needed");
  EXPECT_EQ(problem("[[rule]]\nviewport = [64]\nrefine = 'pn'\n"),
            "f.toml:2:12: viewport is not valid; a width and a height, like [1024, 1024] is needed");
  EXPECT_EQ(problem("[[rule]]\nblend = true\n"), "f.toml:1:1: the rule has no refine; none or a refinement is needed");
  EXPECT_EQ(problem("[[rule]]\nrefine = 'pn'\n"),
            "f.toml:1:1: the rule has no condition; without a rule, refine is the key for all draws");
  EXPECT_TRUE(problem("rule = 3\n").starts_with("f.toml:1:8: rule is not a list of tables"));
}

TEST(Configuration, EverythingDropsRulesThatLeaveDraws) {
  const Folder folder;
  const std::string file =
      folder.write("c.toml", "[[rule]]\nblend = true\nrefine = 'none'\n[[rule]]\nblend = true\nrefine = 'pn'\n");
  EXPECT_EQ(parse_with({"GLARK_ENABLE=1", "GLARK_CONFIG=" + file}).settings.context.rules.size(), 2u);
  EXPECT_EQ(parse_with({"GLARK_ENABLE=1", "GLARK_EVERYTHING=1", "GLARK_CONFIG=" + file}).settings.context.rules.size(),
            1u);
}

TEST(Configuration, AProgramThatIsLeftAloneIsNotTransparent) {
  const Folder folder;
  const std::string file = folder.write("c.toml", "[program.gears]\nleave-alone = true\n");
  EXPECT_FALSE(parse_with({"GLARK_ENABLE=1", "GLARK_CONFIG=" + file}).settings.context.transparent);
}

TEST(Table, EachSettingHasAnOptionAVariableAndWords) {
  for (const Setting& setting : table()) {
    EXPECT_TRUE(std::string_view(setting.variable).starts_with("GLARK_")) << setting.key;
    EXPECT_EQ(find_setting(setting.key), &setting);
    EXPECT_EQ(setting.kind == Kind::toggle, setting.value.empty()) << setting.key;
    Settings scratch;
    EXPECT_TRUE(setting.key == "config" || !setting.read(scratch, std::string_view("\0?", 2))) << setting.key;
  }
}

TEST(ProgramNames, AreThoseOfTheFileAndTheCall) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(program_names("/usr/bin/busybox", Names{"/usr/bin/gears", "-x"}), (Names{"busybox", "gears"}));
  EXPECT_EQ(program_names("", Names{}), Names());
}

TEST(ProgramNames, AnInterpreterIsCalledByWhatItRuns) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(program_names("/usr/bin/python3.11", Names{"python3", "-u", "/opt/view.py", "a.py"}),
            (Names{"python3.11", "python3", "view.py", "view"}));
  EXPECT_EQ(program_names("/usr/bin/python3.11", Names{"python3", "-m", "viewer"}),
            (Names{"python3.11", "python3", "viewer"}));
  EXPECT_EQ(program_names("/usr/bin/python3.11", Names{"python3", "-c", "x"}), (Names{"python3.11", "python3"}));
  EXPECT_EQ(program_names("/usr/lib/wine/wine64-preloader", Names{"C:\\games\\Bowl.exe"}),
            (Names{"wine64-preloader", "Bowl.exe", "Bowl"}));
}

}  // namespace glark::settings
