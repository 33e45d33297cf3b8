// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/measure/table.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace glark::bench {
namespace {

std::string text_of(const Cell& cell) {
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  const auto* number = std::get_if<Number>(&cell);
  if (number == nullptr) return "";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", number->digits, number->value);
  return text.data();
}

nlohmann::json json_of(const Cell& cell) {
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  if (const auto* number = std::get_if<Number>(&cell)) return number->value;
  return nullptr;
}

}  // namespace

std::string markdown_of(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) {
    text += "\n### " + table.title + "\n|";
    for (const std::string& column : table.columns) text += " " + column + " |";
    text += "\n|";
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
    text += "\n";
    for (const std::vector<Cell>& row : table.rows) {
      text += "|";
      for (const Cell& cell : row) text += " " + text_of(cell) + " |";
      text += "\n";
    }
    if (!table.note.empty()) text += "\n" + table.note + "\n";
  }
  return text;
}

std::string json_of(const std::vector<Table>& tables) {
  nlohmann::json all = nlohmann::json::array();
  for (const Table& table : tables) {
    nlohmann::json rows = nlohmann::json::array();
    for (const std::vector<Cell>& row : table.rows) {
      nlohmann::json cells;
      for (std::size_t i = 0; i < row.size(); ++i)
        cells[table.columns[i].empty() ? "name" : table.columns[i]] = json_of(row[i]);
      rows.push_back(cells);
    }
    all.push_back({{"title", table.title}, {"rows", rows}});
  }
  return all.dump(2) + "\n";
}

void replace_in(const std::string& file, const std::string& markdown) {
  std::ostringstream whole;
  if (std::ifstream in(file); in) whole << in.rdbuf();
  std::string text = whole.str();
  const std::string first = "<!-- glark-bench-points -->\n", last = "<!-- end of glark-bench-points -->";
  const std::size_t begin = text.find(first), end = text.find(last);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw std::runtime_error(file + " does not have the two lines between which the tables go");
  text.replace(begin + first.size(), end - begin - first.size(), markdown);
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw std::runtime_error(file + " cannot be written");
}

}  // namespace glark::bench
