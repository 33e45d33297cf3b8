// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that was linked with "-lGL -lGLARK" calls libGL directly: the dynamic linker takes the first library that has
// a function. Nothing else would tell the user.
#include <fmt/format.h>

#include <array>

#include "glark/core/report/log.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

constexpr std::array names{"glXMakeCurrent", "eglMakeCurrent", "OSMesaMakeCurrent", "glDrawArrays"};

__attribute__((constructor)) void check_link_order() {
  const std::string before = gl_library_before_us(names);
  if (before.empty()) return;
  options();  // installs the log
  core::log(
      core::LogLevel::warning,
      fmt::format("this program was linked with libGLARK.so behind {}, whose functions it calls instead, so nothing "
                  "is refined; name -lGLARK before the GL library when you link it, or start it by glark run",
                  before));
}

}  // namespace
}  // namespace glark::shim
