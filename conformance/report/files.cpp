// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "conformance/report/report.h"

namespace glark::conformance {

std::map<Verdict, int> count_verdicts(const std::vector<Record>& records) {
  std::map<Verdict, int> counts;
  for (const Record& record : records) ++counts[record.verdict];
  return counts;
}

std::string summary_of(const std::vector<Record>& records) {
  std::string text;
  for (const auto& [verdict, count] : count_verdicts(records)) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", count, name_of(verdict));
  }
  return text.empty() ? "no case" : text;
}

void prepare_report(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory + "/images", error);
  if (error) throw std::runtime_error("cannot make " + directory + "/images: " + error.message());
  if (access(directory.c_str(), W_OK) != 0 || access((directory + "/images").c_str(), W_OK) != 0)
    throw std::runtime_error("cannot write to " + directory + ": " + std::strerror(errno));
  // Pictures of an earlier run could be taken for pictures of this one.
  for (const auto& entry : std::filesystem::directory_iterator(directory + "/images"))
    if (entry.path().extension() == ".png") std::filesystem::remove(entry.path());
}

void write_file(const std::string& path, const std::string& text) {
  const std::string unfinished = path + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + unfinished);
  std::filesystem::rename(unfinished, path);
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw std::runtime_error("cannot read " + path);
  return text.str();
}

void write_report(const Report& report, const std::string& directory) {
  write_file(directory + "/results.json", as_json(report));
  write_file(directory + "/junit.xml", as_junit(report));
  write_file(directory + "/log.txt", as_log(report));
  write_file(directory + "/index.html", as_html(report));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        result += (byte < 0x20 && c != '\n' && c != '\t') || byte >= 0x7F ? '?' : c;
      }
    }
  }
  return result;
}

}  // namespace glark::conformance
