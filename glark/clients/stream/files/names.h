// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/point_stream.h>

#include <filesystem>
#include <string>

namespace glark::stream {

// Throws Error for an empty name, which the system would take for the current folder. what: "the output", for example.
inline void require_name(const std::filesystem::path& file, const std::string& what) {
  if (file.empty()) throw Error(Element::option, 0, "glark-stream: the name of " + what + " is empty; name a file");
}

}  // namespace glark::stream
