// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "conformance/gl/gl.h"

namespace glark::conformance {

// Sees what a case does.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  // The functions of a context were loaded. The observer may put others into their place.
  virtual void loaded(GladGLContext& functions) = 0;
  // The case checks this now.
  virtual void expects(std::string_view what) = 0;
  // What came before does not matter: it was the control of the case, for example.
  virtual void begins_again() = 0;
};

extern Observer* observer;  // null: nobody looks

}  // namespace glark::conformance
