// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace glark::bench {

// The root mean square distance of the points of a scan from the tangent planes of their nearest samples, relative to
// the diagonal of the scan. `step`: only each step-th point is measured.
double distance_of(const std::filesystem::path& scan, const std::filesystem::path& sampling, std::uint64_t step);

}  // namespace glark::bench
