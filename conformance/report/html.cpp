// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <cstdio>

#include "conformance/report/report.h"
#include "conformance/suite/case.h"

namespace glark::conformance {
namespace {

constexpr char head[] = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>GL_ARK_adaptive_refinement: conformance</title>
<style>
 body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em; color: #1c2430; }
 h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; }
 table { border-collapse: collapse; } td, th { text-align: left; padding: .15em .8em .15em 0; vertical-align: top; }
 .counts b { display: inline-block; padding: .1em .6em; border-radius: .3em; margin-right: .4em; color: #fff; }
 .case { border-left: 4px solid; padding: .3em .9em; margin: 1em 0; background: #f6f7f9; }
 .case h3 { font-size: 1em; margin: 0; } .case p { margin: .4em 0; } blockquote { margin: .4em 0 .4em 1em; font-style: italic; }
 pre { background: #fff; padding: .5em; overflow-x: auto; margin: .4em 0; white-space: pre-wrap; }
 figure { display: inline-block; margin: .4em 1em .4em 0; } figcaption { font-size: .85em; }
 img { width: 256px; image-rendering: pixelated; background: #888; display: block; }
 details { margin: .2em 0; } summary { cursor: pointer; } .list td { font-family: ui-monospace, monospace; font-size: .85em; }
 .good { background: #2c7a4b; border-color: #2c7a4b; } .bad { background: #b3261e; border-color: #b3261e; }
 .odd { background: #9a6700; border-color: #9a6700; } .none { background: #667085; border-color: #667085; }
 .case.bad, .case.odd, .case.none, .case.good { background: #f6f7f9; }
</style>
</head>
<body>
<h1>GL_ARK_adaptive_refinement: conformance</h1>
)";

const char* class_of(Verdict verdict) {
  if (is_bad(verdict)) return "bad";
  switch (verdict) {
    case Verdict::pass: return "good";
    case Verdict::not_supported:
    case Verdict::unimplemented: return "none";
    default: return "odd";
  }
}

std::string label_of(const std::string& path) {
  const std::size_t dash = path.rfind('-');
  const std::string label = dash == std::string::npos ? path : path.substr(dash + 1);
  return label.substr(0, label.rfind('.'));
}

std::string details_of(const Record& record) {
  std::string text =
      std::string("<div class=\"case ") + class_of(record.verdict) + "\" id=\"" + escaped(record.name) + "\">\n";
  text += "<h3>" + escaped(record.name) + ": " + std::string(name_of(record.verdict)) + "</h3>\n";
  if (const Case* known = find_case(record.name)) {
    for (const std::string& clause : known->clauses)
      text +=
          "<blockquote>" + escaped(sentence_of(clause)) + " <small>(" + escaped(clause) + ")</small></blockquote>\n";
    text += "<p><b>Plan.</b> " + escaped(known->plan) + "</p>\n";
    if (!known->wrong.empty()) text += "<p><b>Wrong implementations.</b> " + escaped(known->wrong) + "</p>\n";
  }
  if (!record.messages.empty()) {
    text += "<pre>";
    for (const std::string& message : record.messages) text += escaped(message) + '\n';
    text += "</pre>\n";
  }
  for (const std::string& image : record.images)
    text += "<figure><img src=\"" + escaped(image) + "\" alt=\"\"><figcaption>" + escaped(label_of(image)) +
            "</figcaption></figure>\n";
  if (!record.output.empty())
    text += "<details><summary>Output of its process</summary><pre>" + escaped(record.output) + "</pre></details>\n";
  return text + "</div>\n";
}

std::string row_of(const Record& record) {
  char seconds[32];
  std::snprintf(seconds, sizeof(seconds), "%.2f s", record.seconds);
  return "<tr><td>" + escaped(record.name) + "</td><td>" + std::string(name_of(record.verdict)) + "</td><td>" +
         seconds + "</td></tr>\n";
}

// The area of ark.tags.array.stride_zero is ark.tags.
std::string area_of(const std::string& name) { return name.substr(0, name.find('.', name.find('.') + 1)); }

std::string areas_of(const std::vector<Record>& records) {
  std::string text;
  for (std::size_t first = 0; first < records.size();) {
    std::size_t last = first;
    std::string rows;
    std::vector<Record> area;
    for (; last < records.size() && area_of(records[last].name) == area_of(records[first].name); ++last) {
      rows += row_of(records[last]);
      area.push_back(records[last]);
    }
    text += "<details><summary><b>" + escaped(area_of(records[first].name)) + "</b>: " + summary_of(area) +
            "</summary><table class=\"list\">\n" + rows + "</table></details>\n";
    first = last;
  }
  return text;
}

}  // namespace

std::string as_html(const Report& report) {
  std::string text = head;
  text += "<p class=\"counts\">";
  for (const auto& [verdict, count] : count_verdicts(report.records))
    text += fmt::format("<b class=\"{}\">{} {}</b>", class_of(verdict), count, name_of(verdict));
  text += "</p>\n<table>\n";
  for (const auto& [key, value] : report.environment)
    text += "<tr><th>" + escaped(key) + "</th><td>" + escaped(value) + "</td></tr>\n";
  text += "<tr><th>command</th><td>";
  for (const std::string& word : report.command) text += escaped(word) + ' ';
  text += "</td></tr>\n</table>\n";

  std::string bad;
  std::string odd;
  for (const Record& record : report.records) {
    if (is_bad(record.verdict)) bad += details_of(record);
    if (std::string(class_of(record.verdict)) == "odd") odd += details_of(record);
  }
  text += bad.empty() ? "<h2>No case failed</h2>\n" : "<h2>What failed</h2>\n" + bad;
  if (!odd.empty()) text += "<h2>Warnings, and what was expected to fail</h2>\n" + odd;
  return text + "<h2>Every case</h2>\n" + areas_of(report.records) + "</body>\n</html>\n";
}

}  // namespace glark::conformance
