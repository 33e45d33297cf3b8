// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A transfer that ended early continues, with one rank or several.
#include <array>

#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/ranks/transfer.h"
#include "tests/stream/edited_sheets.h"
#include "tests/stream/thread_ranks.h"

namespace glark::stream {
namespace {

class ResumedTransfers : public Edited {
 protected:
  static constexpr std::size_t most_ranks = 3;
  struct Run {
    TransferReport report;                          // of rank 0
    std::string problem;                            // of rank 0
    std::array<double, most_ranks> first_fraction;  // of the progress of each rank
  };

  // Many more points than a state is saved for, and some of them away from the sampling.
  void SetUp() override {
    Edited::SetUp();
    const AllPoints small = sheet(18);
    AllPoints large = sheet(1000);
    for (std::size_t i = 2; i < large.positions.size(); i += 300) large.positions[i] += 50;
    write("large.ply", large, plain);
    write("small.ply", small, plain);
    write("edited.ply",
          moved(small,
                [](const Point& p) {
                  return Point{p[0], p[1], p[2] + 0.3 * std::sin(p[0])};
                }),
          plain);
  }

  // All ranks fail when they have done more than this part of their work.
  Run run(std::size_t size, const char* output, bool resume, double end = 2) const {
    Run result;
    result.first_fraction.fill(-1);
    run_ranks(size, [&](Ranks& ranks) {
      TransferOptions options;
      options.work = path(output) += ".partial";
      options.resume = resume;
      options.threads = 1;
      options.neighbours = 3;
      double& first = result.first_fraction[ranks.rank()];
      options.progress = [&first, end](double fraction) {
        if (first < 0) first = fraction;
        if (fraction > end) throw Error(Element::file, 0, "ended");
      };
      TransferReport report;
      const std::string problem = problem_of([&] {
        report = transfer(ranks, {path("large.ply"), path("small.ply"), path("edited.ply"), path(output)}, options);
      });
      if (ranks.rank() > 0) return;
      result.report = report;
      result.problem = problem;
    });
    return result;
  }
  bool has_work(const char* output) const { return std::filesystem::exists(path(output) += ".partial"); }
};

TEST_F(ResumedTransfers, RanksContinueWhatWasSaved) {
  const Run whole = run(2, "whole.ply", false);
  EXPECT_EQ(whole.problem, "");
  EXPECT_GT(whole.report.points_away, 1000U);
  EXPECT_NE(run(2, "out.ply", false, 0.9).problem, "");
  EXPECT_TRUE(has_work("out.ply"));
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
  const Run resumed = run(2, "out.ply", true);
  EXPECT_EQ(resumed.problem, "");
  EXPECT_GT(resumed.first_fraction[0], 0.8);
  EXPECT_GT(resumed.first_fraction[1], 0.8);
  EXPECT_EQ(resumed.report.points_away, whole.report.points_away);
  EXPECT_TRUE(bytes_of(path("out.ply")) == bytes_of(path("whole.ply")));
  EXPECT_FALSE(has_work("out.ply"));
}

// A state counts for the same number of ranks, and together with its output. A run that ended after the output had got
// its name, before the folder was removed, leaves states alone.
TEST_F(ResumedTransfers, OtherStatesAreNotUsed) {
  EXPECT_NE(run(2, "out.ply", false, 0.9).problem, "");
  const Run with_more = run(3, "out.ply", true, 0);
  for (const double first : with_more.first_fraction) EXPECT_LT(first, 0.2);
  EXPECT_FALSE(has_work("out.ply"));  // nothing new was saved
  EXPECT_NE(run(2, "out.ply", false, 0.9).problem, "");
  std::filesystem::remove(WorkFolder::path_in(path("out.ply") += ".partial", "output"));
  const Run without_output = run(2, "out.ply", true, 0);
  EXPECT_LT(without_output.first_fraction[0], 0.2);
  EXPECT_LT(without_output.first_fraction[1], 0.2);
  EXPECT_FALSE(has_work("out.ply"));
}

TEST_F(ResumedTransfers, AloneAllPointsAwayAreCounted) {
  double first = -1;  // fraction that the progress tells
  const auto alone = [&](const char* output, bool resume, double end) {
    TransferOptions options;
    options.work = path(output) += ".partial";
    options.resume = resume;
    options.neighbours = 3;
    first = -1;
    options.progress = [&](double fraction) {
      if (first < 0) first = fraction;
      if (fraction > end) throw Error(Element::file, 0, "ended");
    };
    return transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path(output), options);
  };
  const TransferReport whole = alone("whole.ply", false, 2);
  EXPECT_NE(problem_of([&] { alone("out.ply", false, 0.7); }), "");
  const TransferReport resumed = alone("out.ply", true, 2);
  EXPECT_GT(first, 0.4);
  EXPECT_GT(whole.points_away, 1000U);
  EXPECT_EQ(whole.points_away, resumed.points_away);
  EXPECT_TRUE(bytes_of(path("out.ply")) == bytes_of(path("whole.ply")));
}

}  // namespace
}  // namespace glark::stream
