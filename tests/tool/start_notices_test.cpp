// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/start/notices.h"

#include <elf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace glark::tool {
namespace {

namespace fs = std::filesystem;
using Kind = ProgramFile::Kind;

const std::vector<ElfFile> library{{.machine = EM_X86_64, .is_64 = true}};

ProgramFile dynamic_program() {
  ProgramFile program{.kind = Kind::elf, .path = "/opt/game"};
  program.elf = ElfFile{.machine = EM_X86_64, .is_64 = true, .interpreter = "/lib64/ld-linux-x86-64.so.2"};
  return program;
}

std::string only_notice(const ProgramFile& program) {
  const std::vector<std::string> notices = start_notices({&program, 1}, library);
  return notices.size() == 1 ? notices[0] : std::to_string(notices.size()) + " notices";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Files : public testing::Test {
 protected:
  Files() : folder_(fs::temp_directory_path() / ("glark-start-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    const fs::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    fs::permissions(file, fs::perms::owner_all);
    return file.string();
  }
  fs::path folder_;
};

}  // namespace

TEST(StartNotices, ADynamicProgramHasNone) { EXPECT_EQ(only_notice(dynamic_program()), "0 notices"); }

TEST(StartNotices, AStaticProgram) {
  ProgramFile program = dynamic_program();
  program.elf->interpreter.clear();
  EXPECT_TRUE(only_notice(program).starts_with("/opt/game is linked statically")) << only_notice(program);
  program.elf->is_loader = true;
  EXPECT_EQ(only_notice(program), "0 notices");
}

TEST(StartNotices, AProgramThatTheKernelPrivileges) {
  ProgramFile program = dynamic_program();
  program.capabilities = true;
  EXPECT_TRUE(only_notice(program).starts_with("/opt/game has file capabilities: ")) << only_notice(program);
  program.set_group = true;
  EXPECT_TRUE(only_notice(program).starts_with("/opt/game is a set-gid program: ")) << only_notice(program);
  program.set_user = true;
  EXPECT_TRUE(only_notice(program).starts_with("/opt/game is a set-uid program: ")) << only_notice(program);
}

TEST(StartNotices, AProgramForAnotherMachine) {
  ProgramFile program = dynamic_program();
  program.elf->machine = EM_386;
  program.elf->is_64 = false;
  EXPECT_TRUE(only_notice(program).starts_with("/opt/game is for i386, but there is no libGLARK.so for i386"))
      << only_notice(program);
  EXPECT_TRUE(contains(only_notice(program), "install the package libglark0:i386")) << only_notice(program);
  program.elf->machine = EM_ARM;
  EXPECT_TRUE(contains(only_notice(program), "use its x86-64 build")) << only_notice(program);
}

TEST(StartNotices, AProgramOf32BitsWithItsLibrary) {
  ProgramFile program = dynamic_program();
  program.elf = ElfFile{.machine = EM_386, .interpreter = "/lib/ld-linux.so.2"};
  const std::vector<ElfFile> both{library[0], {.machine = EM_386}};
  EXPECT_TRUE(start_notices({&program, 1}, both).empty());
  EXPECT_TRUE(start_notices({&program, 1}, std::vector<ElfFile>{both[1]}).empty());
}

TEST(StartNotices, AProgramForMusl) {
  ProgramFile program = dynamic_program();
  program.elf->interpreter = "/lib/ld-musl-x86_64.so.1";
  EXPECT_TRUE(contains(only_notice(program), "musl")) << only_notice(program);
}

TEST(StartNotices, AProgramThatStartsOthersElsewhere) {
  ProgramFile program = dynamic_program();
  program.path = "/usr/bin/sudo";
  program.set_user = true;
  EXPECT_EQ(only_notice(program),
            "sudo drops the preload, so the program that it starts stays unrefined; write: sudo glark run PROGRAM");
}

TEST(StartNotices, AMissingLoaderNamesItsPackage) {
  ProgramFile program = dynamic_program();
  EXPECT_FALSE(cannot_run({&program, 1}));
  program.elf->machine = EM_386;
  program.elf->is_64 = false;
  program.elf->interpreter = "/nowhere/ld-linux.so.2";
  const std::string reason = cannot_run({&program, 1}).value_or("");
  EXPECT_TRUE(contains(reason, "is for i386 and needs /nowhere/ld-linux.so.2, which is not installed")) << reason;
  EXPECT_TRUE(contains(reason, "libc6:i386")) << reason;
}

TEST_F(Files, AScriptLeadsToItsInterpreter) {
  const std::vector<ProgramFile> files = read_command(write("view", "#!/usr/bin/env -S sh -e\nexit 0\n"));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].kind, Kind::script);
  EXPECT_EQ(files[0].interpreter, "sh");
  EXPECT_EQ(files[1].kind, Kind::elf);
  EXPECT_FALSE(cannot_run(files));
  EXPECT_TRUE(start_notices(files, {&*files[1].elf, 1}).empty());
}

TEST_F(Files, AScriptWithoutItsInterpreterCannotRun) {
  for (const char* line : {"#!/nowhere/perl -w\n", "#! /usr/bin/env no-such-interpreter\n"}) {
    const std::string reason = cannot_run(read_command(write("script", line))).value_or("");
    EXPECT_TRUE(contains(reason, "which is not installed; install it, or correct the script's first line")) << reason;
  }
}

TEST_F(Files, AScriptThatNamesItselfEnds) {
  const std::string path = (folder_ / "loop").string();
  write("loop", "#!" + path + "\n");
  EXPECT_LT(read_command(path).size(), 10u);
}

TEST_F(Files, AWindowsProgram) {
  const std::vector<ProgramFile> files = read_command(write("game.exe", "MZ\x90"));
  ASSERT_EQ(files.size(), 1u);
  EXPECT_TRUE(contains(only_notice(files[0]), "glark run wine ")) << only_notice(files[0]);
}

TEST_F(Files, BrokenFilesAreNoPrograms) {
  for (const std::string& text : {std::string("\x7f"
                                              "ELF"),
                                  std::string("\x7f"
                                              "ELF\x02\x01") +
                                      std::string(20, '\xff'),
                                  std::string("\x7f"
                                              "ELF\x02\x01") +
                                      std::string(200, '\xff'),
                                  std::string("#!"), std::string("#!\n"), std::string()}) {
    const std::vector<ProgramFile> files = read_command(write("broken", text));
    EXPECT_EQ(files.size(), 1u);
    start_notices(files, library);
    cannot_run(files);
  }
  EXPECT_EQ(read_command(folder_.string())[0].kind, Kind::folder);
  EXPECT_EQ(read_command("no-such-program")[0].kind, Kind::missing);
}

TEST_F(Files, TheLibraryIsOfThisMachine) {
  const ProgramFile self = read_program_file("/proc/self/exe");
  ASSERT_TRUE(self.elf);
  EXPECT_EQ(self.elf->is_64, sizeof(void*) == 8);
  EXPECT_FALSE(self.elf->interpreter.empty());
  EXPECT_EQ(machine_name(*self.elf).find("machine"), std::string::npos);
}

}  // namespace glark::tool
