// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Several ranks: what they send each other, how they end together, and that a sampling has the bytes of a single process.
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>

#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/ranks/deliver.h"
#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/ranks/sample/open_changes.h"
#include "glark/clients/stream/ranks/sample/sample.h"
#include "glark/clients/stream/ranks/sample/shares.h"
#include "glark/clients/stream/sample/sample_steps.h"
#include "tests/stream/temporary_folder.h"
#include "tests/stream/thread_ranks.h"

namespace glark::stream {
namespace {

TEST(Ranks, RangesFollowOneAnother) {
  const OneRank alone;
  EXPECT_EQ(range_of(alone, 1000, 64).end, 1000U);
  run_ranks(5, [](Ranks& ranks) {
    for (const std::uint64_t count : {0, 3, 64, 1000}) {
      EXPECT_EQ(range_of(ranks, 0, count, 64).begin, 0U);
      EXPECT_EQ(range_of(ranks, 4, count, 64).end, count);
      for (std::size_t rank = 1; rank < 5; ++rank)
        EXPECT_EQ(range_of(ranks, rank - 1, count, 64).end, range_of(ranks, rank, count, 64).begin);
    }
  });
}

TEST(Ranks, EachGetsWhatIsForIt) {
  run_ranks(4, [](Ranks& ranks) {
    std::vector<std::vector<std::uint32_t>> values(4);
    for (std::uint32_t to = 0; to < 4; ++to)
      values[to].assign(to, static_cast<std::uint32_t>(10 * ranks.rank() + to));  // none for rank 0
    std::size_t senders = 0;
    deliver_values(ranks, values, [&](std::size_t from, std::span<const std::uint32_t> some) {
      ++senders;
      EXPECT_EQ(some.size(), ranks.rank());
      EXPECT_EQ(some[0], 10 * from + ranks.rank());
    });
    EXPECT_EQ(senders, ranks.rank() == 0 ? 0U : 4U);
  });
}

TEST(Ranks, AllHaveWhatOneHas) {
  for (std::size_t size = 1; size < 7; ++size)
    run_ranks(size, [size](Ranks& ranks) {
      for (std::size_t from = 0; from < size; ++from) {
        std::vector<char> bytes;
        if (ranks.rank() == from) bytes = {'a', static_cast<char>('b' + from)};
        broadcast(ranks, bytes, from);
        EXPECT_EQ(std::string(bytes.begin(), bytes.end()), std::string("a") + static_cast<char>('b' + from));
      }
      std::vector<std::uint64_t> numbers{1, ranks.rank()};
      add_up(ranks, numbers);
      if (ranks.rank() == 0) {
        EXPECT_EQ(numbers, (std::vector<std::uint64_t>{size, size * (size - 1) / 2}));
      }
    });
}

TEST(Ranks, AnErrorOfOneIsThatOfAll) {
  std::atomic<int> ended = 0;
  run_ranks(3, [&](Ranks& ranks) {
    try {
      together(ranks, [&] {
        if (ranks.rank() > 0) throw Error(Element::file, 0, "a.ply: is cut off");
      });
    } catch (const RanksError& error) {
      EXPECT_STREQ(error.what(), "a.ply: is cut off (rank 1 of 3)");
      ++ended;
    }
  });
  EXPECT_EQ(ended, 3);
}

TEST(Ranks, CellsAreDealtByTheirPoints) {
  std::vector<Cell> cells;
  for (std::uint64_t i = 0; i < 90; ++i) cells.push_back({.key = i, .count = 1 + i % 3, .first = 1000 - i});
  const std::vector<std::uint32_t> owners = deal_cells(cells, 3);
  std::vector<std::uint64_t> points(3);
  for (std::size_t i = 0; i < cells.size(); ++i) points[owners[i]] += cells[i].count;
  EXPECT_EQ(points, (std::vector<std::uint64_t>{60, 60, 60}));
  EXPECT_EQ(owners[89], 0U);  // the cell with the first point
  EXPECT_EQ(owners[0], 2U);
}

// The tables of two ranks fit alone, but not together; and only after the second of three batches.
TEST(Ranks, TheMemoryOfAllIsAddedUp) {
  Plan plan;
  plan.open_bytes = 1000;
  for (const std::int64_t bytes : {600, 900})
    run_ranks(2, [&](Ranks& ranks) {
      const std::vector<OpenChange> changes{{1, bytes}, {2, -bytes}};
      EXPECT_EQ(fit_in_open_memory(ranks, plan, 3, changes), bytes == 600);
    });
}

class RanksSampling : public TemporaryFolder {
 protected:
  // Writes points with normals that turn with the first coordinate.
  std::filesystem::path write(const std::vector<double>& positions, bool normals) const {
    std::filesystem::path file = path("scan.ply");
    const auto writer = create_points(file, {Number::float32, normals, {{"red", Number::uint8}}});
    std::vector<float> turned;
    std::vector<double> red;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      turned.insert(turned.end(),
                    {static_cast<float>(std::cos(positions[i])), static_cast<float>(std::sin(positions[i])), 0});
      red.push_back(static_cast<double>(i % 256));
    }
    writer->write({0, positions, normals ? std::span<const float>(turned) : std::span<const float>(), red});
    writer->finish();
    return file;
  }

