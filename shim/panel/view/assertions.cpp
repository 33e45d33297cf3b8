// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/assertions.h"

#include <fmt/format.h>

#include <csetjmp>

extern "C" {
// assert() calls the first; the linker leads it to the second, and the third is that of the C library.
// NOLINTBEGIN(readability-identifier-naming): the linker's names
[[noreturn]] void __wrap___assert_fail(const char* expression, const char* file, unsigned line, const char* function);
[[noreturn]] void __real___assert_fail(const char* expression, const char* file, unsigned line, const char* function);
// NOLINTEND(readability-identifier-naming)
}

namespace {

struct Failure {
  const char* expression = "";
  const char* file = "";
  unsigned line = 0;
};

thread_local std::jmp_buf* way_out = nullptr;
thread_local Failure last_failure;

}  // namespace

// An exception would not do: the compiler knows that assert() throws none, so Dear ImGui is not compiled for one.
void __wrap___assert_fail(const char* expression, const char* file, unsigned line, const char* function) {
  if (way_out == nullptr) __real___assert_fail(expression, file, line, function);
  last_failure = {expression, file, line};
  std::longjmp(*way_out, 1);
}

namespace glark::shim {

bool survives_assertions(void (*use)(void*), void* data) {
  std::jmp_buf here;
  if (setjmp(here) != 0) {
    way_out = nullptr;
    return false;
  }
  way_out = &here;
  try {
    use(data);
  } catch (...) {
    way_out = nullptr;
    throw;
  }
  way_out = nullptr;
  return true;
}

std::string failed_assertion() {
  return fmt::format("{} in {}:{}", last_failure.expression, last_failure.file, last_failure.line);
}

}  // namespace glark::shim
