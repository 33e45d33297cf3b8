// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where an edit goes if no option says so.
#pragma once

#include <filesystem>

namespace glark::tool {

// The folder of the session: scan.edit for scan.ply.
inline std::filesystem::path session_folder(std::filesystem::path scan) { return scan.replace_extension(".edit"); }

// The edited scan: scan.edited.ply for scan.ply.
inline std::filesystem::path edited_scan(const std::filesystem::path& scan) {
  return std::filesystem::path(scan).replace_extension(".edited" + scan.extension().string());
}

}  // namespace glark::tool
