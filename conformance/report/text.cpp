// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// log.txt, results.json and junit.xml.
#include <fmt/core.h>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "conformance/report/report.h"
#include "conformance/suite/case.h"

namespace glark::conformance {
namespace {

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", seconds);
  return text;
}

nlohmann::json as_json(const Record& record) {
  return {{"name", record.name},       {"verdict", name_of(record.verdict)}, {"seen", name_of(record.seen)},
          {"seconds", record.seconds}, {"messages", record.messages},        {"images", record.images},
          {"output", record.output},   {"commands", record.commands}};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

nlohmann::json counts_of(const std::vector<Record>& records) {
  nlohmann::json counts = nlohmann::json::object();
  for (const auto& [verdict, count] : count_verdicts(records)) counts[std::string(name_of(verdict))] = count;
  return counts;
}

// JUnit has only four outcomes.
std::string junit_body(const Record& record) {
  const std::string verdict(name_of(record.verdict));
  const std::string detail = escaped(joined(record.messages));
  const char* element = nullptr;
  switch (record.verdict) {
    case Verdict::pass:
    case Verdict::quality_warning: return "";
    case Verdict::not_supported:
    case Verdict::unimplemented:
    case Verdict::expected_fail:
    case Verdict::flake: element = "skipped"; break;
    case Verdict::fail:
    case Verdict::unexpected_pass: element = "failure"; break;
    default: element = "error"; break;
  }
  return std::string("      <") + element + " message=\"" + verdict + "\">" + detail + "</" + element + ">\n";
}

}  // namespace

std::string as_json(const Report& report) {
  nlohmann::json records = nlohmann::json::array();
  for (const Record& record : report.records) records.push_back(as_json(record));
  const nlohmann::json all = {{"format", "glark-conformance results 1"},
                              {"environment", report.environment},
                              {"command", report.command},
                              {"seconds", report.seconds},
                              {"counts", counts_of(report.records)},
                              {"results", records}};
  return all.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + '\n';
}

Report read_report(const std::string& path) { return parse_report(read_file(path), path); }

Report parse_report(const std::string& text, const std::string& name) {
  const auto all = nlohmann::json::parse(text, nullptr, false);
  if (all.is_discarded()) throw std::runtime_error(name + " is not JSON");
  try {
    if (all.at("format") != "glark-conformance results 1") throw std::runtime_error(name + " has another format");
    Report report;
    report.environment = all.at("environment").get<Environment>();
    report.command = all.at("command").get<std::vector<std::string>>();
    report.seconds = all.at("seconds").get<double>();
    for (const auto& each : all.at("results")) {
      Record record;
      record.name = each.at("name").get<std::string>();
      const auto verdict = verdict_of(each.at("verdict").get<std::string>());
      const auto seen = verdict_of(each.at("seen").get<std::string>());
      if (!verdict || !seen) throw std::runtime_error(name + ": " + record.name + " has an unknown verdict");
      record.verdict = *verdict;
      record.seen = *seen;
      record.images = each.at("images").get<std::vector<std::string>>();
      record.messages = each.at("messages").get<std::vector<std::string>>();
      report.records.push_back(std::move(record));
    }
    if (all.at("counts") != counts_of(report.records)) throw std::runtime_error(name + ": its counts are wrong");
    return report;
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

std::string as_junit(const Report& report) {
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  for (const Record& record : report.records) {
    const std::string body = junit_body(record);
    failures += body.find("<failure") != std::string::npos ? 1 : 0;
    errors += body.find("<error") != std::string::npos ? 1 : 0;
    skipped += body.find("<skipped") != std::string::npos ? 1 : 0;
  }
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"glark-conformance\"";
  text += fmt::format(" tests=\"{}\" failures=\"{}", report.records.size(), failures);
  text += fmt::format("\" errors=\"{}\" skipped=\"{}", errors, skipped);
  text += "\" time=\"" + seconds_text(report.seconds) + "\">\n";
  for (const Record& record : report.records) {
    const std::size_t dot = record.name.rfind('.');
    text += "    <testcase classname=\"" + escaped(record.name.substr(0, dot)) + "\" name=\"" +
            escaped(record.name.substr(dot + 1)) + "\" time=\"" + seconds_text(record.seconds) + "\">\n";
    text += junit_body(record);
    if (!record.output.empty()) text += "      <system-out>" + escaped(record.output) + "</system-out>\n";
    text += "    </testcase>\n";
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

std::string as_log(const Report& report) {
  std::string text = "glark-conformance\n";
  for (const auto& [key, value] : report.environment) text += key + ": " + value + '\n';
  text += '\n';
  for (const Record& record : report.records) {
    text += std::string(name_of(record.verdict)) + ' ' + record.name + " (" + seconds_text(record.seconds) + " s)\n";
    if (record.verdict == Verdict::pass) continue;
    if (const Case* known = find_case(record.name); known != nullptr && record.verdict != Verdict::not_supported) {
      for (const std::string& clause : known->clauses) text += "  " + clause + ": " + sentence_of(clause) + '\n';
      text += "  plan: " + known->plan + '\n';
    }
    for (const std::string& message : record.messages) text += "  " + message + '\n';
    for (const std::string& image : record.images) text += "  " + image + '\n';
    if (!record.output.empty()) text += "  output:\n" + record.output + (record.output.ends_with('\n') ? "" : "\n");
  }
  return text + '\n' + summary_of(report.records) + '\n';
}

}  // namespace glark::conformance
