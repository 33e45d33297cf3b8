// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of options, where those of CLI11 show users its own notation.
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
            return good ? "" : "\"" + text + "\" is no number above 0";
          },
          ""};
}

// The value for each word that is possible.
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
            return "\"" + text + "\" is none of " + possible;
          },
          ""};
}

}  // namespace glark::tool
