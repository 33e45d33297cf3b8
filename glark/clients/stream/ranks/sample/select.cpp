// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/select.h"
#include "glark/clients/stream/files/work_folder.h"

#include <optional>

#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/sample/sample_pieces.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t not_selected = ~std::uint64_t{0};
constexpr std::uint64_t unlimited = std::uint64_t{1} << 62;

struct CellNumber {
  std::uint64_t cell = 0, number = 0;
};

// A number of each owned cell, to rank 0: [cells] there.
std::vector<std::uint64_t> gather_numbers(Ranks& ranks, const SelectInput& input,
                                          const std::vector<std::uint64_t>& of_owned) {
  std::vector<CellNumber> own;
  for (std::size_t i = 0; i < of_owned.size(); ++i) own.push_back({input.shares.owned[i], of_owned[i]});
  std::vector<std::uint64_t> all(ranks.rank() == 0 ? input.plan.cells.size() : 0);
  gather(ranks, bytes_of(std::span<const CellNumber>(own)), [&](std::size_t, std::span<const char> bytes) {
    std::vector<CellNumber> some(bytes.size() / sizeof(CellNumber));
    std::copy(bytes.begin(), bytes.end(), bytes_of(some).begin());
    for (const CellNumber& each : some) all[static_cast<std::size_t>(each.cell)] = each.number;
  });
  return all;
}

// The first nodes of all trees, which is all that the assembly needs, in a file of rank 0.
std::unique_ptr<TreeStore> gather_roots(Ranks& ranks, const SelectInput& input) {
  struct Top {
    std::uint64_t cell = 0;
    TreeStore::Root root;
    ClusterNode node;
  };
  std::vector<Top> own;
  std::unique_ptr<TreeStore> all;
  together(ranks, [&] {
    std::vector<ClusterNode> nodes;
    for (const std::uint32_t cell : input.shares.owned) {
      input.trees.read(cell, nodes);
      own.push_back({cell, input.trees.root(cell), nodes.front()});
    }
    const WorkFolder nowhere({}, "", false);
    if (ranks.rank() == 0) all = std::make_unique<TreeStore>(nowhere, input.folder, input.plan.cells.size());
  });
  std::string problem;
  gather(ranks, bytes_of(std::span<const Top>(own)), [&](std::size_t, std::span<const char> bytes) {
    std::vector<Top> some(bytes.size() / sizeof(Top));
    std::copy(bytes.begin(), bytes.end(), bytes_of(some).begin());
    if (!problem.empty()) return;
    problem = problem_of([&] {
      for (const Top& top : some) all->put(static_cast<std::size_t>(top.cell), {{top.node}, top.root.shape});
    });
  });
  require_no_problem(ranks, problem);
  return all;
}

Divisions gather_divisions(Ranks& ranks, const SelectInput& input) {
  Divisions divisions;
  together(ranks, [&] {
    for (const std::uint32_t cell : input.shares.owned) add_divisions(input.trees, cell, divisions);
  });
  add_up(ranks, divisions.counts());
  return divisions;
}

// How many samples the owned cells add if there are enough to share out.
std::vector<std::uint64_t> spent_by_cells(Ranks& ranks, const SelectInput& input, const Cut& cut) {
  std::vector<std::uint64_t> spent;
  together(ranks, [&] {
    const EmitSample emit = [](const std::array<double, 3>&, const ClusterNode&) {};
    std::vector<SampledCell> cells;
    CellSamples samples(emit, cells);
    for (const std::uint32_t cell : input.shares.owned) {
      Chooser chooser({cut.threshold, cut.least, cut.spare > 0 ? unlimited : 0});
      select_in_cell(input.plan, input.trees, cell, chooser, samples);
      spent.push_back(cut.spare > 0 ? unlimited - chooser.spare() : 0);
    }
  });
  return gather_numbers(ranks, input, spent);
}

// How many samples are left to share out when the single process comes to each cell; not_selected for the cells of a cube
// that becomes one sample. On rank 0. A cell takes all it can, or all that is left, so `spent` suffices.
std::vector<std::uint64_t> spare_at_cells(const Assembly& assembly, const Cut& cut,
                                          const std::vector<std::uint64_t>& spent) {
  std::vector<std::uint64_t> spare(spent.size(), not_selected);
  std::vector<SampledCell> cells(spent.size());
  assembly.select(
      cut,
      [&](std::size_t cell, Chooser& chooser, CellSamples&) {
        spare[cell] = chooser.spare();
        chooser.spend(spent[cell]);
      },
      [](const std::array<double, 3>&, const ClusterNode&) {}, cells);
  return spare;
}

// Chooses the samples of the owned cells. Returns their number in each of them.
std::vector<std::uint64_t> select_owned(const SelectInput& input, const Cut& cut,
                                        const std::vector<std::uint64_t>& spare, SampleSpool& spool) {
  std::vector<std::uint64_t> counts;
  const EmitSample emit = [&](const std::array<double, 3>& position, const ClusterNode& node) {
    spool.add({position, node.normal, node.colour, node.count, node.square});
  };
  std::vector<SampledCell> cells;
  CellSamples samples(emit, cells);
  for (const std::uint32_t cell : input.shares.owned) {
    const std::uint64_t before = spool.count();
    if (spare[cell] != not_selected) {
      Chooser chooser({cut.threshold, cut.least, spare[cell]});
      select_in_cell(input.plan, input.trees, cell, chooser, samples);
    }
    counts.push_back(spool.count() - before);
  }
  return counts;
}

}  // namespace

void select_samples(Ranks& ranks, const SelectInput& input, const ChooseCut& cut_of, const WriteSamples& write) {
  const bool is_first = ranks.rank() == 0;
  const std::unique_ptr<TreeStore> roots = gather_roots(ranks, input);
  const Divisions divisions = gather_divisions(ranks, input);
  std::optional<Assembly> assembly;
  std::vector<Cut> cut;
  together(ranks, [&] {
    if (!is_first) return;
    assembly.emplace(input.plan, *roots, divisions);
    cut.push_back(cut_of(*assembly));
  });
  broadcast_values(ranks, cut);
  const std::vector<std::uint64_t> spent = spent_by_cells(ranks, input, cut[0]);
  std::vector<std::uint64_t> spare;
  together(ranks, [&] {
    if (is_first) spare = spare_at_cells(*assembly, cut[0], spent);
  });
  broadcast_values(ranks, spare);
  std::optional<SampleSpool> spool;
  std::vector<std::uint64_t> own_counts;
  together(ranks, [&] {
    spool.emplace(input.folder);
    own_counts = select_owned(input, cut[0], spare, *spool);
  });
  const std::vector<std::uint64_t> counts = gather_numbers(ranks, input, own_counts);
  SamplePieces pieces(ranks, input.shares, *spool, own_counts, counts);
  if (!is_first) return pieces.send_all();
  pieces.write_all([&](const SelectCell& add_samples) {
    write(*assembly, cut[0], [&](std::size_t cell, Chooser& chooser, CellSamples& samples) {
      chooser.spend(spent[cell]);
      add_samples(cell, chooser, samples);
    });
  });
}

}  // namespace glark::stream
