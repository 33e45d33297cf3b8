// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tables of the program as document text. scripts/parts/options puts them into docs/reference and docs/man/glark.1.
#pragma once

#include <string>

namespace glark::tool {

std::string settings_as_markdown();
std::string settings_as_manual();  // troff, macros of man(7)
std::string rules_as_markdown();   // the keys of a [[rule]]
std::string causes_as_markdown();  // why draws stay unrefined, or get another refinement

}  // namespace glark::tool
