// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The rows of the table: the measured figure, the best figure of others, and our target.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace glark::bench {

enum class Goal { at_least, at_most, none };

struct Row {
  std::string measure;
  std::string best_known;  // from the thesis or from others; empty: unknown
  Goal goal = Goal::none;
  double target = 0;
  double measured = 0;
  std::string unit;                      // "x": a ratio
  std::map<std::string, double> detail;  // the parts of the figure; only in JSON

  bool met() const;
};

class Report {
 public:
  void add(Row row);
  // Adds a row that could not be measured, with the reason. The row does not count as a reached target.
  void add_error(std::string text);
  void note(std::string text);

  const std::vector<Row>& rows() const { return rows_; }
  bool has_errors() const { return !errors_.empty(); }
  std::string table() const;
  // Returns false if the file cannot be written.
  bool write_json(const std::string& path) const;
  bool write_csv(const std::string& path) const;

 private:
  std::vector<Row> rows_;
  std::vector<std::string> errors_;
  std::vector<std::string> notes_;
};

// Returns the processor's name, the number of cores and the GL renderer.
std::string machine();

}  // namespace glark::bench
