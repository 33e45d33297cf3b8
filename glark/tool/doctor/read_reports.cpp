// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/doctor/read_reports.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

namespace glark::tool {
namespace {

using nlohmann::json;

bool more_draws(const Count& a, const Count& b) { return a.second > b.second; }

std::vector<Count> counts_of(const json& object) {
  std::vector<Count> counts;
  for (const auto& [key, value] : object.items()) counts.emplace_back(key, value.get<std::uint64_t>());
  std::stable_sort(counts.begin(), counts.end(), more_draws);
  return counts;
}

std::vector<Count> refinements_of(const json& classes) {
  std::map<std::string, std::uint64_t> draws;
  for (const json& entry : classes)
    if (entry.contains("refinement"))
      draws[entry["refinement"].get<std::string>()] += entry["draws"].get<std::uint64_t>();
  std::vector<Count> counts(draws.begin(), draws.end());
  std::stable_sort(counts.begin(), counts.end(), more_draws);
  return counts;
}

ProcessReport report_of(const json& file) {
  ProcessReport report;
  const json& draws = file.at("draws");
  report.number = file.at("process").get<int>();
  report.frames = file.at("frames").get<std::uint64_t>();
  report.seen = draws.at("seen").get<std::uint64_t>();
  report.refined = draws.at("refined").get<std::uint64_t>();
  report.coarse_triangles = file.at("coarse_triangles").get<std::uint64_t>();
  report.refined_triangles = file.at("refined_triangles").get<std::uint64_t>();
  report.left = counts_of(draws.at("passed_through"));
  report.fallbacks = counts_of(draws.at("fallbacks"));
  report.refinements = refinements_of(file.at("classes"));
  for (const json& context : file.at("contexts"))
    report.contexts.push_back({context.at("version").get<std::string>(), context.at("refinable").get<bool>()});
  for (const auto& [hash, shader] : file.at("shaders").items())
    if (shader.contains("problem")) report.problems.push_back(hash + ": " + shader["problem"].get<std::string>());
  report.name = file.at("program").get<std::string>();
  return report;
}

}  // namespace

ProcessReport read_report(std::string_view text) {
  try {
    return report_of(json::parse(text));
  } catch (const json::exception&) {
    return {};
  }
}

std::vector<ProcessReport> read_reports(const std::string& folder) {
  std::vector<ProcessReport> reports;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream in(entry.path());
    ProcessReport report = read_report(std::string(std::istreambuf_iterator<char>(in), {}));
    if (!report.name.empty()) reports.push_back(std::move(report));
  }
  std::stable_sort(reports.begin(), reports.end(),
                   [](const ProcessReport& a, const ProcessReport& b) { return a.seen > b.seen; });
  return reports;
}

}  // namespace glark::tool
