// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sessions on disk: replays, damage, folders of others, refinement and saving.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/edit/scan_folder.h"

namespace glark::edit {
namespace {

using Sessions = ScanFolder;

const char* const lines[] = {"paint 0 0 1 0.5 255 0 0",
                             "inflate 0 0 1 0.5 0.1",
                             "undo",
                             "symmetric on x",
                             "move 1 0 0 0.5 0.2 0 0",
                             "undo",
                             "redo",
                             "refine 0 0 1 0.4 300",
                             "smooth 0 0 1 0.4",
                             "deform 0 0 1 0.3 0 0 1 0.8 0 0 0.2"};

TEST_F(Sessions, AReplayIsTheLiveState) {
  std::string live;
  std::size_t samples = 0;
  {
    Session session = open();
    samples = session.editor().size();
    for (const char* line : lines) apply(session, line);
    EXPECT_GT(session.editor().size(), samples + 200);
    live = bytes_of(session.editor());
    EXPECT_EQ(session.replayed(), 0U);
  }
  Session again = open();
  EXPECT_EQ(again.replayed(), std::size(lines));
  EXPECT_EQ(again.operations(), std::size(lines));
  EXPECT_FALSE(again.has_dropped_line());
  EXPECT_TRUE(bytes_of(again.editor()) == live);
  EXPECT_TRUE(again.editor().symmetric().on);
  for (std::size_t k = again.editor().undo_count(); k > 0; --k) apply(again, "undo");
  EXPECT_EQ(again.editor().size(), samples);
  EXPECT_TRUE(std::equal(again.editor().positions().begin(), again.editor().positions().end(),
                         again.editor().positions_before().begin()));
}

// The positions of the new samples, in an order of their own.
std::vector<std::array<double, 3>> added(const Editor& editor, std::size_t from) {
  std::vector<std::array<double, 3>> places;
  for (std::size_t i = 3 * from; i < editor.positions().size(); i += 3)
    places.push_back({editor.positions()[i], editor.positions()[i + 1], editor.positions()[i + 2]});
  std::sort(places.begin(), places.end());
  return places;
}

TEST_F(Sessions, RefinementsAreMirrored) {
  Session session = open();
  const std::size_t samples = session.editor().size();
  apply(session, "symmetric on x");
  apply(session, "refine 1 0 0 0.3 200");
  const std::vector<std::array<double, 3>> both = added(session.editor(), samples);
  const auto on_the_right = std::count_if(both.begin(), both.end(), [](const auto& p) { return p[0] > 0; });
  EXPECT_GT(on_the_right, 100);
  EXPECT_GT(static_cast<std::ptrdiff_t>(both.size()) - on_the_right, 100);

  // A ball that the mirror does not move brings its samples once.
  apply(session, "undo");
  apply(session, "refine 0 1 0 0.3 200");
  const std::vector<std::array<double, 3>> once = added(session.editor(), samples);
  EXPECT_LE(once.size(), 200U);
  EXPECT_TRUE(std::adjacent_find(once.begin(), once.end()) == once.end());

  // Beside the scan, the mirrored ball brings nothing.
  apply(session, "undo");
  apply(session, "symmetric on x 5");
  apply(session, "refine 1 0 0 0.3 200");
  EXPECT_GT(session.editor().size(), samples + 100);
  EXPECT_LE(session.editor().size(), samples + 200);
}

// The greatest angle between a stored normal and the direction from the middle of the sphere, in degrees.
double greatest_tilt(const std::filesystem::path& file) {
  const std::unique_ptr<stream::PointReader> reader = stream::open_points(file);
  double greatest = 0;
  for (stream::Points points = reader->read(); points.size() > 0; points = reader->read())
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d place = common::vector_at(points.positions, i);
      const common::Vector3f stored = common::vector_at(points.normals, i);
      const Vector3d normal{stored.x, stored.y, stored.z};
      const double cosine = common::dot(place, normal) / common::length(place) / common::length(normal);
      greatest = std::max(greatest, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.14159265358979);
    }
  return greatest;
}

// A twist about its axis leaves a sphere a sphere. Its parts end at a kink, where triangles of samples turn over.
TEST_F(Sessions, NormalsFollowATwist) {
  Session session = open();
  apply(session, "twist 0 0 -0.3 0 0 0.3 90");
  session.save(path("twisted.ply"));
  EXPECT_LT(greatest_tilt(path("twisted.ply")), 45);
  apply(session, "refine 0 0 0 2 8000");
  session.save(path("refined.ply"));
  EXPECT_LT(greatest_tilt(path("refined.ply")), 45);
}

// The greatest angle between the normals of two files, in degrees.
double greatest_turn(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::unique_ptr<stream::PointReader> first = stream::open_points(from), second = stream::open_points(to);
  const stream::Points a = first->read(), b = second->read();
  double least = 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const common::Vector3f m = common::vector_at(a.normals, i), n = common::vector_at(b.normals, i);
    least = std::min<double>(least, common::dot(m, n) / common::length(m) / common::length(n));
  }
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180 / 3.14159265358979;
}

