// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Who sees that glark compiles: a user at a terminal, unless only errors are wanted, and who asks for information.
#include "shim/report/log.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace glark::shim {
namespace {

// What one line of each level prints at the most verbose level `wanted`.
std::string printed(core::LogLevel wanted, bool at_terminal) {
  int ends[2] = {-1, -1};
  EXPECT_EQ(at_terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) : pipe(ends), 0);
  const int standard_error = dup(STDERR_FILENO);
  dup2(ends[1], STDERR_FILENO);
  install_log(wanted);
  core::log(core::LogLevel::progress, "compiling");
  core::log(core::LogLevel::info, "details");
  core::log(core::LogLevel::error, "end");
  dup2(standard_error, STDERR_FILENO);
  core::set_log_sink(nullptr);
  std::string text;
  char letters[256];
  while (text.find("end") == std::string::npos) {
    const ssize_t count = read(ends[0], letters, sizeof(letters));
    if (count <= 0) break;
    text.append(letters, static_cast<std::size_t>(count));
  }
  for (const int end : {ends[0], ends[1], standard_error}) close(end);
  return text;
}

bool tells(const std::string& text, const char* word) { return text.find(word) != std::string::npos; }

class Log : public testing::Test {
 protected:
  void SetUp() override {
    setenv("NO_COLOR", "1", 1);
    setenv("TERM", "xterm", 1);
  }
};

TEST_F(Log, ProgressIsForTerminals) {
  EXPECT_TRUE(tells(printed(core::LogLevel::warning, true), "glark: compiling"));
  EXPECT_FALSE(tells(printed(core::LogLevel::warning, true), "details"));
  EXPECT_FALSE(tells(printed(core::LogLevel::warning, false), "compiling"));
}

TEST_F(Log, ProgressIsInformation) {
  EXPECT_TRUE(tells(printed(core::LogLevel::info, false), "glark: compiling"));
  EXPECT_TRUE(tells(printed(core::LogLevel::info, false), "glark: details"));
}

TEST_F(Log, SilentRunsStaySilent) {
  const std::string text = printed(core::LogLevel::error, true);
  EXPECT_FALSE(tells(text, "compiling"));
  EXPECT_TRUE(tells(text, "glark: error: end"));
}

TEST_F(Log, ColorsAreForTerminalsThatWantThem) {
  EXPECT_FALSE(tells(printed(core::LogLevel::info, true), "\033["));
  unsetenv("NO_COLOR");
  EXPECT_TRUE(tells(printed(core::LogLevel::info, true), "\033["));
  EXPECT_FALSE(tells(printed(core::LogLevel::info, false), "\033["));
}

}  // namespace
}  // namespace glark::shim
