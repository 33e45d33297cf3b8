// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

namespace glark::shim {

// The classes of draws for the statistics file, those with most triangles first.
nlohmann::json draw_classes();

}  // namespace glark::shim
