// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <initializer_list>

namespace glark::stream {

// Throws Error if `output` is one of these files, under this name or another (a link). Empty names and files that are
// pipes or devices are passed over.
void require_other_file(const std::filesystem::path& output, std::initializer_list<std::filesystem::path> inputs);

}  // namespace glark::stream
