// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Files in the folder of a session.
#pragma once

namespace glark::edit {

inline constexpr const char* sample_file = "sample.ply";
inline constexpr const char* cells_file = "sample.ply.cells";

}  // namespace glark::edit
