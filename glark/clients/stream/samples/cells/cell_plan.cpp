// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/cells/cell_plan.h"

#include <fmt/format.h>
#include <glark/point_stream.h>

#include <algorithm>

#include "glark/clients/stream/samples/cells/sample_cells.h"

namespace glark::stream {
namespace {

constexpr std::size_t least_cell = 64, most_cell = 4096;  // samples; larger cells take longer to load than they save
constexpr std::size_t cells_of_a_thread = 4;              // in use beside the cache: two held, two being loaded
constexpr std::size_t cached_cells = 8;                   // of each thread, at least
constexpr std::size_t unreturned_bytes = 12 << 20;        // freed, but not returned to the system yet
constexpr std::size_t directory_bytes_a_cell = 96;        // its place, its box, its slot in the cache
constexpr std::size_t least_fill = 4;                     // a cell has a quarter of the most samples, on the average

std::size_t directory_bytes(std::size_t samples, std::size_t samples_a_cell) {
  return directory_bytes_a_cell * (samples * least_fill / samples_a_cell + 1);
}

}  // namespace

CellPlan plan_cells(const SamplingMemory& all, std::size_t samples, std::size_t channels, std::size_t threads) {
  const std::size_t memory = all.sampling - std::min(all.sampling / 4, unreturned_bytes);
  CellPlan plan{most_cell, 0, memory / 2, all.process};
  const auto in_use = [&] { return cells_of_a_thread * threads * cell_bytes(plan.samples_a_cell, channels); };
  const auto least = [&] { return cached_cells * threads * cell_bytes(plan.samples_a_cell, channels); };
  while (plan.samples_a_cell > least_cell && in_use() + least() > memory / 2) plan.samples_a_cell /= 2;
  const std::size_t needed = in_use() + least() + directory_bytes(samples, plan.samples_a_cell);
  if (needed > memory)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: {} bytes of the memory are left for the {} samples, and {} threads need {}; "
                            "raise the memory, or use fewer threads",
                            memory, samples, threads, needed));
  plan.cache = memory - in_use() - directory_bytes(samples, plan.samples_a_cell);
  return plan;
}

}  // namespace glark::stream
