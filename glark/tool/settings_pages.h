// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The table of settings as document text. scripts/options puts it into docs/reference/options.md and docs/man/glark.1.
#pragma once

#include <string>

namespace glark::tool {

std::string settings_as_markdown();
std::string settings_as_manual();  // troff, macros of man(7)

}  // namespace glark::tool
