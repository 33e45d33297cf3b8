// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/submission/submission.h"

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "conformance/report/report.h"
#include "conformance/submission/archive.h"

namespace glark::conformance {
namespace {

constexpr char sums_name[] = "SHA256SUMS";
constexpr char version_name[] = "VERSION";

std::string version_text() { return fmt::format("glark-conformance must-pass {}\n", must_pass_version); }

// The format of sha256sum, which can also check it.
std::string sums_of(const Files& files) {
  std::string text;
  for (const auto& [name, bytes] : files) text += sha256(bytes) + "  " + name + '\n';
  return text;
}

void check_sums(const Files& files, std::vector<std::string>& complaints) {
  const auto sums = files.find(sums_name);
  if (sums == files.end()) {
    complaints.emplace_back("there is no SHA256SUMS");
    return;
  }
  std::set<std::string> summed;
  std::istringstream lines(sums->second);
  for (std::string sum, name; lines >> sum && std::getline(lines >> std::ws, name);) {
    summed.insert(name);
    const auto file = files.find(name);
    if (file == files.end()) {
      complaints.push_back(name + " is missing");
    } else if (sha256(file->second) != sum) {
      complaints.push_back(name + " is not what was packaged: its SHA-256 differs");
    }
  }
  for (const auto& [name, bytes] : files)
    if (name != sums_name && summed.count(name) == 0) complaints.push_back(name + " is not in SHA256SUMS");
}

bool is_good(Verdict verdict) { return verdict == Verdict::pass || verdict == Verdict::quality_warning; }

// A baseline, or a retry, turns what was seen into another verdict in these ways only.
bool agree(const Record& record) {
  switch (record.verdict) {
    case Verdict::expected_fail:
    case Verdict::flake: return is_bad(record.seen);
    case Verdict::unexpected_pass: return is_good(record.seen);
    default: return record.verdict == record.seen;
  }
}

std::optional<Api> api_of(const Environment& environment) {
  const auto found = environment.find("api");
  for (const Api api : {Api::gl_compat, Api::gl_core, Api::gles})
    if (found != environment.end() && found->second == name_of(api)) return api;
  return std::nullopt;
}

void check_verdict(const RequiredCase& required, Verdict seen, std::optional<Api> api,
                   std::vector<std::string>& complaints) {
  if (seen == Verdict::not_supported) {
    if (api && required.apis.contains(*api)) complaints.push_back(required.name + " has to be supported");
  } else if (!is_good(seen)) {
    complaints.push_back(required.name + " did not pass: " + std::string(name_of(seen)));
  }
}

void check_results(const Report& report, std::vector<std::string>& complaints) {
  std::map<std::string, Verdict> verdicts;
  for (const Record& record : report.records) {
    if (!verdicts.emplace(record.name, record.seen).second) complaints.push_back(record.name + " is there twice");
    if (!agree(record))
      complaints.push_back(
          fmt::format("{} is {}, but what was seen is {}", record.name, name_of(record.verdict), name_of(record.seen)));
  }
  const std::optional<Api> api = api_of(report.environment);
  if (!api) complaints.emplace_back("the results do not name their API");
  for (const RequiredCase& required : must_pass()) {
    const auto found = verdicts.find(required.name);
    if (found == verdicts.end()) {
      complaints.push_back(required.name + " is missing");
    } else {
      check_verdict(required, found->second, api, complaints);
    }
  }
  const auto extension = report.environment.find("GL_ARK_adaptive_refinement");
  if (extension == report.environment.end() || extension->second != "yes")
    complaints.emplace_back("the implementation has no GL_ARK_adaptive_refinement");
}

// The list as constants: an initializer of thousands of strings compiles for a minute.
struct ListedCase {
  const char* name;
  Apis apis;
};
constexpr ListedCase listed_cases[] = {
#include "conformance/must_pass.inc"
};

}  // namespace

const std::vector<RequiredCase>& must_pass() {
  static const std::vector<RequiredCase> cases = [] {
    std::vector<RequiredCase> all;
    for (const ListedCase& listed : listed_cases) all.push_back({listed.name, listed.apis});
    return all;
  }();
  return cases;
}

void package(const std::string& directory, const std::string& archive) {
  Files files;
  const Report report = read_report(directory + "/results.json");
  for (const char* name : {"results.json", "junit.xml", "log.txt", "index.html"})
    files[name] = read_file(directory + '/' + name);
  for (const Record& record : report.records)
    for (const std::string& image : record.images) {
      check_inside(image);
      files[image] = read_file(directory + '/' + image);
    }
  files[version_name] = version_text();
  files[sums_name] = sums_of(files);
  write_archive(files, archive);
}

std::vector<std::string> verify(const std::string& archive) {
  const Files files = read_archive(archive);
  std::vector<std::string> complaints;
  check_sums(files, complaints);
  const auto version = files.find(version_name);
  if (version == files.end()) {
    complaints.emplace_back("there is no VERSION");
  } else if (version->second != version_text()) {
    complaints.push_back("made for another list of cases: " + version->second.substr(0, version->second.find('\n')));
  }
  const auto results = files.find("results.json");
  if (results == files.end()) {
    complaints.emplace_back("there are no results");
  } else {
    check_results(parse_report(results->second, archive + ": results.json"), complaints);
  }
  return complaints;
}

}  // namespace glark::conformance
