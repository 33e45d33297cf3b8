// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samplings that do not fit into memory: cells on the disk give what samples in memory give.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "glark/clients/stream/files/sorted_records.h"
#include "glark/clients/stream/samples/cells/cell_builder.h"
#include "glark/clients/stream/samples/cells/cell_plan.h"
#include "glark/clients/stream/samples/cells/samples_in_cells.h"
#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using common::Vector3f;

class Cells : public TemporaryFolder {
 protected:
  // Some random samples, some at the points of a grid so that many are equally far from each other, many at one place,
  // and one far away from all others.
  static Samples samples() {
    Samples all;
    std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): each run is the same
    std::uniform_real_distribution<float> place(0, 10);
    for (int i = 0; i < 2000; ++i) all.before.push_back({place(random), place(random), 0.1F * place(random)});
    for (int i = 0; i < 2500; ++i)
      all.before.push_back({20 + static_cast<float>(i % 50), static_cast<float>(i) / 50, 0});
    all.before.resize(all.before.size() + 300, {5, 5, 20});
    all.before.push_back({1e6F, 0, 0});
    std::shuffle(all.before.begin(), all.before.end(), random);
    all.after = all.normals = all.before;
    for (Vector3f& p : all.after) p.z += p.x * p.x;
    for (Vector3f& p : all.normals) p = common::unit(p);
    all.normals_after = all.normals;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all.values.insert(all.values.end(), {static_cast<float>(i), 2 * all.before[i].x});
      all.is_edited.insert(all.is_edited.end(), {static_cast<std::uint8_t>(i % 2), 1});
    }
    return all;
  }

  std::unique_ptr<SamplesInCells> on_disk(const Samples& all, std::size_t samples_a_cell, std::size_t memory) const {
    CellBox box{all.before[0], all.before[0]};
    for (const Vector3f& p : all.before) {
      box.low = common::least(box.low, p);
      box.high = common::greatest(box.high, p);
    }
    CellBuilder builder({samples_a_cell, 0, 1 << 19, 0}, box, 2, path(""));
    for (std::size_t i = 0; i < all.size(); ++i)
      builder.add({static_cast<std::uint32_t>(i), all.before[i], all.after[i], all.normals[i],
                   std::span(all.values).subspan(2 * i, 2), std::span(all.is_edited).subspan(2 * i, 2)});
    return std::make_unique<SamplesInCells>(builder.finish(), CellPlan{samples_a_cell, memory, 0, memory});
  }
};

void expect_same(const FoundSamples& a, const FoundSamples& b) {
  ASSERT_EQ(a.nearest.size(), b.nearest.size());
  for (std::size_t i = 0; i < a.nearest.size(); ++i) {
    EXPECT_EQ(a.nearest[i].index, b.nearest[i].index) << i;
    EXPECT_EQ(a.nearest[i].square, b.nearest[i].square) << i;
  }
  EXPECT_TRUE(a.samples.before == b.samples.before && a.samples.after == b.samples.after);
  EXPECT_TRUE(a.samples.normals == b.samples.normals && a.samples.normals_after == b.samples.normals_after);
  EXPECT_TRUE(a.samples.values == b.samples.values && a.samples.is_edited == b.samples.is_edited);
}

TEST_F(Cells, SearchesFindWhatTheyFindInMemory) {
  const SamplesInMemory memory(samples());
  const Samples all = samples();
  const auto cells = on_disk(all, 100, cell_bytes(300, 2));  // three cells in memory
  EXPECT_EQ(cells->size(), all.size());
  EXPECT_GE(cells->cells(), all.size() / 100);
  FoundSamples a, b;
  for (std::size_t i = 0; i < all.size(); i += 7)
    for (const std::size_t count : {1, 10, 48}) {
      const Vector3f place = all.before[i] + Vector3f{0.01F, 0, static_cast<float>(i % 3)};
      memory.gather(place, count, a);
      cells->gather(place, count, b);
      expect_same(a, b);
    }
  EXPECT_GT(cells->loads(), 2 * cells->cells());  // so cells went, and came again
}

TEST_F(Cells, SearchesFarAwayFindTheNearest) {
  const SamplesInMemory memory(samples());
  const auto cells = on_disk(samples(), 64, 1 << 20);
  FoundSamples a, b;
  for (const float far : {1e9F, -1e17F, 3e37F}) {
    memory.gather({far, 0, 0}, 5, a);
    cells->gather({far, 0, 0}, 5, b);
    expect_same(a, b);
  }
}

