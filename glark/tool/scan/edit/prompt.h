// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Operations that are typed in, one after the other.
#pragma once

#include <glark/edit.h>

#include <functional>

namespace glark::tool {

// Reads lines from standard input until it ends, or until "quit": operations, "save FILE" and "help". A terminal gets a
// prompt, and a message for a line that is wrong. Otherwise such a line throws std::runtime_error with its number.
void edit_by_prompt(edit::Session& session, const std::function<void(const std::string& output)>& save);

}  // namespace glark::tool
