// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace glark::conformance {

using Files = std::map<std::string, std::string>;  // name in the archive, bytes

// Hexadecimal.
std::string sha256(const std::string& bytes);

// A .tar.gz with the same bytes for the same files. Throws std::runtime_error; no half archive is left.
void write_archive(const Files& files, const std::string& path);

// Throws std::runtime_error that names the archive and what is wrong with it.
Files read_archive(const std::string& path);

}  // namespace glark::conformance
