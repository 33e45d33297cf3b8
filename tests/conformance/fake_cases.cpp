// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-conformance with cases that do everything a case can do.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "conformance/runner/program.h"
#include "conformance/suite/test.h"

namespace glark::conformance {
namespace {

Case fake(const char* leaf, std::function<void(Test&)> check, std::function<void(Test&)> control = {}) {
  return {.name = std::string("ark.fake.") + leaf,
          .clauses = {"10.R.1-1"},
          .plan = "Do it.",
          .control = std::move(control),
          .check = std::move(check)};
}

// Fails the first time and passes afterwards. The test says where the file is.
void check_unsteady(Test& t) {
  const std::filesystem::path mark = std::getenv("FAKE_MARK");
  t.expect(std::filesystem::exists(mark), "the second time");
  std::ofstream(mark) << "seen";
}

void check_picture(Test& t) {
  Picture expected(8, 8);
  Picture actual = expected;
  actual.set(2, 5, {255, 0, 0, 255});
  t.expect_same_picture(actual, expected, "a <picture> & more");
}

}  // namespace

std::vector<Case> written_cases() {
  return {fake("pass", [](Test& t) { t.expect(true, "fine"); }),
          fake("pass_too", [](Test& t) { t.expect(true, "fine"); }),
          fake("fail", check_picture),
          fake("equal", [](Test& t) { t.expect_equal(3, 4, "a number"); }),
          fake("error_left", [](Test& t) { t.expect(true, "fine"), gl.Enable(0x1234); }),
          fake("lines", [](Test& t) { t.fail("two\nlines"); }),
          fake("nothing", [](Test&) {}),
          fake("throws", [](Test&) { throw std::runtime_error("thrown"); }),
          fake(
              "control", [](Test& t) { t.expect(true, "fine"); }, [](Test& t) { t.fail("the driver is wrong"); }),
          optional(fake("not_supported", [](Test& t) { t.not_supported("no such thing here"); })),
          fake("unexpectedly_not_supported", [](Test& t) { t.not_supported("no such thing here"); }),
          fake("warning", [](Test& t) { t.quality_warning("slow"); }),
          fake("planned", {}),
          fake("crash", [](Test&) { std::fputs("about to crash\n", stderr), std::raise(SIGSEGV); }),
          fake("vanish", [](Test&) { _exit(0); }),
          fake("hang",
               [](Test&) {
                 for (;;) pause();
               }),
          fake("spin",
               [](Test&) {
                 volatile bool goes_on = true;
                 while (goes_on) {
                 }
               }),
          fake("unsteady", check_unsteady),
          {.name = "ark.fake.es_only",
           .clauses = {"es-1"},
           .plan = "Only there.",
           .apis = {Api::gles},
           .check = [](Test& t) { t.expect(t.is_gles(), "an ES context"); }}};
}

}  // namespace glark::conformance

int main(int argc, char** argv) { return glark::conformance::run_program(argc, argv); }
