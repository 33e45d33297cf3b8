// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The initial value of every state of the extension ("New State").
#include "conformance/cases/cases.h"
#include "conformance/suite/test.h"

namespace glark::conformance {
namespace {

struct IntegerState {
  const char* leaf;
  const char* clause;
  GLenum name;
  GLint initial;
};

Case integer_default(const IntegerState& state) {
  return {.name = std::string("ark.state.defaults.") + state.leaf,
          .clauses = {state.clause},
          .plan = "Ask a new context by GetIntegerv.",
          .wrong = "0 for every state; or another context's value.",
          .check = [state](Test& t) {
            GLint value = -77;
            gl.GetIntegerv(state.name, &value);
            t.expect_no_error("GetIntegerv");
            t.expect_equal(value, state.initial, "initial value");
          }};
}

}  // namespace

Cases defaults_cases() {
  Cases cases;
  for (const IntegerState& state : {
           IntegerState{"pool_level", "state-2", GL_POOL_LEVEL_ARK, -1},
           IntegerState{"current_depth_tag", "state-3", GL_CURRENT_DEPTH_TAG_ARK, 0},
       })
    cases.push_back(integer_default(state));
  return cases;
}

}  // namespace glark::conformance
