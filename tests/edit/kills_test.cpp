// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A session that is killed at any moment loses at most the operation that was under way.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "tests/edit/scan_folder.h"

namespace glark::edit {
namespace {

using Kills = ScanFolder;

// The operation that follows `count` others. All of them are possible in any state.
Operation operation_after(std::size_t count) {
  const double turn = 0.7 * static_cast<double>(count);
  const Ball ball{{std::cos(turn), std::sin(turn), 0}, 0.8};
  switch (count % 5) {
    case 0: return Inflate{ball, 0.001};
    case 1: return Paint{ball, {static_cast<std::uint8_t>(count), 2, 3}, 0.5};
    case 2: return Undo{};
    case 3: return Smooth{ball};
    default: return Move{ball, {0.001, 0, 0}};
  }
}

// Writes a byte for each operation that apply() has accepted, until it is killed.
[[noreturn]] void edit_until_killed(const std::filesystem::path& scan, const std::filesystem::path& folder, int pipe) {
  Session session(scan, folder, {.target = 1000, .threads = 1});
  for (;;) {
    session.apply(operation_after(session.operations()));
    if (write(pipe, "x", 1) != 1) _exit(1);
  }
}

TEST_F(Kills, LoseAtMostTheLastOperation) {
  open();
  constexpr int kills = 50;
  const unsigned seed = std::random_device()();
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  std::size_t accepted = 0;
  for (int kill_number = 0; kill_number < kills; ++kill_number) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      close(ends[0]);
      edit_until_killed(scan(), folder(), ends[1]);
    }
    close(ends[1]);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60000));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the session failed; seed " << seed;
    char bytes[4096];
    for (ssize_t got = read(ends[0], bytes, sizeof(bytes)); got > 0; got = read(ends[0], bytes, sizeof(bytes)))
      accepted += static_cast<std::size_t>(got);
    close(ends[0]);
    const Session session = open();
    ASSERT_GE(session.operations(), accepted) << "seed " << seed;
    ASSERT_LE(session.operations(), accepted + 1) << "seed " << seed;
    accepted = session.operations();
  }
  EXPECT_GT(accepted, 50U);
  const Session killed = open();
  Session whole(scan(), path("whole.edit"), {.target = 1000, .threads = 1});
  for (std::size_t k = 0; k < accepted; ++k) whole.apply(operation_after(k));
  EXPECT_TRUE(bytes_of(whole.editor()) == bytes_of(killed.editor())) << "seed " << seed;
}

}  // namespace
}  // namespace glark::edit
