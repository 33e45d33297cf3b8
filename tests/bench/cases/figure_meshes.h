// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The meshes of figure 7.13 beside those that are read from files.
#pragma once

#include <functional>
#include <string>

#include "tests/bench/cases/case.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {

// Calls `run` with each mesh, its name and the view of it. Notes where there are no models.
void for_each_figure_mesh(Report& report, const std::string& row,
                          const std::function<void(const std::string& name, const Mesh& mesh, View view)>& run);

}  // namespace glark::bench
