// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// States of runs that were killed.
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/space/spatial_order.h"
#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using Work = TemporaryFolder;

bool load_number(const WorkFolder& folder, int& number) {
  return folder.load("number", [&](common::StateReader& state) { return state.get(number); });
}

TEST_F(Work, AStateIsKeptForTheSameWork) {
  int number = 0;
  {
    WorkFolder folder(path("work"), "first", false);
    EXPECT_FALSE(load_number(folder, number));
    folder.save("number", [](common::StateWriter& state) { state.put(42); });
  }
  EXPECT_TRUE(load_number(WorkFolder(path("work"), "first", true), number));
  EXPECT_EQ(number, 42);
  EXPECT_FALSE(load_number(WorkFolder(path("work"), "second", true), number));
}

TEST_F(Work, WithoutResumeAStateIsDropped) {
  int number = 0;
  {
    WorkFolder(path("work"), "a", false).save("number", [](common::StateWriter& state) { state.put(42); });
  }
  EXPECT_FALSE(load_number(WorkFolder(path("work"), "a", false), number));
}

TEST_F(Work, TheFolderGoesWithTheWork) {
  { const WorkFolder unused(path("a"), "", false); }
  EXPECT_FALSE(std::filesystem::exists(path("a")));
  WorkFolder folder(path("b"), "", false);
  folder.save("number", [](common::StateWriter& state) { state.put(42); });
  EXPECT_TRUE(std::filesystem::exists(path("b")));
  folder.finish();
  EXPECT_FALSE(std::filesystem::exists(path("b")));
}

TEST_F(Work, EveryDamageOfAStateIsFound) {
  WorkFolder folder(path("work"), "a", false);
  folder.save("number", [](common::StateWriter& state) { state.put(42); });
  const std::string good = bytes_of(path("work/glark-number"));
  int number = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 4);
    made("work/glark-number", bad);
    EXPECT_FALSE(load_number(folder, number)) << i;
    made("work/glark-number", good.substr(0, i));
    EXPECT_FALSE(load_number(folder, number)) << i;
  }
  made("work/glark-number", good);
  EXPECT_TRUE(load_number(folder, number));
}

// Whether a run with or without `resume` refuses this folder, and leaves what is in it.
void expect_refused(const std::filesystem::path& folder, const std::filesystem::path& file) {
  for (const bool resume : {false, true}) {
    EXPECT_NE(problem_of([&] { const WorkFolder work(folder, "a", resume); }), "");
    EXPECT_TRUE(std::filesystem::exists(file));
  }
}

TEST_F(Work, FilesOfOthersAreNotRemoved) {
  expect_refused(made("scan.ply", "a scan"), path("scan.ply"));
  std::filesystem::create_directory(path("photos"));
  expect_refused(path("photos"), made("photos/identity", "mine"));
  made("photos/glark-identity", "glark work 1\n");  // without a checksum
  expect_refused(path("photos"), path("photos/glark-identity"));
  std::filesystem::create_symlink(path("none"), path("link"));
  EXPECT_NE(problem_of([&] { const WorkFolder work(path("link"), "a", false); }), "");
}

TEST_F(Work, WhatSomebodyPutsIntoTheFolderStays) {
  WorkFolder folder(path("work"), "a", false);
  made("work/notes.txt", "mine");
  std::filesystem::create_directory(path("work/glark-folder"));
  folder.save("number", [](common::StateWriter& state) { state.put(42); });
  folder.finish();
  EXPECT_TRUE(std::filesystem::exists(path("work/notes.txt")));
  EXPECT_TRUE(std::filesystem::exists(path("work/glark-folder")));
  EXPECT_FALSE(std::filesystem::exists(path("work/glark-number")));
}

// A run that is killed while it removes the folder leaves one that the next run knows.
TEST_F(Work, TheIdentityIsRemovedLast) {
  {
    WorkFolder folder(path("work"), "a", false);
    folder.save("number", [](common::StateWriter& state) { state.put(42); });
    for (int i = 0; i < 50; ++i) made("work/glark-" + std::to_string(i), "x");
    // As a kill after each removal: nothing of ours may be without the identity.
    const int watch = inotify_init1(IN_NONBLOCK);
    ASSERT_GE(inotify_add_watch(watch, path("work").c_str(), IN_DELETE), 0);
    folder.finish();
    alignas(inotify_event) std::array<char, 16384> events{};
    const ssize_t size = read(watch, events.data(), events.size());
    close(watch);
    std::string last;
    int removed = 0;
    for (ssize_t at = 0; at < size; ++removed) {
      inotify_event event{};
      std::memcpy(&event, &events[static_cast<std::size_t>(at)], sizeof(event));
      if (event.len > 0) last = &events[static_cast<std::size_t>(at) + sizeof(event)];
      at += static_cast<ssize_t>(sizeof(event) + event.len);
    }
    EXPECT_GE(removed, 52);
    EXPECT_EQ(last, "glark-identity");
  }
  EXPECT_FALSE(std::filesystem::exists(path("work")));
}

TEST_F(Work, AnEmptyFolderAndABegunOneAreTaken) {
  std::filesystem::create_directory(path("work"));
  { const WorkFolder folder(path("work"), "a", false); }
  std::filesystem::create_directory(path("work"));
  made("work/glark-identity.new", "gl");
  int number = 0;
  EXPECT_FALSE(load_number(WorkFolder(path("work"), "a", true), number));
}

TEST_F(Work, ResumeNeedsAFolder) {
  EXPECT_NE(problem_of([&] { require_work({}, true); }).find("work"), std::string::npos);
  require_work({}, false);
  require_work("a", true);
}

TEST_F(Work, TheOutputIsOnTheSameFileSystem) {
  const WorkFolder folder(path("work"), "a", false);
  folder.require_same_disk(path("out.ply"));
  struct stat here {};
  struct stat there {};
  if (stat(path("").c_str(), &here) != 0 || stat("/dev/shm", &there) != 0 || here.st_dev == there.st_dev)
    GTEST_SKIP() << "/dev/shm is no other file system here";
  EXPECT_NE(problem_of([&] { folder.require_same_disk("/dev/shm/out.ply"); }), "");
}

TEST_F(Work, AnArrayThatIsTooLongIsNotRead) {
  WorkFolder folder(path("work"), "a", false);
  folder.save("array", [](common::StateWriter& state) { state.put(std::uint64_t{1} << 60); });
  std::vector<double> array;
  EXPECT_FALSE(folder.load("array", [&](common::StateReader& state) { return state.get_all(array); }));
}

TEST(SpatialOrder, NearPointsFollowOneAnother) {
  const std::vector<common::Vector3f> points{{0, 0, 0}, {100, 0, 0}, {1, 0, 0}, {99, 0, 0}};
  EXPECT_EQ(spatial_order(points), (std::vector<std::uint32_t>{0, 2, 3, 1}));
}

TEST(SpatialOrder, PointsThatAreNotFiniteAndEqualPointsKeepTheirOrder) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(spatial_order(std::vector<common::Vector3f>{{5, 5, 5}, {nan, 0, 0}, {5, 5, 5}}).size(), 3U);
  EXPECT_EQ(spatial_order(std::vector<common::Vector3f>(3)), (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace glark::stream
