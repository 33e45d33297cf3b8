// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of options with readable messages. The checks of CLI11 show its own notation.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace glark::tool {

inline CLI::Validator above_zero() {
  return {[](std::string& text) -> std::string {
            double value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value);
            return good ? "" : "\"" + text + "\" is not a number above 0";
          },
          ""};
}

// Accepts the given words, and turns a word into its value.
template <class Value>
CLI::Validator one_of(std::vector<std::pair<std::string, Value>> words) {
  return {[words = std::move(words)](std::string& text) -> std::string {
            std::string possible;
            for (const auto& [word, value] : words) {
              if (word == text) {
                text = std::to_string(static_cast<int>(value));
                return {};
              }
              possible += (possible.empty() ? "" : ", ") + word;
            }
            return "\"" + text + "\" is not one of " + possible;
          },
          ""};
}

}  // namespace glark::tool
