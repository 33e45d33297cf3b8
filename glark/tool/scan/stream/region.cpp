// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/stream/region.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace glark::tool {
namespace {

[[noreturn]] void fail(const std::string& text, const std::string& problem) {
  throw std::runtime_error(
      fmt::format("--refine {}: {}; write box:X,Y,Z,X,Y,Z, sphere:X,Y,Z,R or channel:NAME", text, problem));
}

std::vector<double> numbers_of(const std::string& text, const std::string& list, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : CLI::detail::split(list, ',')) {
    double number = 0;
    if (!CLI::detail::lexical_cast(word, number) || !std::isfinite(number))
      fail(text, fmt::format("\"{}\" is no number", word));
    numbers.push_back(number);
  }
  if (numbers.size() != count) fail(text, fmt::format("it has {} numbers, not {}", numbers.size(), count));
  return numbers;
}

}  // namespace

stream::Region parse_region(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) fail(text, "it has no kind");
  const std::string kind = text.substr(0, colon), rest = text.substr(colon + 1);
  stream::Region region;
  if (kind == "box") {
    const std::vector<double> corners = numbers_of(text, rest, 6);
    for (std::size_t k = 0; k < 3; ++k) {
      region.low[k] = std::min(corners[k], corners[3 + k]);
      region.high[k] = std::max(corners[k], corners[3 + k]);
    }
  } else if (kind == "sphere") {
    const std::vector<double> numbers = numbers_of(text, rest, 4);
    region.kind = stream::Region::Kind::sphere;
    std::copy_n(numbers.begin(), 3, region.centre.begin());
    region.radius = numbers[3];
    if (!(region.radius > 0)) fail(text, "the radius is not above 0");
  } else if (kind == "channel" && !rest.empty()) {
    region.kind = stream::Region::Kind::channel;
    region.channel = rest;
  } else {
    fail(text, fmt::format("\"{}\" is no kind of region", kind));
  }
  return region;
}

}  // namespace glark::tool
