// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The parameters of GL_ARK_adaptive_refinement, one row each. The commands that set them, the queries, and the tables
// of the extension's text (tests/core/track/parameters_test.cpp) use the same rows.
#pragma once

#include <span>
#include <string_view>

#include "glark/core/ark_state.h"
#include "glark/gl/types.h"

namespace glark::core {

// The values that limit the ranges of some parameters.
struct ParameterLimits {
  GLint level = 0;            // greatest depth: of the pool, 0 before glARKinit
  GLint first_attribute = 0;  // the least index of a generic attribute that can carry tags
  GLint attribute_count = 16;
  GLint texture_unit_count = 0;
};

struct Bounds {
  GLint least = 0;
  GLint most = 0;
  bool or_minus_one = false;
};

struct TokenName {
  GLenum token = 0;
  std::string_view name;  // without GL_, as in the extension's text
};

struct Parameter {
  enum class Kind {
    token,    // one of `tokens`
    boolean,  // GL_FALSE or GL_TRUE
    whole,    // an integer within `bounds`
    number,   // a number from `least` to `most`; glARKParameterfARK sets these
  };

  GLenum name = 0;
  std::string_view text;  // the name without GL_
  Kind kind = Kind::whole;
  double (*get)(const ArkState& state) = nullptr;
  void (*set)(ArkState& state, double value) = nullptr;
  std::span<const TokenName> tokens = {};
  Bounds (*bounds)(const ParameterLimits& limits) = nullptr;
  float least = 0;
  float most = 0;
  std::string_view initial;       // as in the extension's text
  std::string_view values = {};   // lines of the extension's text; empty: one line per token
  std::string_view setting = {};  // the configuration key with the same meaning; empty: there is none
};

// In the order of table 11.R of the extension's text.
std::span<const Parameter> parameters();
// Null: no parameter has this name.
const Parameter* find_parameter(GLenum name);

// Sets the parameter, or returns the error and changes nothing.
GLenum set_integer(const Parameter& parameter, const ParameterLimits& limits, GLint value, ArkState& state);
GLenum set_number(const Parameter& parameter, GLfloat value, ArkState& state);

}  // namespace glark::core
