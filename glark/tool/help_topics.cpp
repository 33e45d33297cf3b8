// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/help_topics.h"

#include <fmt/format.h>

#include <algorithm>

#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"
#include "glark/settings/names/nearest_name.h"
#include "glark/settings/rules.h"
#include "glark/settings/table.h"
#include "glark/settings/terminal.h"

namespace glark::tool {
namespace {

namespace style = settings::style;

class Page {
 public:
  explicit Page(bool colors) : colors_(colors) {}

  void head(std::string_view text) { text_ += fmt::format("{}{}{}\n", on(), text, off()); }
  void line(std::string_view label, std::string_view text) {
    if (!text.empty()) text_ += fmt::format("  {}{:<10}{} {}\n", on(), label, off(), text);
  }
  void gap() { text_ += text_.empty() ? "" : "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string_view on() const { return colors_ ? style::bold : std::string_view(); }
  std::string_view off() const { return colors_ ? style::plain : std::string_view(); }

  bool colors_;
  std::string text_;
};

// "a number from 0.5 to 10000, or 0 for none," ends with a comma because a message goes on after it.
std::string_view without_comma(std::string_view text) {
  if (text.ends_with(',')) text.remove_suffix(1);
  return text;
}

void add_option(const settings::Setting& setting, Page& page) {
  page.gap();
  page.head(setting.value.empty() ? fmt::format("--{}", setting.key)
                                  : fmt::format("--{} {}", setting.key, setting.value));
  page.line("does", fmt::format("{}.{}{}", setting.help, setting.details.empty() ? "" : " ", setting.details));
  page.line("value", setting.kind == settings::Kind::toggle ? "" : without_comma(setting.needed));
  page.line("default", settings::shown_default(setting));
  page.line("variable", setting.variable);
  if (setting.in_file) page.line("file", fmt::format("{} = ... in [program.NAME]", setting.key));
}

template <class Text>
void add_reason(const Text& reason, std::string_view what, Page& page) {
  page.gap();
  page.head(fmt::format("{}: {}", reason.key, what));
  page.line("why", reason.explanation);
  page.line("remedy", reason.remedy);
}

// Calls `visit` with each topic's name and what adds it to a page.
template <class Visit>
void for_each_topic(const Visit& visit) {
  for (const settings::Setting& setting : settings::table())
    visit(setting.key, [&](Page& page) { add_option(setting, page); });
  for (unsigned i = 0; i < core::cause_count; ++i) {
    const core::CauseText& text = core::text_of(static_cast<core::Cause>(i));
    visit(text.key, [&](Page& page) { add_reason(text, "a draw stays unrefined", page); });
  }
  for (unsigned i = 0; i < core::refinement_fallback_count; ++i) {
    const core::FallbackText& text = core::text_of(static_cast<core::RefinementFallback>(i));
    visit(text.key, [&](Page& page) { add_reason(text, "a draw gets another refinement", page); });
  }
  for (const settings::RuleKey& row : settings::rule_keys())
    visit(row.key, [&](Page& page) {
      page.gap();
      page.head(fmt::format("{}: a key of a [[rule]]", row.key));
      page.line("asks for", row.help);
      page.line("value", row.needed);
    });
}

}  // namespace

std::vector<std::string> help_topics() {
  std::vector<std::string> names;
  for_each_topic([&](std::string_view name, const auto&) { names.emplace_back(name); });
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::optional<std::string> help_on(std::string_view topic, bool colors) {
  if (topic.starts_with("--")) topic.remove_prefix(2);
  Page page(colors);
  for_each_topic([&](std::string_view name, const auto& add) {
    if (name == topic) add(page);
  });
  return page.text().empty() ? std::nullopt : std::optional(page.text());
}

std::string nearest_topic(std::string_view wrong) {
  const std::vector<std::string> names = help_topics();
  const std::vector<std::string_view> views(names.begin(), names.end());
  return std::string(settings::nearest_name(wrong, views));
}

}  // namespace glark::tool
