// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/options.h"

#include <unistd.h>

#include <string>

#include "shim/log.h"

namespace glark::shim {

const settings::Settings& options() {
  static const settings::Settings& instance = *[] {
    // `environ`, not getenv: programs define a getenv of their own.
    settings::Parsed parsed = settings::parse(environ);
    install_log(parsed.settings.log_level);
    for (const std::string& problem : parsed.problems) core::log(core::LogLevel::warning, problem);
    return new settings::Settings(std::move(parsed.settings));
  }();
  return instance;
}

}  // namespace glark::shim
