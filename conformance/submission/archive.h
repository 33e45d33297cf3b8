// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace glark::conformance {

using Files = std::map<std::string, std::string>;  // name in the archive, bytes

// Throws std::runtime_error unless the name of a file stays inside the folder that it is relative to.
void check_inside(const std::string& name);

// The SHA-256 sum in hexadecimal digits.
std::string sha256(const std::string& bytes);

// Writes a .tar.gz. Equal files give equal bytes. Throws std::runtime_error and then leaves no partial archive.
void write_archive(const Files& files, const std::string& path);

// Throws std::runtime_error that names the archive and what is wrong with it.
Files read_archive(const std::string& path);

}  // namespace glark::conformance
