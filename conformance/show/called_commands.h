// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "conformance/gl/observer.h"

namespace glark::conformance {

// Notes during its lifetime which commands of OpenGL are called. There is one at a time.
class CalledCommands final : public Observer {
 public:
  CalledCommands();
  ~CalledCommands() override;

  void loaded(GladGLContext& functions) override;
  void expects(std::string_view /*what*/) override {}
  void begins_again() override {}
  // Without "gl", in alphabetic order.
  std::vector<std::string> names() const;
};

}  // namespace glark::conformance
