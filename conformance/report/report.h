// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The files of a report's directory: results.json (which `verify` reads), junit.xml, log.txt, index.html, and images/.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "conformance/report/record.h"

namespace glark::conformance {

struct Report {
  Environment environment;
  std::vector<std::string> command;  // the words of the command line
  double seconds = 0;
  std::vector<Record> records;
};

std::map<Verdict, int> count_verdicts(const std::vector<Record>& records);
// "412 Pass, 1 Fail": the verdicts that occur.
std::string summary_of(const std::vector<Record>& records);

// Makes the directory and images/ in it. Throws std::runtime_error if it cannot be written to.
void prepare_report(const std::string& directory);

std::string as_json(const Report& report);
std::string as_junit(const Report& report);
std::string as_log(const Report& report);
std::string as_html(const Report& report);

// Writes all four. Each file appears whole or not at all. Throws std::runtime_error.
void write_report(const Report& report, const std::string& directory);

// Reads results.json. Throws std::runtime_error that names the file and what is wrong.
Report read_report(const std::string& path);
Report parse_report(const std::string& text, const std::string& name);

// Writes to another file, then renames it. Throws std::runtime_error.
void write_file(const std::string& path, const std::string& text);
std::string read_file(const std::string& path);

// Escapes & < > " for XML and HTML. Bytes that neither accepts become '?'.
std::string escaped(const std::string& text);

}  // namespace glark::conformance
