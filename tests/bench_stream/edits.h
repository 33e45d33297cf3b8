// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edits whose result is known at every point.
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace glark::bench {

struct Box {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double diagonal() const;
};

Box box_of(const std::filesystem::path& file);

// "none", "bend" (a quarter turn), "twist" (a half turn) or "inflate" (by a tenth at most).
std::array<double, 3> edited(const std::string& edit, const Box& box, const std::array<double, 3>& point);

// Writes the edit of all points.
void write_edited(const std::string& edit, const Box& box, const std::filesystem::path& from,
                  const std::filesystem::path& to);

// The root mean square distance of `result` from the edit of `scan`, relative to the diagonal.
double error_of(const std::string& edit, const Box& box, const std::filesystem::path& scan,
                const std::filesystem::path& result);

}  // namespace glark::bench
