// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>

#include "tests/bench/gl.h"

namespace glark::bench {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  const char* format = value != 0 && std::abs(value) < 0.1 ? "%.3f" : std::abs(value) < 100 ? "%.2f" : "%.0f";
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string with_unit(double value, const std::string& unit) {
  return number(value) + (unit == "x" ? "x" : " " + unit);
}

std::string target_of(const Row& row) {
  switch (row.goal) {
    case Goal::at_least: return ">= " + with_unit(row.target, row.unit);
    case Goal::at_most: return "<= " + with_unit(row.target, row.unit);
    default: return "-";
  }
}

std::string verdict_of(const Row& row) { return row.goal == Goal::none ? "-" : row.met() ? "ok" : "short"; }

std::array<std::string, 5> cells_of(const Row& row) {
  return {row.measure, row.best_known.empty() ? "-" : row.best_known, target_of(row), with_unit(row.measured, row.unit),
          verdict_of(row)};
}

}  // namespace

bool Row::met() const {
  switch (goal) {
    case Goal::at_least: return measured >= target;
    case Goal::at_most: return measured <= target;
    default: return true;
  }
}

void Report::add(Row row) {
  const auto cells = cells_of(row);
  std::cerr << cells[0] << ": " << cells[3] << " (" << cells[2] << ") " << cells[4] << '\n';
  rows_.push_back(std::move(row));
}

void Report::add_error(std::string text) {
  std::cerr << "error: " << text << '\n';
  errors_.push_back(std::move(text));
}

void Report::note(std::string text) {
  std::cerr << "note: " << text << '\n';
  notes_.push_back(std::move(text));
}

std::string Report::table() const {
  std::vector<std::array<std::string, 5>> lines{{"measure", "thesis / best known", "target", "measured", ""}};
  for (const Row& row : rows_) lines.push_back(cells_of(row));
  std::array<std::size_t, 5> widths{};
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string rule = "|";
    text += "|";
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text += " " + lines[k][i] + std::string(widths[i] - lines[k][i].size(), ' ') + " |";
      rule += std::string(widths[i] + 2, '-') + "|";
    }
    text += "\n" + (k == 0 ? rule + "\n" : "");
  }
  for (const std::string& line : notes_) text += "note: " + line + "\n";
  for (const std::string& line : errors_) text += "error: " + line + "\n";
  return text;
}

bool Report::write_csv(const std::string& path) const {
  std::ofstream file(path);
  file << "measure,quantity,value\n";
  for (const Row& row : rows_) {
    file << row.measure << ",measured," << row.measured << '\n';
    for (const auto& [quantity, value] : row.detail) file << row.measure << ',' << quantity << ',' << value << '\n';
  }
  return static_cast<bool>(file.flush());
}

bool Report::write_json(const std::string& path) const {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : rows_) {
    nlohmann::ordered_json entry{{"measure", row.measure}, {"measured", row.measured}, {"unit", row.unit}};
    if (!row.best_known.empty()) entry["best_known"] = row.best_known;
    if (row.goal != Goal::none) {
      entry["goal"] = row.goal == Goal::at_least ? "at least" : "at most";
      entry["target"] = row.target;
      entry["met"] = row.met();
    }
    if (!row.detail.empty()) entry["detail"] = row.detail;
    rows.push_back(std::move(entry));
  }
  std::ofstream file(path);
  file << nlohmann::ordered_json{{"machine", machine()}, {"rows", rows}, {"notes", notes_}, {"errors", errors_}}.dump(2)
       << '\n';
  return file.good();
}

std::string machine() {
  std::ifstream information("/proc/cpuinfo");
  std::string processor = "unknown processor";
  for (std::string line; std::getline(information, line);) {
    constexpr std::string_view key = "model name";
    if (line.compare(0, key.size(), key) == 0) {
      processor = line.substr(line.find(':') + 2);
      break;
    }
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " +
         (renderer != nullptr ? renderer : "no context") + ", " + (version != nullptr ? version : "");
}

}  // namespace glark::bench
