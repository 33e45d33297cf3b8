// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Timing on a machine that others also use. The competitors take turns of a few milliseconds and are compared turn by
// turn.
#pragma once

#include <functional>
#include <vector>

namespace glark::bench {

struct Effort {
  double sample_seconds = 0.004;  // for one turn of one competitor; at least one draw
  double total_seconds = 0.6;     // for one comparison, approximately
  int fewest_rounds = 5;          // for rounds of less than a second; otherwise one round
  int most_rounds = 61;
  double longest_draw_seconds = 30;  // a competitor expected to take longer is left out
};

struct Competitor {
  std::function<void()> prepare;  // before every turn, not timed: binds its state
  std::function<void()> draw;     // timed
};

// The seconds of one draw in each round.
struct Times {
  std::vector<double> seconds;
  double median() const;
  double least() const;
};

std::vector<Times> interleave(const std::vector<Competitor>& competitors, const Effort& effort);

// Returns the median over the rounds of `slow` / `fast`: how many times as fast `fast` is.
double speed_ratio(const Times& slow, const Times& fast);

// Returns the sum of factors[i] times the least of times[i]. Medians would still contain the time of other programs,
// which would hide small differences.
double least_combination(const std::vector<Times>& times, const std::vector<double>& factors);

}  // namespace glark::bench
