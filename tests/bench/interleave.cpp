// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/interleave.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/bench/gl.h"

namespace glark::bench {
namespace {

// Two draws: the first one compiles shaders, the second one fills caches.
constexpr int warm_up_draws = 4;
constexpr double warm_up_limit = 2;

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double time_draws(const Competitor& competitor, int draws) {
  using Clock = std::chrono::steady_clock;
  competitor.prepare();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glFinish();
  const auto begin = Clock::now();
  for (int i = 0; i < draws; ++i) competitor.draw();
  glFinish();
  return std::chrono::duration<double>(Clock::now() - begin).count() / draws;
}

double warm_up(const Competitor& competitor) {
  double last = 0;
  double total = 0;
  for (int i = 0; i < warm_up_draws && (i == 0 || total + last < warm_up_limit); ++i) {
    last = time_draws(competitor, 1);
    total += last;
  }
  return last;
}

}  // namespace

double Times::median() const { return median_of(seconds); }

double Times::least() const { return seconds.empty() ? 0 : *std::min_element(seconds.begin(), seconds.end()); }

std::vector<Times> interleave(const std::vector<Competitor>& competitors, const Effort& effort) {
  std::vector<int> draws;
  double round_seconds = 0;
  for (const Competitor& competitor : competitors) {
    const double once = std::max(warm_up(competitor), 1e-7);
    draws.push_back(std::max(1, static_cast<int>(std::lround(effort.sample_seconds / once))));
    round_seconds += once * draws.back();
  }
  const int wanted = static_cast<int>(effort.total_seconds / round_seconds);
  const int fewest = round_seconds < 1 ? effort.fewest_rounds : 1;
  const int rounds = std::clamp(wanted, fewest, effort.most_rounds);
  std::vector<Times> times(competitors.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < competitors.size(); ++i) {
      const std::size_t turn = (i + static_cast<std::size_t>(round)) % competitors.size();
      times[turn].seconds.push_back(time_draws(competitors[turn], draws[turn]));
    }
  }
  return times;
}

double speed_ratio(const Times& slow, const Times& fast) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < slow.seconds.size() && i < fast.seconds.size(); ++i)
    ratios.push_back(slow.seconds[i] / fast.seconds[i]);
  return median_of(ratios);
}

double least_combination(const std::vector<Times>& times, const std::vector<double>& factors) {
  double sum = 0;
  for (std::size_t i = 0; i < times.size(); ++i) sum += factors[i] * times[i].least();
  return sum;
}

}  // namespace glark::bench