  // Samples the scan alone and by several ranks. Returns the report of the first.
  SampleReport check(const std::filesystem::path& file, SampleOptions options,
                     const std::vector<std::size_t>& sizes = {1, 3}) const {
    options.memory = std::size_t{40} << 20;
    options.allow_in_core = false;
    options.threads = 1;
    SampleReport alone = sample_file(file, path("alone.ply"), options);
    for (const std::size_t size : sizes) {
      run_ranks(size, [&](Ranks& ranks) {
        const SampleReport report = sample_file(ranks, {file, path("ranks.ply"), {}, {}}, options);
        EXPECT_EQ(report.is_shuffled, alone.is_shuffled);
        if (ranks.rank() == 0) {
          EXPECT_EQ(report.samples, alone.samples);
        }
      });
      EXPECT_TRUE(bytes_of(path("alone.ply")) == bytes_of(path("ranks.ply"))) << size;
      EXPECT_EQ(bytes_of(path("alone.ply.cells")), bytes_of(path("ranks.ply.cells"))) << size;
    }
    return alone;
  }
};

std::vector<double> sphere(std::size_t count) {
  std::vector<double> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(count) - 1;
    const double angle = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1 - z * z);
    positions.insert(positions.end(), {r * std::cos(angle), r * std::sin(angle), z});
  }
  return positions;
}

std::vector<double> shuffled(const std::vector<double>& positions) {
  std::vector<std::size_t> order(positions.size() / 3);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  std::vector<double> result;
  for (const std::size_t i : order)
    result.insert(result.end(), {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]});
  return result;
}

TEST_F(RanksSampling, CoherentPointsGiveTheSameBytes) {
  const std::filesystem::path file = write(sphere(90000), true);
  EXPECT_FALSE(check(file, {.target = 3000}, {1, 2, 3, 4, 7}).is_shuffled);
  for (const std::size_t target : {1U, 7U, 99U}) check(file, {.target = target}, {3});
  check(file, {.error = 1e-3});
}

TEST_F(RanksSampling, ShuffledPointsGiveTheSameBytes) {
  EXPECT_TRUE(check(write(shuffled(sphere(90000)), true), {.target = 5000}).is_shuffled);
  check(write(shuffled(sphere(60000)), false), {.target = 2000});
}

// So many points share a few places that the plan expects too few small cubes elsewhere: streaming gives up on the way.
TEST_F(RanksSampling, AllGiveUpStreamingWhereOneProcessDoes) {
  std::vector<double> positions;
  const std::vector<double> piles = sphere(50), others = shuffled(sphere(100000));
  for (std::size_t i = 0; i < 600000; ++i)
    for (std::size_t k = 0; k < 3; ++k) positions.push_back(0.1 * piles[3 * (i / 12000) + k]);
  positions.insert(positions.end(), others.begin(), others.end());
  const std::filesystem::path file = write(positions, true);
  const Source source = file_source(file);
  const SampleOptions options{.target = 8000, .memory = std::size_t{40} << 20};
  const common::Workers workers(1);
  BlockSource points(source, {}, workers);
  WorkFolder nowhere({}, "", false);
  common::Checkpoints checkpoints(nowhere, 1);
  const Census census = take_census(points, counting_options(source, options, 1), {}, checkpoints);
  EXPECT_FALSE(make_plan(census, options).is_shuffled);
  EXPECT_TRUE(check(file, options, {3}).is_shuffled);
}

TEST_F(RanksSampling, ABadPointLeavesTheOldSamples) {
  std::vector<double> positions = sphere(90000);
  positions[3 * 80000] = std::nan("");
  const std::filesystem::path file = write(positions, false);
  made("ranks.ply", "old");
  std::atomic<int> ended = 0;
  run_ranks(3, [&](Ranks& ranks) {
    try {
      sample_file(ranks, {file, path("ranks.ply"), {}, {}}, {.target = 100, .allow_in_core = false});
    } catch (const RanksError& error) {
      EXPECT_NE(std::string(error.what()).find("skip_invalid (rank 2 of 3)"), std::string::npos) << error.what();
      ++ended;
    }
  });
  EXPECT_EQ(ended, 3);
  EXPECT_EQ(bytes_of(path("ranks.ply")), "old");
  check(file, {.target = 1000, .skip_invalid = true});
}

}  // namespace
}  // namespace glark::stream
