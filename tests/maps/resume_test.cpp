// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Bakes that are interrupted and continued.
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>

#include "glark/clients/common/resume/checkpoints.h"
#include "tests/common/temporary_folder.h"
#include "tests/maps/bumpy_sphere.h"

namespace glark::maps::test {
namespace {

struct Interrupted {};

// Counts the points that a bake reads.
class CountingReader final : public stream::PointReader {
 public:
  CountingReader(std::unique_ptr<stream::PointReader> reader, std::uint64_t& read, bool can_seek)
      : reader_(std::move(reader)), read_(read), can_seek_(can_seek) {}
  const std::string& name() const override { return reader_->name(); }
  const stream::Schema& schema() const override { return reader_->schema(); }
  std::optional<std::uint64_t> count() const override { return reader_->count(); }
  stream::Points read(std::size_t most) override {
    const stream::Points points = reader_->read(most);
    read_ += points.size();
    return points;
  }
  bool can_seek() const override { return can_seek_; }
  void seek(std::uint64_t point) override { reader_->seek(point); }

 private:
  std::unique_ptr<stream::PointReader> reader_;
  std::uint64_t& read_;
  bool can_seek_;
};

class ResumedBake : public glark::test::TemporaryFolder {
 protected:
  static constexpr double spacing = 0.0031;  // more than two checkpoints

  Baked bake_bumps(const BakeOptions& options) {
    stream::Source source = mesh_source(fine_.fine(), spacing);
    source.open = [this, open = source.open](const stream::ReadOptions& reading) {
      return std::make_unique<CountingReader>(open(reading), read_, can_seek_);
    };
    return bake(coarse_.coarse(), source, options);
  }
  BakeOptions options() const { return {.width = 256, .height = 256, .work = path("work")}; }
  // Ends when `fraction` of the work is done.
  void interrupt(double fraction, BakeOptions options) {
    options.progress = [fraction](double done) {
      if (done >= fraction) throw Interrupted();
    };
    EXPECT_THROW(bake_bumps(options), Interrupted);
  }
  static void expect_same(const Baked& a, const Baked& b) {
    EXPECT_EQ(a.normal_map, b.normal_map);
    EXPECT_EQ(a.colour_map, b.colour_map);
    EXPECT_EQ(a.displacement_map, b.displacement_map);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.left_out, b.left_out);
    EXPECT_EQ(a.texels, b.texels);
    EXPECT_EQ(a.filled, b.filled);
    EXPECT_EQ(a.empty_charts, b.empty_charts);
    EXPECT_EQ(a.reach, b.reach);
  }
  // Returns the message of the Error, or an empty text.
  std::string problem_of(const BakeOptions& options) {
    try {
      bake_bumps(options);
    } catch (const Error& error) {
      EXPECT_EQ(error.element(), Element::file);
      return error.what();
    }
    return {};
  }

  Sphere fine_ = sphere_of(6, true), coarse_ = sphere_of(2, false);
  std::uint64_t read_ = 0;
  bool can_seek_ = true;
};

TEST_F(ResumedBake, HasTheSameMapsAndRepeatsLittle) {
  const Baked wanted = bake_bumps({.width = 256, .height = 256});
  ASSERT_GT(wanted.points, 2 * common::Checkpoints::least_step);
  for (const double fraction : {0.05, 0.5, 0.74, 0.9}) {
    SCOPED_TRACE(fraction);
    interrupt(fraction, options());
    BakeOptions rest = options();
    rest.resume = true;
    rest.threads = fraction < 0.7 ? 1 : 0;
    read_ = 0;
    expect_same(wanted, bake_bumps(rest));
    const double done = std::clamp((fraction - 0.1) / 0.65, 0.0, 1.0);  // of the pass over the points
    const double left = (1 - done) * static_cast<double>(wanted.points);
    EXPECT_LE(static_cast<double>(read_), left + 1.2 * common::Checkpoints::least_step + (done > 0 ? 0 : 300000));
    std::filesystem::remove_all(path("work"));
  }
}

TEST_F(ResumedBake, ContinuesWhenTheModelWasNotWritten) {
  const Baked wanted = bake_bumps(options());
  BakeOptions again = options();
  again.resume = true;
  read_ = 0;
  expect_same(wanted, bake_bumps(again));
  EXPECT_EQ(read_, 0U);
}

TEST_F(ResumedBake, ReadsOnIfTheSourceCannotSeek) {
  const Baked wanted = bake_bumps({.width = 256, .height = 256});
  can_seek_ = false;
  interrupt(0.6, options());
  BakeOptions rest = options();
  rest.resume = true;
  const Baked model = bake_bumps(rest);
  EXPECT_EQ(model.points, wanted.points);
  EXPECT_EQ(read_ > wanted.points, true);
}

TEST_F(ResumedBake, RefusesOtherWork) {
  interrupt(0.6, options());
  BakeOptions other = options();
  other.resume = true;
  other.texels_per_point = 3;
  EXPECT_NE(problem_of(other).find("it has \"texels_per_point 2\", and this run \"texels_per_point 3\""),
            std::string::npos);
  other = options();
  other.resume = true;
  coarse_ = sphere_of(3, false);
  EXPECT_NE(problem_of(other).find("coarse mesh"), std::string::npos);
  coarse_ = sphere_of(2, false);
  fine_.colours[5] ^= 1;
  EXPECT_NE(problem_of(other).find("source mesh"), std::string::npos);
  EXPECT_NE(problem_of(other).find("start without resume"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("work/glark-points")));
}

TEST_F(ResumedBake, NeedsAFolder) { EXPECT_THROW(bake_bumps({.resume = true}), Error); }

// A damaged state is not used: the result is the same, or there is an error.
TEST_F(ResumedBake, DamageDoesNotChangeTheMaps) {
  interrupt(0.8, options());  // has all states but the filled maps
  interrupt(0.9, [&] {
    BakeOptions more = options();
    more.resume = true;
    return more;
  }());
  const Baked wanted = bake_bumps({.width = 256, .height = 256});
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path("work"))) names.push_back(entry.path().filename());
  // A busy machine may save the filled maps later, so they are not asked for.
  for (const char* const name : {"glark-identity", "glark-census", "glark-points", "glark-maps"})
    EXPECT_TRUE(std::filesystem::exists(path("work") / name)) << name;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const std::filesystem::path copy = path("copy");
    std::filesystem::remove_all(copy);
    std::filesystem::copy(path("work"), copy);
    std::fstream file(copy / name, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(copy / name) / 2));
    file.write("damaged!", 8);
    file.close();
    BakeOptions rest = options();
    rest.work = copy;
    rest.resume = true;
    if (name == "glark-identity")
      EXPECT_NE(problem_of(rest).find("has files that are not of this work"), std::string::npos);
    else
      expect_same(wanted, bake_bumps(rest));
  }
}

}  // namespace
}  // namespace glark::maps::test
