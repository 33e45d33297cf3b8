// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <string>
#include <string_view>

namespace glark::stream {

std::string index_text(const CellIndex& index);
// Throws Error for text that is no index. file: its name, for messages.
CellIndex parse_index(std::string_view text, const std::string& file);

}  // namespace glark::stream
