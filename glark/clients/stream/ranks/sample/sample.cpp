// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/sample.h"
#include "glark/clients/stream/files/work_folder.h"

#include <functional>
#include <memory>

#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/ranks/agreement.h"
#include "glark/clients/stream/ranks/sample/build_trees.h"
#include "glark/clients/stream/ranks/sample/select.h"
#include "glark/clients/stream/ranks/sample/send_points.h"
#include "glark/clients/stream/sample/sample_and_publish.h"
#include "glark/clients/stream/sample_files.h"

namespace glark::stream {
namespace {

// A sampling by several ranks. The steps are called in their order, on all ranks.
class RanksSampling {
 public:
  // make: may throw.
  RanksSampling(Ranks& ranks, const std::function<RanksSampleInput()>& make, const SampleOptions& options)
      : ranks_(ranks), options_(options), workers_(options.threads) {
    options_.work.clear();
    options_.resume = false;
    together(ranks, [&] {
      require_valid(options_);
      input_ = make();
      points_ = std::make_unique<BlockSource>(input_.source, reading_options(options_), workers_);
      is_alone_ = is_sampled_in_core(*points_, options_) || !points_->can_seek() || !points_->count();
    });
    require_same(ranks, points_->count().value_or(0), input_.source.name);
  }

  // Whether rank 0 does all of it.
  bool is_alone() const { return is_alone_; }
  SampleReport sample_alone() {
    SampleReport report;
    together(ranks_, [&] {
      if (ranks_.rank() != 0) return;
      report = sample_and_publish(input_.source, options_, input_.temporary, input_.create, input_.published);
    });
    return report;
  }

  void count() {
    std::vector<CensusOptions> counting;
    ReadOptions positions_only = reading_options(options_);
    positions_only.normals = positions_only.channels = false;
    std::unique_ptr<BlockSource> positions;
    together(ranks_, [&] {
      positions = std::make_unique<BlockSource>(input_.source, positions_only, workers_);
      if (ranks_.rank() == 0) counting.push_back(counting_options(input_.source, options_, workers_.count()));
    });
    broadcast_values(ranks_, counting);
    RanksCensus census = take_census(ranks_, *positions, counting[0], part_of_progress(0, 0.3));
    together(ranks_, [&] {
      require_points(census.all, input_.source.name);
      plan_ = make_plan(census.all, options_);
      shares_.range = census.range;
      shares_.owners = deal_cells(plan_.cells, ranks_.size());
      for (std::uint32_t cell = 0; cell < plan_.cells.size(); ++cell)
        if (shares_.owners[cell] == ranks_.rank()) shares_.owned.push_back(cell);
    });
    file_ = std::make_unique<CellFile>(ranks_, shares_, counts_of(plan_.cells, census.own));
    census_ = std::move(census.all);
    census_.cubes = {};
    trim_memory(options_.memory);
  }

  void make_trees() {
    make_store();
    const PointKind kind(points_->schema());
    const SendInput send{*points_, plan_, shares_, input_.temporary, part_of_progress(0.3, 0.4)};
    const BuildInput build{plan_, shares_, *file_, kind, workers_, census_.points};
    if (!plan_.is_shuffled) {
      send_streamed_points(ranks_, send, *file_);
      if (build_streamed_trees(ranks_, build, *trees_)) return;
      plan_.is_shuffled = true;
      make_store();
    }
    send_shuffled_points(ranks_, send, *file_);
    build_shuffled_trees(ranks_, build, *trees_);
  }

  SampleReport write() {
    file_.reset();
    trim_memory(options_.memory);
    SampleReport report = report_of(census_, plan_);
    const auto write = [&](const Assembly& assembly, const Cut& cut, const SelectCell& select_cell) {
      write_samples(assembly, cut, select_cell, points_->schema(), options_, input_.create, report);
      input_.published(report);
    };
    select_samples(
        ranks_, {plan_, shares_, *trees_, input_.temporary},
        [&](const Assembly& assembly) { return cut_of(assembly, census_, options_); }, write);
    if (options_.progress) options_.progress(1);
    return report;
  }

 private:
  void make_store() {
    const WorkFolder nowhere({}, "", false);
    together(ranks_, [&] { trees_ = std::make_unique<TreeStore>(nowhere, input_.temporary, plan_.cells.size()); });
  }
  Progress part_of_progress(double begin, double share) const {
    return [this, begin, share](double fraction) {
      if (options_.progress) options_.progress(begin + share * fraction);
    };
  }

  Ranks& ranks_;
  SampleOptions options_;
  const common::Workers workers_;
  RanksSampleInput input_;
  std::unique_ptr<BlockSource> points_;
  bool is_alone_ = false;
  Census census_;  // without its cubes
  Plan plan_;
  Shares shares_;
  std::unique_ptr<CellFile> file_;
  std::unique_ptr<TreeStore> trees_;
};

SampleReport sample_made(Ranks& ranks, const std::function<RanksSampleInput()>& make, const SampleOptions& options) {
  RanksSampling sampling(ranks, make, options);
  if (sampling.is_alone()) return sampling.sample_alone();
  sampling.count();
  sampling.make_trees();
  return sampling.write();
}

}  // namespace

SampleReport sample(Ranks& ranks, const RanksSampleInput& input, const SampleOptions& options) {
  return sample_made(
      ranks, [&] { return input; }, options);
}

SampleReport sample_file(Ranks& ranks, const RanksSampleFiles& files, const SampleOptions& options) {
  const auto make = [&] {
    const auto all = std::make_shared<SampleFiles>(files.large, files.small, files.formats);
    return RanksSampleInput{all->source(), files.temporary.empty() ? all->folder() : files.temporary,
                            [all](const Schema& schema) { return all->create(schema); },
                            [all](const SampleReport& report) { all->write_index(report); }};
  };
  return sample_made(ranks, make, options);
}

}  // namespace glark::stream
