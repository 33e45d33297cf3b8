// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark help TOPIC: one option, one reason, or one key of a rule, from the tables that also make the manual.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glark::tool {

// Options without "--", causes, fallbacks, keys of rules. Sorted.
std::vector<std::string> help_topics();

// Nothing if there is no such topic. `colors`: the text is for a terminal that shows them.
std::optional<std::string> help_on(std::string_view topic, bool colors);

// The topic that was probably meant, or an empty text.
std::string nearest_topic(std::string_view wrong);

}  // namespace glark::tool
