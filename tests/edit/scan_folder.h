// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A folder with a scan, for the tests of sessions.
#pragma once

#include <glark/stream.h>

#include "tests/common/temporary_folder.h"
#include "tests/edit/samplings.h"

namespace glark::edit {

class ScanFolder : public test::TemporaryFolder {
 protected:
  static constexpr std::size_t scan_points = 20000;

  void SetUp() override {
    TemporaryFolder::SetUp();
    const Sampling all = sphere(scan_points / 2);
    const std::vector<double> greys(all.positions.size(), 128);
    const stream::Schema schema{
        stream::Number::float32,
        true,
        {{"red", stream::Number::uint8}, {"green", stream::Number::uint8}, {"blue", stream::Number::uint8}}};
    const auto writer = stream::create_points(scan(), schema, scan_points);
    writer->write({0, all.positions, all.normals, greys});
    writer->finish();
  }

  std::filesystem::path scan() const { return path("scan.ply"); }
  std::filesystem::path folder() const { return path("scan.edit"); }
  // One thread, so that a test may fork.
  Session open() const { return Session(scan(), folder(), {.target = 1000, .threads = 1}); }
  static void apply(Session& session, std::string_view line) { session.apply(parse(line)); }

  static std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

}  // namespace glark::edit
