// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/start/preload.h"

#include <elf.h>
#include <gtest/gtest.h>

#include <map>

namespace glark::tool {
namespace {

const ElfFile of_64{.machine = EM_X86_64, .is_64 = true};
const ElfFile of_32{.machine = EM_386};
const std::vector<std::string> folders{"lib", "lib/x86_64-linux-gnu"};

// Reads from a table of files instead of from the disk.
ReadElf files(const std::map<std::string, ElfFile>& there) {
  return [there](const std::string& path) {
    const auto found = there.find(path);
    return found == there.end() ? std::nullopt : std::optional(found->second);
  };
}

std::optional<Preload> find(const std::map<std::string, ElfFile>& there) {
  return find_preload("/usr", folders, "libGLARK.so.0", of_64, files(there));
}

}  // namespace

TEST(Preload, OneLibraryIsNamedByItsPath) {
  const std::optional<Preload> found = find({{"/usr/lib/x86_64-linux-gnu/libGLARK.so.0", of_64}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "/usr/lib/x86_64-linux-gnu/libGLARK.so.0");
  EXPECT_EQ(found->libraries.size(), 1u);
}

TEST(Preload, TwoLibrariesAreNamedByToken) {
  const std::optional<Preload> found =
      find({{"/usr/lib/x86_64-linux-gnu/libGLARK.so.0", of_64}, {"/usr/lib/i386-linux-gnu/libGLARK.so.0", of_32}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "/usr/$LIB/libGLARK.so.0");
  EXPECT_EQ(found->file, "/usr/lib/x86_64-linux-gnu/libGLARK.so.0");
  ASSERT_EQ(found->libraries.size(), 2u);
  EXPECT_TRUE(found->libraries[0].is_64);
  EXPECT_FALSE(found->libraries[1].is_64);
}

// Fedora: lib has libraries of 32 bits, lib64 those of 64.
TEST(Preload, TheFolderLibMayBelongToTheOtherKind) {
  const ReadElf there = files({{"/usr/lib64/libGLARK.so.0", of_64}, {"/usr/lib/libGLARK.so.0", of_32}});
  const std::optional<Preload> wide = find_preload("/usr", {"lib", "lib64"}, "libGLARK.so.0", of_64, there);
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->text, "/usr/$LIB/libGLARK.so.0");
  EXPECT_EQ(wide->file, "/usr/lib64/libGLARK.so.0");
  const std::optional<Preload> narrow = find_preload("/usr", {"lib", "lib"}, "libGLARK.so.0", of_32, there);
  ASSERT_TRUE(narrow);
  EXPECT_EQ(narrow->file, "/usr/lib/libGLARK.so.0");
  EXPECT_EQ(narrow->libraries.size(), 2u);
}

// In a build folder, $LIB would mean nothing.
TEST(Preload, AFolderThatTheTokenDoesNotMeanIsNamedByItsPath) {
  const std::optional<Preload> found =
      find({{"/usr/lib/libGLARK.so.0", of_64}, {"/usr/lib/i386-linux-gnu/libGLARK.so.0", of_32}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "/usr/lib/libGLARK.so.0");
}

TEST(Preload, ALibraryForAnotherMachineIsNotFound) {
  EXPECT_FALSE(find({{"/usr/lib/libGLARK.so.0", of_32}}));
  EXPECT_FALSE(find({}));
}

TEST(Preload, AWantedFileIsTaken) {
  const ReadElf there = files({{"/opt/libGLARK.so", of_32}, {"/opt/lib/x86_64-linux-gnu/libGLARK.so", of_64}});
  const std::optional<Preload> plain = preload_of("/opt/libGLARK.so", of_64, there);
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->libraries[0].is_64);
  const std::optional<Preload> by_token = preload_of("/opt/$LIB/libGLARK.so", of_64, there);
  ASSERT_TRUE(by_token);
  EXPECT_EQ(by_token->text, "/opt/$LIB/libGLARK.so");
  EXPECT_EQ(by_token->file, "/opt/lib/x86_64-linux-gnu/libGLARK.so");
  EXPECT_FALSE(preload_of("/opt/$LIB/libGLARK.so", of_32, there));
  EXPECT_FALSE(preload_of("/nowhere/libGLARK.so", of_64, there));
}

}  // namespace glark::tool
