// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/notes.h"

#include <fmt/format.h>

#include <algorithm>

namespace glark::refine {
namespace {

constexpr std::size_t last_bit = 63;

}  // namespace

std::uint64_t Notes::input(const std::string& name) {
  const auto found = std::find(inputs_.begin(), inputs_.end(), name);
  const auto index = static_cast<std::size_t>(found - inputs_.begin());
  if (found == inputs_.end()) inputs_.push_back(name);
  return std::uint64_t{1} << std::min(index, last_bit);
}

Value Notes::worsened(Value value, Variation variation, const Place& place, std::string_view construct) {
  if (!value.varies() || value.variation >= variation) return value;
  value.variation = variation;
  value.reason = static_cast<int>(reasons_.size());
  reasons_.push_back({place, std::string(construct), value.inputs});
  return value;
}

std::set<std::string> Notes::inputs_of(const Value& value) const {
  std::set<std::string> names;
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    if ((value.inputs >> std::min(i, last_bit) & 1U) != 0) names.insert(inputs_[i]);
  return names;
}

std::string Notes::explain(const Value& value) const {
  if (value.reason < 0) return {};
  const Reason& reason = reasons_[static_cast<std::size_t>(value.reason)];
  std::string names;
  for (std::size_t i = 0; i < std::min(inputs_.size(), last_bit); ++i) {
    if ((reason.inputs >> i & 1U) != 0) names += (names.empty() ? "'" : ", '") + inputs_[i] + "'";
  }
  const std::string shader = units_ > 1 ? fmt::format("vertex shader {}, ", reason.place.unit) : std::string();
  return fmt::format("{}line {}: {} of {}", shader, reason.place.line, reason.construct, names);
}

}  // namespace glark::refine