TEST_F(Sessions, NormalsAreKeptByARefinement) {
  Session session = open();
  apply(session, "inflate 0 0 1 0.5 0.1");
  session.save(path("inflated.ply"));
  apply(session, "refine 0 0 1.1 0.4 5000");
  session.save(path("refined.ply"));
  EXPECT_LT(greatest_turn(path("inflated.ply"), path("refined.ply")), 10);
}

TEST_F(Sessions, APointIsNotSampledTwice) {
  Session session(scan(), folder(), {.target = scan_points, .threads = 1});
  EXPECT_NE(problem_of([&] { apply(session, "refine 0 0 1 0.4 300"); }).find("are samples already"), std::string::npos);
}

TEST_F(Sessions, ATornLineIsDropped) {
  std::string two;
  {
    Session session = open();
    apply(session, lines[0]);
    apply(session, lines[1]);
    two = bytes_of(session.editor());
    apply(session, "twist 0 0 -1 0 0 1 30");
  }
  const std::string whole = contents(folder() / "log");
  const std::size_t begin = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t size = whole.size() - 1; size > begin; size -= 5) {
    std::filesystem::resize_file(folder() / "log", size);
    const Session session = open();
    EXPECT_TRUE(session.has_dropped_line());
    EXPECT_EQ(session.operations(), 2U);
    EXPECT_TRUE(bytes_of(session.editor()) == two);
    EXPECT_EQ(std::filesystem::file_size(folder() / "log"), begin);
    made("scan.edit/log", whole);
  }
  EXPECT_EQ(open().operations(), 3U);
  for (std::size_t size : {0, 5}) {  // the title itself
    std::filesystem::resize_file(folder() / "log", size);
    EXPECT_EQ(open().operations(), 0U);
    made("scan.edit/log", whole);
  }
}

TEST_F(Sessions, DamageInTheMiddleIsAnError) {
  {
    Session session = open();
    for (int k = 0; k < 4; ++k) apply(session, lines[k]);
  }
  const std::string whole = contents(folder() / "log");
  std::string changed = whole;
  changed.replace(changed.find("255"), 3, "254");
  std::string shorter = whole;  // the second operation is left out
  const std::size_t second = shorter.find('\n', shorter.find("paint")) + 1;
  shorter.erase(second, shorter.find('\n', second) + 1 - second);
  const std::pair<std::string, const char*> damaged[] = {{changed, "/log: line 2 is damaged"},
                                                         {shorter, "/log: line 3 is damaged"},
                                                         {"other\n" + whole, "/log: line 1 is not"}};
  for (const auto& [text, message] : damaged) {
    made("scan.edit/log", text);
    EXPECT_NE(problem_of([&] { open(); }).find(message), std::string::npos) << problem_of([&] { open(); });
    EXPECT_EQ(contents(folder() / "log"), text);
  }
}

TEST_F(Sessions, FoldersOfOthersStay) {
  std::filesystem::create_directories(folder());
  made("scan.edit/thesis.txt", "mine");
  EXPECT_NE(problem_of([&] { open(); }).find("no session of glark edit"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder()), {}), 1);
  std::filesystem::remove(folder() / "thesis.txt");
  open();  // an empty folder will do
  made("scan.edit/thesis.txt", "mine");
  open();
  EXPECT_EQ(contents(folder() / "thesis.txt"), "mine");
  made("scan.edit/session", "my session\n");
  EXPECT_NE(problem_of([&] { open(); }).find("is no file of glark edit"), std::string::npos);
  std::filesystem::resize_file(folder() / "session", 0);  // killed before it was written
  open();
  std::filesystem::remove_all(folder());
  made("scan.edit", "a file");
  EXPECT_NE(problem_of([&] { open(); }).find("no session of glark edit"), std::string::npos);
  EXPECT_EQ(contents(folder()), "a file");
}

TEST_F(Sessions, OnlyOneAtATime) {
  const Session session = open();
  EXPECT_NE(problem_of([&] { open(); }).find("is used by another"), std::string::npos);
}

