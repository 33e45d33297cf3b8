// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of options with readable messages. The checks of CLI11 show its own notation.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glark::tool {

inline constexpr int largest_side = 16384;  // of a picture or window, in pixels

// Accepts numbers above 0 that a float can hold, up to the limit of the libraries.
inline CLI::Validator above_zero(double high = 1e18) {
  return {[high](std::string& text) -> std::string {
            constexpr double low = std::numeric_limits<float>::min();
            double value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return good ? "" : fmt::format("\"{}\" is not a number above 0 ({:.2g} to {})", text, low, high);
          },
          ""};
}

// Accepts whole numbers above 0 in decimal digits. A number beyond 64 bits becomes the greatest one of 64 bits.
inline CLI::Validator whole_above_zero() {
  return {[](std::string& text) -> std::string {
            const std::size_t first = text.find_first_not_of('0');
            if (first == std::string::npos || text.find_first_not_of("0123456789") != std::string::npos)
              return "\"" + text + "\" is not a whole number above 0";
            text.erase(0, first);  // a zero in front would mean an octal number
            const std::string greatest = std::to_string(std::numeric_limits<std::uint64_t>::max());
            if (text.size() > greatest.size() || (text.size() == greatest.size() && text > greatest)) text = greatest;
            return {};
          },
          ""};
}

// Accepts a size in bytes above 0, as 1000000, 64MB or 1.5GB, and turns it into a whole number. K, M, G and T are powers of
// 1024.
inline CLI::Validator bytes_above_zero(std::uint64_t least = 1) {
  return {[least](std::string& text) -> std::string {
            constexpr std::string_view units = "kmgt";
            std::string wrong = "\"" + text + "\" is not a size above 0, as 64MB or 1.5GB";
            const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
            double value = 0;
            if (!CLI::detail::lexical_cast(text.substr(0, digits), value)) return wrong;
            std::string unit = CLI::detail::to_lower(CLI::detail::trim_copy(text.substr(digits)));
            if (!unit.empty() && units.find(unit.front()) != std::string_view::npos) {
              value = std::ldexp(value, 10 * (1 + static_cast<int>(units.find(unit.front()))));
              unit.erase(0, 1);
              if (unit == "ib") unit.clear();
            }
            if ((!unit.empty() && unit != "b") || !(value >= 1 && value < 0x1p63)) return wrong;
            if (value < static_cast<double>(least)) return fmt::format("\"{}\" is less than {} bytes", text, least);
            text = std::to_string(static_cast<std::uint64_t>(value));
            return {};
          },
          ""};
}

// Accepts numbers from `low` to `high`, and rejects NaN, unlike CLI::Range.
inline CLI::Validator between(double low, double high) {
  return {[low, high](std::string& text) -> std::string {
            double value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return good ? "" : fmt::format("\"{}\" is not a number from {} to {}", text, low, high);
          },
          fmt::format("from {} to {}", low, high)};
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
