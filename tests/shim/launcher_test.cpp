// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/shim/process.h"

namespace glark::test {
namespace {

Outcome glark(const std::string& arguments) { return run(GLARK_TOOL " " + arguments); }

void expect_refused(const std::string& arguments, int status, const std::string& message) {
  const Outcome outcome = glark(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.output;
  EXPECT_TRUE(outcome.output.starts_with("glark: ")) << outcome.output;
  EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
}

}  // namespace

TEST(Launcher, TheExitStatusIsTheProgramsOwn) { EXPECT_EQ(glark("run sh -c 'exit 7'").status, 7); }

TEST(Launcher, OptionsBecomeTheEnvironment) {
  const Outcome outcome = glark(
      "run --level 3 --max-level=5 --refine pn --wireframe --log info --stats /tmp/s.json --capture 2:/tmp/a.png "
      "--capture 3:/tmp/b,c.png env");
  for (const char* line :
       {"GLARK_ENABLE=1\n", "GLARK_LEVEL=3\n", "GLARK_MAX_LEVEL=5\n", "GLARK_REFINE=pn\n", "GLARK_WIREFRAME=1\n",
        "GLARK_LOG=info\n", "GLARK_STATS=/tmp/s.json\n", "GLARK_CAPTURE=2:/tmp/a.png,3:/tmp/b,c.png\n"})
    EXPECT_NE(outcome.output.find(line), std::string::npos) << line << outcome.output;
}

TEST(Launcher, WhatFollowsTheProgramIsItsOwn) {
  EXPECT_EQ(glark("run echo --level 99 -- --help").output, "--level 99 -- --help\n");
  EXPECT_EQ(glark("run --level 1 -- echo -n x").output, "x");
}

TEST(Launcher, OtherPreloadsAreKept) {
  EXPECT_EQ(run("env LD_PRELOAD=libm.so.6 " GLARK_TOOL " run printenv LD_PRELOAD").output,
            GLARK_LIBRARY ":libm.so.6\n");
}

TEST(Launcher, AMissingProgramIs127) { expect_refused("run no-such-program", 127, "no-such-program is not found"); }
TEST(Launcher, AProgramThatIsNotExecutableIs126) {
  expect_refused("run /etc/passwd", 126, "/etc/passwd cannot be run: Permission denied");
}
TEST(Launcher, AFolderIs126) { expect_refused("run /etc", 126, "/etc is a folder; name a program in it"); }
TEST(Launcher, AScriptWithoutItsInterpreterIs126) {
  const std::string script = PROGRAM_FOLDER "/script_for_nobody";
  run("printf '#!/nowhere/perl\\n' > " + script + "; chmod +x " + script);
  expect_refused("run " + script, 126, "is a script for /nowhere/perl, which is not installed");
}
TEST(Launcher, AStaticProgramIsTold) {
  const std::string folder = PROGRAM_FOLDER;
  const Outcome built = run("echo 'int main(void) { return 5; }' > " + folder + "/static.c && cc -static " + folder +
                            "/static.c -o " + folder + "/static");
  if (built.status != 0) GTEST_SKIP() << "no static C library here";
  const Outcome outcome = glark("run " + folder + "/static");
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.output.find("is linked statically"), std::string::npos) << outcome.output;
}
TEST(Launcher, AnUnknownOptionIs2) { expect_refused("run --depth 3 true", 2, "--depth"); }
TEST(Launcher, AnUnknownOptionIsToldWithTheNearest) {
  expect_refused("run --levle 3 true", 2, "there is no option --levle; is --level meant?");
}
TEST(Launcher, AWrongPatternNamesItsHelp) { expect_refused("pattern abc", 2, "glark pattern --help"); }
TEST(Launcher, APatternIsSvg) { expect_refused("pattern 1 2 3 -o drawing.png", 2, "name it FILE.svg"); }
TEST(Launcher, AnUnknownCommandIs2) { expect_refused("walk", 2, "walk"); }
TEST(Launcher, NoCommandIs2) { expect_refused("", 2, "glark --help"); }
TEST(Launcher, NoProgramIs2) { expect_refused("run --level 2", 2, "no program"); }
TEST(Launcher, ALevelBeyondTheLimitIs2) {
  expect_refused("run --level 12 true", 2, "\"12\" is not valid; an integer from 0 to 11 is needed");
}
TEST(Launcher, AnUnknownRefinementIs2) {
  expect_refused("run --refine cubic true", 2, "smooth, linear, outputs, pn, stpn or phong");
}
TEST(Launcher, ACaptureWithoutAFrameIs2) { expect_refused("run --capture a.png true", 2, "FRAME:FILE.png"); }
TEST(Launcher, ACaptureFolderThatIsMissingIs2) {
  expect_refused("run --capture 1:/nowhere/a.png true", 2, "/nowhere cannot be written");
}
TEST(Launcher, AStatisticsFolderThatIsMissingIs2) {
  expect_refused("run --stats /nowhere/s.json true", 2, "/nowhere cannot be written");
}

TEST(Launcher, AMissingLibraryIs2) {
  const Outcome outcome = run("env GLARK_LIBRARY=/nowhere/libGLARK.so " GLARK_TOOL " run true");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.output.find("GLARK_LIBRARY names /nowhere/libGLARK.so, which does not exist"), std::string::npos)
      << outcome.output;
}

TEST(Launcher, HelpAndVersionSucceed) {
  EXPECT_EQ(glark("--help").status, 0);
  EXPECT_EQ(glark("run --help").status, 0);
  EXPECT_TRUE(glark("--version").output.starts_with("glark "));
}

TEST(Launcher, InfoNamesTheRenderer) {
  const Outcome outcome = glark("info");
  EXPECT_LE(outcome.status, 1);
  for (const char* way : {"GLX\n", "OSMesa\n", "EGL without a surface, OpenGL\n"})
    EXPECT_NE(outcome.output.find(way), std::string::npos) << outcome.output;
}

TEST(Launcher, InfoSaysWhyThereIsNoGlx) {
  EXPECT_NE(run("env -u DISPLAY " GLARK_TOOL " info").output.find("GLX\n  not available here: DISPLAY is not set"),
            std::string::npos);
  EXPECT_NE(run("env DISPLAY=:7654 " GLARK_TOOL " info").output.find("GLX\n  not available here: "), std::string::npos);
}

}  // namespace glark::test