TEST_F(Cells, AllSamplesAreFoundIfFewerThanWanted) {
  Samples few = samples();
  for (std::vector<Vector3f>* vectors : {&few.before, &few.after, &few.normals, &few.normals_after}) vectors->resize(5);
  const auto cells = on_disk(few, 2, 1 << 20);
  FoundSamples found;
  cells->gather({0, 0, 0}, 48, found);
  EXPECT_EQ(found.nearest.size(), 5U);
}

TEST_F(Cells, EachSampleIsInOneCell) {
  const Samples all = samples();
  const auto cells = on_disk(all, 128, 1 << 16);
  std::vector<int> seen(all.size());
  cells->each([&](std::span<const std::uint32_t> indices, const Samples& samples) {
    EXPECT_LE(indices.size(), 128U);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      ++seen[indices[i]];
      EXPECT_EQ(samples.before[i], all.before[indices[i]]);
      EXPECT_EQ(samples.values[2 * i + 1], all.values[2 * indices[i] + 1]);
    }
  });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(all.size()));
}

// A cell with the far sample, or with samples of two parts, would be near every place.
TEST_F(Cells, CellsDoNotSpanGaps) {
  const auto cells = on_disk(samples(), 256, 1 << 20);
  cells->each([](std::span<const std::uint32_t>, const Samples& samples) {
    const auto [least, most] = std::minmax_element(samples.before.begin(), samples.before.end(),
                                                   [](const Vector3f& a, const Vector3f& b) { return a.x < b.x; });
    EXPECT_TRUE(most->x - least->x < 51 || samples.size() == 1) << least->x << " to " << most->x;
  });
}

TEST_F(Cells, TurnedNormalsAreRead) {
  const Samples all = samples();
  const auto cells = on_disk(all, 100, 1 << 20);
  FoundSamples found;
  cells->gather(all.before[0], 1, found);  // this cell is in memory before
  cells->set_turned_normals(common::Workers(2),
                            [](const LoadedCell& cell, FoundSamples&) { return cell.samples.after; });
  cells->gather(all.before[0], 4, found);
  EXPECT_TRUE(found.samples.normals_after == found.samples.after);
  EXPECT_FALSE(found.samples.normals == found.samples.after);
}

TEST(CellPlan, KeepsToTheMemoryOrSaysWhatItNeeds) {
  for (const std::size_t memory : {std::size_t{4} << 20, std::size_t{160} << 20}) {
    const CellPlan plan = plan_cells({memory, memory}, 2000000, 3, 2);
    EXPECT_LT(plan.cache + 8 * cell_bytes(plan.samples_a_cell, 3), memory);
    EXPECT_GT(plan.cache, memory / 4);
  }
  EXPECT_NE(problem_of([] {
              plan_cells({4 << 20, 4 << 20}, 2000000, 3, 256);
            }).find("use fewer threads"),
            std::string::npos);
}

class Sorting : public TemporaryFolder {};

TEST_F(Sorting, RecordsBeyondTheMemoryAreSorted) {
  SortedRecords sorted(4, 1 << 13, path(""));  // 64 records at a time
  std::mt19937 random(1);                      // NOLINT(cert-msc51-cpp): each run is the same
  for (int i = 0; i < 3000; ++i) {
    std::array<char, 4> record{};
    std::memcpy(record.data(), &i, sizeof i);
    sorted.add(random() % 500, record);
  }
  std::uint64_t last_key = 0;
  int last = -1, count = 0;
  sorted.each([&](std::uint64_t key, std::span<const char> record) {
    int i = 0;
    std::memcpy(&i, record.data(), sizeof i);
    EXPECT_TRUE(key > last_key || (key == last_key && i > last)) << "the order of equal keys stays";
    last_key = key;
    last = i;
    ++count;
  });
  EXPECT_EQ(count, 3000);
}

TEST_F(Sorting, TooLittleMemoryForTheRunsIsAnError) {
  SortedRecords sorted(1000, 2000, path(""));
  for (int i = 0; i < 200; ++i) sorted.add(1, std::vector<char>(1000));
  EXPECT_NE(problem_of([&] { sorted.each([](std::uint64_t, std::span<const char>) {}); }).find("memory is too small"),
            std::string::npos);
}

}  // namespace
}  // namespace glark::stream
