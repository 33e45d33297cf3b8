// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A case has a name, which --filter matches, and adds rows to the report.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/interleave.h"
#include "tests/bench/report.h"

namespace glark::bench {

// The aim of refined vertices that are kept: nearly the speed of a static mesh that was refined beforehand.
inline constexpr double like_static = 0.97;

struct Case {
  std::string name;
  std::function<void(Report&, const Effort&)> run;
};

void add_draw_cases(std::vector<Case>& cases);
void add_pool_cases(std::vector<Case>& cases);
void add_capture_cases(std::vector<Case>& cases);
void add_call_cases(std::vector<Case>& cases);
void add_scene_cases(std::vector<Case>& cases);
void add_adaptive_cases(std::vector<Case>& cases);
void add_qas_cases(std::vector<Case>& cases);  // if glark-qas is built
void add_qas_draw_cases(std::vector<Case>& cases);
void add_surfel_cases(std::vector<Case>& cases);  // if glark-surfel is built
void add_shape_cases(std::vector<Case>& cases);
void add_figure_cases(std::vector<Case>& cases);
void add_screen_error_cases(std::vector<Case>& cases);
void add_weld_cases(std::vector<Case>& cases);
void add_panel_cases(std::vector<Case>& cases);  // if the panel and SDL 2 are there

}  // namespace glark::bench
