// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/platform/platform.h"

#include <stdexcept>

namespace glark::conformance {

std::unique_ptr<Platform> Platform::open(std::string_view name) {
  if (name == "osmesa") return open_osmesa();
  if (name == "egl") return open_egl();
  if (name == "glx") return open_glx();
  throw std::runtime_error("no platform \"" + std::string(name) + "\": osmesa, egl and glx are known");
}

}  // namespace glark::conformance
