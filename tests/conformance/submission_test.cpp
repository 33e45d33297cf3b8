// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/submission/submission.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "conformance/report/report.h"
#include "conformance/submission/archive.h"

namespace glark::conformance {
namespace {

class Submission : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("glark_submission_" + std::to_string(getpid()));
    prepare_report(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const char* name) const { return folder_ / name; }

  // A report in which every case of the list has this verdict.
  void write_results(Verdict verdict) const {
    Report report;
    report.environment["GL_ARK_adaptive_refinement"] = "yes";
    report.environment["api"] = "gl-core";
    for (const RequiredCase& required : must_pass()) {
      Record record;
      record.name = required.name;
      record.verdict = record.seen = verdict;
      report.records.push_back(record);
    }
    write_report(report, folder_);
  }

  std::filesystem::path folder_;
};

TEST_F(Submission, PassesStand) {
  write_results(Verdict::pass);
  package(folder_, path("a.tar.gz"));
  EXPECT_EQ(verify(path("a.tar.gz")), std::vector<std::string>{});
}

TEST_F(Submission, FailureBehindABaselineDoesNot) {
  write_results(Verdict::pass);
  Report report = read_report(path("results.json"));
  report.records.front().verdict = Verdict::expected_fail;
  report.records.front().seen = Verdict::fail;
  write_report(report, folder_);
  package(folder_, path("a.tar.gz"));
  EXPECT_EQ(verify(path("a.tar.gz")), std::vector<std::string>{must_pass().front().name + " did not pass: Fail"});
}

TEST_F(Submission, NothingSupportedDoesNot) {
  write_results(Verdict::not_supported);
  package(folder_, path("a.tar.gz"));
  std::vector<std::string> complaints;
  for (const RequiredCase& required : must_pass())
    if (required.apis.contains(Api::gl_core)) complaints.push_back(required.name + " has to be supported");
  EXPECT_GT(complaints.size(), 1000U);
  EXPECT_LT(complaints.size(), must_pass().size() - 300);  // cases of other APIs, and optional ones
  EXPECT_EQ(verify(path("a.tar.gz")), complaints);
}

TEST_F(Submission, VerdictsAgreeWithWhatWasSeen) {
  write_results(Verdict::pass);
  Report report = read_report(path("results.json"));
  report.records[0].verdict = Verdict::fail;
  report.records[1].verdict = Verdict::expected_fail;
  report.records[2].verdict = Verdict::unexpected_pass;  // a baseline expects its failure
  write_report(report, folder_);
  package(folder_, path("a.tar.gz"));
  EXPECT_EQ(verify(path("a.tar.gz")),
            (std::vector<std::string>{must_pass()[0].name + " is Fail, but what was seen is Pass",
                                      must_pass()[1].name + " is ExpectedFail, but what was seen is Pass"}));
}

TEST_F(Submission, ResultsNameTheirApi) {
  write_results(Verdict::pass);
  Report report = read_report(path("results.json"));
  report.environment["api"] = "vulkan";
  write_report(report, folder_);
  package(folder_, path("a.tar.gz"));
  EXPECT_EQ(verify(path("a.tar.gz")), std::vector<std::string>{"the results do not name their API"});
}

TEST_F(Submission, CountsAreThoseOfTheResults) {
  write_results(Verdict::pass);
  std::string text = read_file(path("results.json"));
  const std::string count = "\"Pass\": " + std::to_string(must_pass().size());
  ASSERT_NE(text.find(count), std::string::npos);
  text.replace(text.find(count), count.size(), count + "0");
  write_file(path("results.json"), text);
  EXPECT_THROW(package(folder_, path("a.tar.gz")), std::runtime_error);
}

TEST_F(Submission, NothingOutsideTheFolder) {
  write_results(Verdict::pass);
  Report report = read_report(path("results.json"));
  for (const char* image : {"../secret.png", "/etc/passwd", "images/../../secret.png", ""}) {
    report.records[0].images = {image};
    write_report(report, folder_);
    EXPECT_THROW(package(folder_, path("a.tar.gz")), std::runtime_error) << image;
  }
  for (const char* name : {"../stranger", "/stranger", "images/../../stranger"}) {
    write_archive({{name, "text"}}, path("b.tar.gz"));
    EXPECT_THROW(verify(path("b.tar.gz")), std::runtime_error) << name;
  }
}

TEST_F(Submission, ChangedFileIsFound) {
  write_results(Verdict::pass);
  package(folder_, path("a.tar.gz"));
  Files files = read_archive(path("a.tar.gz"));
  files["log.txt"] += "one more line\n";
  files["stranger"] = "";
  write_archive(files, path("b.tar.gz"));
  EXPECT_EQ(verify(path("b.tar.gz")), (std::vector<std::string>{"log.txt is not what was packaged: its SHA-256 differs",
                                                                "stranger is not in SHA256SUMS"}));
}

TEST_F(Submission, SameReportSameBytes) {
  write_results(Verdict::pass);
  package(folder_, path("a.tar.gz"));
  package(folder_, path("b.tar.gz"));
  EXPECT_EQ(read_file(path("a.tar.gz")), read_file(path("b.tar.gz")));
}

TEST_F(Submission, UnwritableArchiveIsAnError) {
  write_results(Verdict::pass);
  EXPECT_THROW(package(folder_, path("none/a.tar.gz")), std::runtime_error);
}

TEST_F(Submission, TruncatedArchiveIsAnError) {
  write_results(Verdict::pass);
  package(folder_, path("a.tar.gz"));
  write_file(path("b.tar.gz"), read_file(path("a.tar.gz")).substr(0, 300));
  EXPECT_THROW(verify(path("b.tar.gz")), std::runtime_error);
}

TEST(Sha256, OfTheStandard) {  // FIPS 180-2, appendix B.1
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace glark::conformance