TEST_F(Sessions, AChangedScanIsAnError) {
  open();
  std::ofstream(scan(), std::ios::app) << "x";
  EXPECT_NE(problem_of([&] { open(); }).find("has changed since"), std::string::npos);
}

TEST_F(Sessions, AScanThatChangesMeanwhileIsAnError) {
  Session session = open();
  apply(session, lines[1]);
  std::ofstream(scan(), std::ios::app) << "x";
  EXPECT_NE(problem_of([&] { session.save(path("out.ply")); }).find("has changed since"), std::string::npos);
  EXPECT_NE(problem_of([&] { apply(session, lines[7]); }).find("has changed since"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
  EXPECT_EQ(session.operations(), 1U);
}

TEST_F(Sessions, AScanThatWasRepairedBeforeItsSamplingIsTaken) {
  const std::string good = contents(scan());
  std::string bad = good;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bad.replace(bad.find("end_header\n") + 11, sizeof(nan), reinterpret_cast<const char*>(&nan), sizeof(nan));
  made("scan.ply", bad);
  EXPECT_THROW(open(), stream::Error);
  made("scan.ply", good);
  EXPECT_EQ(open().operations(), 0U);
}

TEST_F(Sessions, NothingIsSavedIntoTheSession) {
  Session session = open();
  apply(session, lines[1]);
  const std::string sampling = contents(folder() / "sample.ply");
  std::filesystem::create_symlink(folder(), path("link"));
  for (const auto& output : {folder() / "sample.ply", folder() / "new.ply", path("link/sample.ply")})
    EXPECT_NE(problem_of([&] { session.save(output); }).find("folder of the session"), std::string::npos);
  EXPECT_TRUE(contents(folder() / "sample.ply") == sampling);
}

TEST_F(Sessions, ScansOfTextAreRejectedAtOnce) {
  made("scan.xyz", "0 0 0\n1 1 1\n");
  EXPECT_NE(problem_of([&] { Session(path("scan.xyz"), folder()); }).find("convert it"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder()));
  EXPECT_NE(problem_of([&] { Session(path("none.ply"), folder()); }), "");
  EXPECT_NE(problem_of([&] { Session(scan(), folder(), {.target = 0}); }).find("target is 0"), std::string::npos);
}

TEST_F(Sessions, AFailedOperationIsNotInTheLog) {
  Session session = open();
  apply(session, lines[0]);
  const std::string before = bytes_of(session.editor());
  EXPECT_NE(problem_of([&] { apply(session, "inflate 9 9 9 1 1"); }), "");
  EXPECT_NE(problem_of([&] { apply(session, "redo"); }), "");
  EXPECT_EQ(session.operations(), 1U);
  EXPECT_TRUE(bytes_of(session.editor()) == before);
}

TEST_F(Sessions, OnlyWhatTheScanCanHoldIsPainted) {
  const std::vector<float> points(300, 1);
  made("scan.raw", {reinterpret_cast<const char*>(points.data()), points.size() * sizeof(float)});
  Session session(path("scan.raw"), path("raw.edit"));
  EXPECT_NE(problem_of([&] { apply(session, "paint 1 1 1 1 0 0 0"); }).find("cannot hold colours"), std::string::npos);
  EXPECT_EQ(session.operations(), 0U);
}

TEST_F(Sessions, SavingTransfersTheEdit) {
  Session session = open();
  EXPECT_FALSE(session.save(path("same.ply")).is_deformed);
  EXPECT_TRUE(contents(path("same.ply")) == contents(scan()));
  apply(session, "twist 0 0 -1 0 0 1 90");
  const SaveReport report = session.save(path("out.ply"));
  EXPECT_EQ(report.points, scan_points);
  EXPECT_TRUE(report.is_deformed);
  EXPECT_FALSE(report.is_painted);
  const auto before = stream::open_points(scan()), after = stream::open_points(path("out.ply"));
  const stream::Points from = before->read(scan_points), to = after->read(scan_points);
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vector3d p = position(from.positions, i);
    const double turn = (p.z + 1) * std::numbers::pi / 4;
    const Vector3d wanted{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
                          p.z};
    sum += common::squared_distance(wanted, position(to.positions, i));
  }
  EXPECT_LT(std::sqrt(sum / scan_points), 2e-3);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), {}), 4);  // nothing else is left behind
  EXPECT_NE(problem_of([&] { session.save(scan()); }).find("the scan itself"), std::string::npos);
}

}  // namespace
}  // namespace glark::edit
