// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace glark::settings {

// Returns the name that `wrong` was probably meant to be; empty if all names differ too much. Upper and lower case, and
// '-' and '_', count as equal.
std::string_view nearest_name(std::string_view wrong, std::span<const std::string_view> names);

}  // namespace glark::settings
