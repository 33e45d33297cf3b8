// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace glark::stream {

std::string index_text(const CellIndex& index);
// Throws Error for text that is no index. file: its name, for messages.
CellIndex parse_index(std::string_view text, const std::string& file);

// Throws Error if the file exists and is no index: the user has made it. Commands call it before a long computation.
void require_replaceable_index(const std::filesystem::path& file);

}  // namespace glark::stream
