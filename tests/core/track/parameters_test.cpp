// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares the table of ARK parameters and the registry of refinements with the extension's text and the settings.
#include "glark/core/parameters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "glark/settings/table.h"

namespace glark::core::test {
namespace {

std::string specification() {
  std::ifstream file(GLARK_SPECIFICATION);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::vector<std::string> value_lines(const Parameter& parameter) {
  std::vector<std::string> lines;
  if (parameter.values.empty()) {
    for (const TokenName& token : parameter.tokens) lines.emplace_back(token.name);
    return lines;
  }
  std::istringstream values{std::string(parameter.values)};
  for (std::string line; std::getline(values, line);) lines.push_back(line);
  return lines;
}

// An entry as in table 11.R: a long name has a line of its own.
std::string table_entry(const Parameter& parameter) {
  const std::vector<std::string> values = value_lines(parameter);
  const std::string indent(8, ' ');
  std::string text = indent + padded(std::string(parameter.text), 26);
  if (parameter.text.size() > 24) text = indent + std::string(parameter.text) + "\n" + indent + padded("", 26);
  text += padded(values[0], 26) + std::string(parameter.initial) + "\n";
  for (std::size_t i = 1; i < values.size(); ++i) text += indent + padded("", 26) + values[i] + "\n";
  return text;
}

bool may_be_negative(const Parameter& parameter) { return parameter.bounds(ParameterLimits{}).or_minus_one; }

std::string state_line(const Parameter& parameter) {
  std::string type = "Z+";
  std::string command = "GetIntegerv";
  switch (parameter.kind) {
    case Parameter::Kind::token: type = "Z" + std::to_string(parameter.tokens.size()); break;
    case Parameter::Kind::boolean: type = "B", command = "GetBooleanv"; break;
    case Parameter::Kind::whole: type = may_be_negative(parameter) ? "Z" : "Z+"; break;
    case Parameter::Kind::number: type = "R", command = "GetFloatv"; break;
  }
  return "\n    " + padded(std::string(parameter.text), 36) + padded(type, 6) + padded(command, 21) +
         padded(std::string(parameter.initial), 24) + "-\n";
}

TEST(Parameters, SpecificationHasTheTableOfParameters) {
  std::string table;
  for (const Parameter& parameter : parameters()) table += table_entry(parameter);
  const std::string text = specification();
  const std::size_t begin = text.find("        REFINEMENT_ARK            LINEAR_INPUTS_ARK");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(text.substr(begin, text.find("\n        Table 11.R:", begin) - begin), table);
}

TEST(Parameters, SpecificationHasTheStateTable) {
  const std::string text = specification();
  const std::string state = text.substr(text.find("\nNew State\n"));
  for (const Parameter& parameter : parameters()) {
    EXPECT_NE(state.find(state_line(parameter)), std::string::npos) << state_line(parameter);
  }
}

TEST(Parameters, SpecificationHasTheRefinements) {
  const std::string text = specification();
  const std::size_t begin =
      text.find("Accepted by the <param> parameter of ARKParameteriARK when <pname> is\n    REFINEMENT_ARK:");
  ASSERT_NE(begin, std::string::npos);
  const std::string tokens = text.substr(begin, text.find("Accepted by", begin + 1) - begin);
  for (const RefinementTraits& row : refinements) {
    std::ostringstream line;
    line << "        " << padded(std::string(row.token_name), 41) << "0x" << std::hex << std::uppercase << row.token
         << "\n";
    EXPECT_NE(tokens.find(line.str()), std::string::npos) << line.str();
  }
}

TEST(Parameters, InitialValuesAreThoseOfTheText) {
  const ArkState state;
  for (const Parameter& parameter : parameters()) {
    if (parameter.kind != Parameter::Kind::token && parameter.initial.find_first_of("MT") == std::string_view::npos &&
        parameter.initial != "FALSE") {
      EXPECT_EQ(parameter.get(state), std::stod(std::string(parameter.initial))) << parameter.text;
    }
    if (parameter.kind == Parameter::Kind::token) {
      EXPECT_EQ(parameter.get(state), parameter.tokens[0].token) << parameter.text;
      EXPECT_EQ(parameter.tokens[0].name, parameter.initial);
    }
  }
}

TEST(Parameters, WhatIsSetIsReadBack) {
  for (const Parameter& parameter : parameters()) {
    ArkState state;
    for (const TokenName& token : parameter.tokens) {
      EXPECT_EQ(set_integer(parameter, {}, static_cast<GLint>(token.token), state), GLenum{GL_NO_ERROR});
      EXPECT_EQ(parameter.get(state), token.token) << parameter.text;
    }
    if (parameter.kind == Parameter::Kind::number) {
      EXPECT_EQ(set_number(parameter, 0.5F, state), GLenum{GL_NO_ERROR});
      EXPECT_EQ(parameter.get(state), 0.5) << parameter.text;
    } else {
      EXPECT_EQ(set_number(parameter, 1, state), GLenum{GL_INVALID_ENUM}) << parameter.text;
    }
  }
}

TEST(Parameters, SettingsThatMeanTheSameExist) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.setting.empty()) continue;
    EXPECT_NE(settings::find_setting(parameter.setting), nullptr) << parameter.setting;
  }
}

TEST(Refinements, WordsAndTokensDiffer) {
  std::set<std::string_view> words;
  std::set<GLenum> tokens;
  for (const RefinementTraits& row : refinements) {
    words.insert(row.word);
    tokens.insert(row.token);
    EXPECT_EQ(settings::parse_refinement(row.word), row.refinement);
  }
  EXPECT_EQ(words.size(), refinements.size());
  EXPECT_EQ(tokens.size(), refinements.size());
}

}  // namespace
}  // namespace glark::core::test
