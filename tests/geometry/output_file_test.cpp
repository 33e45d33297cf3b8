// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An output file takes the mode and the owner of the file that it replaces.
#include <sys/stat.h>

#include "glark/clients/common/named_files.h"
#include "glark/clients/geometry/write/output_file.h"
#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using OutputFiles = TemporaryFolder;

struct stat status_of(const std::filesystem::path& file) {
  struct stat status {};
  EXPECT_EQ(0, stat(file.c_str(), &status));
  return status;
}

TEST_F(OutputFiles, KeepTheModeOfTheFileThatTheyReplace) {
  const Geometry geometry = random_geometry(1, {});
  for (const mode_t mode : {0600U, 0640U, 0444U, 0755U, 0666U}) {
    const std::filesystem::path file = made("a.ply", "old");
    ASSERT_EQ(0, chmod(file.c_str(), mode));
    write_file(file, geometry);
    EXPECT_EQ(mode, status_of(file).st_mode & 07777U);
    EXPECT_GT(std::filesystem::file_size(file), 3U);
    std::filesystem::remove(file);
  }
}

TEST_F(OutputFiles, NewOnesHaveTheModeOfTheUmask) {
  const mode_t before = umask(027);
  write_file(path("a.ply"), random_geometry(1, {}));
  umask(before);
  EXPECT_EQ(0640U, status_of(path("a.ply")).st_mode & 07777U);
}

TEST_F(OutputFiles, KeepTheOwnerWhereThisIsPermitted) {
  const std::filesystem::path file = made("a.ply", "old");
  if (chown(file.c_str(), 12345, 12346) != 0) GTEST_SKIP() << "only root may give files away";
  ASSERT_EQ(0, chmod(file.c_str(), 0640));
  write_file(file, random_geometry(1, {}));
  EXPECT_EQ(12345U, status_of(file).st_uid);
  EXPECT_EQ(12346U, status_of(file).st_gid);
  EXPECT_EQ(0640U, status_of(file).st_mode & 07777U);
}

// The name is there between commit()'s two steps, or earlier where the file system has no files without names.
TEST_F(OutputFiles, ASignalRemovesTheirTemporaryNames) {
  const std::filesystem::path file = made("a.ply", "old");
  {
    OutputFile output(file);
    output.write("new");
    output.prepare();
    EXPECT_EQ(2U, file_count());
    common::NamedFiles::unlink_all();  // as a signal handler does
    EXPECT_EQ(1U, file_count());
  }
  OutputFile output(file);
  output.write("new");
  output.commit();
  common::NamedFiles::unlink_all();
  EXPECT_EQ(3U, std::filesystem::file_size(file));  // the finished file is not temporary
  EXPECT_EQ(1U, file_count());
}

// What a process leaves that is killed within commit().
TEST_F(OutputFiles, ANameThatAKilledProcessLeftIsTaken) {
  const std::filesystem::path file = made("a.ply", "old");
  made(".a.ply.glark-new", "left");
  OutputFile output(file);
  output.write("new");
  output.prepare();
  EXPECT_EQ(3U, std::filesystem::file_size(path(".a.ply.glark-new")));
  output.commit();
  EXPECT_EQ(3U, std::filesystem::file_size(file));
  EXPECT_EQ(1U, file_count());
}

TEST_F(OutputFiles, ANameThatAProcessHoldsIsLeftToIt) {
  const std::filesystem::path file = made("a.ply", "old");
  OutputFile first(file);
  first.write("first");
  first.prepare();
  {
    OutputFile second(file);
    second.write("second");
    second.prepare();
    EXPECT_EQ(3U, file_count());
    second.commit();
    EXPECT_EQ(6U, std::filesystem::file_size(file));
  }
  EXPECT_EQ(2U, file_count());
  first.commit();
  EXPECT_EQ(5U, std::filesystem::file_size(file));
  EXPECT_EQ(1U, file_count());
}

TEST(NamedFiles, NamesThatDoNotFitAreLeftOut) {
  common::NamedFiles::add(std::string(5000, 'x'));
  for (int i = 0; i < 20; ++i) common::NamedFiles::add("/nowhere/" + std::to_string(i));
  common::NamedFiles::unlink_all();
  for (int i = 0; i < 20; ++i) common::NamedFiles::remove("/nowhere/" + std::to_string(i));
}

TEST_F(OutputFiles, ALinkStaysALink) {
  const std::filesystem::path file = made("a.ply", "old");
  ASSERT_EQ(0, chmod(file.c_str(), 0640));
  std::filesystem::create_symlink("a.ply", path("link.ply"));
  write_file(path("link.ply"), random_geometry(1, {}));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.ply")));
  EXPECT_EQ(0640U, status_of(file).st_mode & 07777U);
}

TEST_F(OutputFiles, ALinkToAMissingFileStaysALink) {
  std::filesystem::create_directory(path("folder"));
  std::filesystem::create_symlink("folder/inner.ply", path("link.ply"));
  std::filesystem::create_symlink("missing.ply", path("folder/inner.ply"));
  write_file(path("link.ply"), random_geometry(1, {}));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.ply")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("folder/inner.ply")));
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(path("folder/missing.ply"))));
}

TEST_F(OutputFiles, AMissingFolderOrALoopBehindALinkIsAnError) {
  std::filesystem::create_symlink("nowhere/a.ply", path("link.ply"));
  std::filesystem::create_symlink("b.ply", path("a.ply"));
  std::filesystem::create_symlink("a.ply", path("b.ply"));
  for (const char* name : {"link.ply", "a.ply"}) {
    EXPECT_THROW(write_file(path(name), random_geometry(1, {})), Error) << name;
    EXPECT_TRUE(std::filesystem::is_symlink(path(name)));
  }
}

}  // namespace
}  // namespace glark::geometry
