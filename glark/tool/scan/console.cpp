// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/console.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace glark::tool {
namespace {

constexpr auto interval = std::chrono::milliseconds(100);
constexpr int bar_width = 30;
constexpr std::size_t name_width = 24;

std::string plain(const Report& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.9g", value.get<double>());
    return text;
  }
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Report& entry : value) list += (list.empty() ? "" : " ") + plain(entry);
  return list;
}

void print_lines(const Report& report, const std::string& indent) {
  for (const auto& [key, value] : report.items()) {
    std::string name = indent + key;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (value.is_object()) {
      std::printf("%s\n", name.c_str());
      print_lines(value, indent + "  ");
      continue;
    }
    name.resize(std::max(name.size() + 1, name_width), ' ');
    std::printf("%s%s\n", name.c_str(), plain(value).c_str());
  }
}

}  // namespace

Progress::Progress(std::string step)
    : step_(std::move(step)),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      begun_(std::chrono::steady_clock::now()),
      shown_(begun_) {}

Progress::~Progress() {
  if (on_terminal_) std::fprintf(stderr, "\r\033[K");
}

void Progress::show(double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - shown_ < interval) return;
  shown_ = now;
  if (fraction < 0) {
    std::fprintf(stderr, "\r\033[K%s, %.0f s", step_.c_str(), seconds());
    return;
  }
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * bar_width);
  std::fprintf(stderr, "\r\033[K%s [%s%s] %3.0f %%", step_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(bar_width - filled), '.').c_str(), 100 * std::min(fraction, 1.0));
}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

void warn(const std::string& text) { std::fprintf(stderr, "glark: %s\n", text.c_str()); }

void print(const Report& report, bool json) {
  if (json)
    // A file name may have bytes that are not UTF-8; JSON gets U+FFFD for them.
    std::printf("%s\n", report.dump(2, ' ', false, Report::error_handler_t::replace).c_str());
  else
    print_lines(report, "");
}

}  // namespace glark::tool
