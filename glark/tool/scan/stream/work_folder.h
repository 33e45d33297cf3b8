// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace glark::tool {

inline constexpr const char* resume_help =
    "Continue a run that was killed, or that stopped because the disk was full, from its folder OUTPUT.partial";

// The folder for the state of the work. Pipes and devices have none.
inline std::filesystem::path work_folder(const std::filesystem::path& output) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(output, error);
  const bool is_file = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
  return is_file ? std::filesystem::path(output.string() + ".partial") : std::filesystem::path();
}

}  // namespace glark::tool
