// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state of OpenGL that a draw leaves. A refined draw leaves the same as an unrefined one.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "conformance/random/world.h"

namespace glark::conformance {

using LeftState = std::map<std::string, std::string>;
LeftState left_state(const World& w);
// Says which states differ.
std::optional<std::string> difference_of(const LeftState& refined, const LeftState& plain);

}  // namespace glark::conformance
