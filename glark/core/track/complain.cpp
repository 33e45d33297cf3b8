// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/track/complain.h"

#include <fmt/format.h>

#include <mutex>
#include <set>

#include "glark/core/objects/application_message.h"
#include "glark/core/report/log.h"

namespace glark::core::track {
namespace {

// A program that repeats a mistake with other values must not fill the log.
constexpr std::size_t most_logged = 64;

const char* name_of_error(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    default: return "GL_OUT_OF_MEMORY";
  }
}

void log_once(const std::string& text) {
  static std::mutex& mutex = *new std::mutex;  // programs call GL from their destructors at exit
  static std::set<std::string>& logged = *new std::set<std::string>;
  const std::lock_guard lock(mutex);
  if (logged.size() < most_logged && logged.insert(text).second) {
    log(LogLevel::warning, text);
  }
}

}  // namespace

void complain(Context& c, GLenum error, const char* function, const std::string& why) {
  c.pending_error().raise(error);
  const std::string text = fmt::format("{}: {}: {}", function, name_of_error(error), why);
  log_once(text);
  // Between glBegin and glEnd, GL accepts no message. A context that cannot refine may not have debug output.
  if (c.capabilities().refinable && !c.state().immediate().open()) {
    c.state().refresh();
    DebugOutput{c.gl(), c.state().bindings().debug_output}.send(MessageId::wrong_call, text);
  }
}

}  // namespace glark::core::track
