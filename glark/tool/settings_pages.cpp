// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/settings_pages.h"

#include <fmt/format.h>

#include <string_view>

#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"
#include "glark/settings/rules.h"
#include "glark/settings/table.h"

namespace glark::tool {
namespace {

using settings::Kind;
using settings::Setting;

// "a number from 0.5 to 10000, or 0 for none," ends with a comma because a message goes on after it.
std::string_view limits_of(const Setting& setting) {
  std::string_view text = setting.needed;
  if (text.ends_with(',')) text.remove_suffix(1);
  return text;
}

std::string sentences_of(const Setting& setting) {
  return fmt::format("{}.{}{}", setting.help, setting.details.empty() ? "" : " ", setting.details);
}

// A hyphen that is typed by the user must not become a typographic hyphen.
std::string troff(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
  return escaped;
}

}  // namespace

std::string settings_as_markdown() {
  std::string page;
  std::string_view group;
  for (const Setting& setting : settings::table()) {
    if (setting.group != group)
      page += fmt::format("\n### {}\n| option | variable | value | default | what it does |\n|---|---|---|---|---|\n",
                          group = setting.group);
    const bool toggle = setting.kind == Kind::toggle;
    page += fmt::format("| `--{}{}{}` | `{}` | {} | {} | {} |\n", setting.key, toggle ? "" : " ", setting.value,
                        setting.variable, limits_of(setting), settings::shown_default(setting), sentences_of(setting));
  }
  return page;
}

std::string settings_as_manual() {
  std::string page;
  std::string_view group;
  for (const Setting& setting : settings::table()) {
    if (setting.group != group) page += fmt::format(".SS {}\n", group = setting.group);
    if (setting.kind == Kind::toggle)
      page += fmt::format(".TP\n.B \\-\\-{}\n", troff(setting.key));
    else
      page += fmt::format(".TP\n.BI \\-\\-{} \" {}\"\n", troff(setting.key), troff(setting.value));
    page += fmt::format("{}\nValue: {}. Default: {}.\n.RB ( {} )\n", troff(sentences_of(setting)),
                        troff(limits_of(setting)), troff(settings::shown_default(setting)), setting.variable);
  }
  return page;
}

std::string rules_as_markdown() {
  std::string page = "| key | value | what it asks for |\n|---|---|---|\n";
  for (const settings::RuleKey& row : settings::rule_keys())
    page += fmt::format("| `{}` | {} | {}. |\n", row.key, row.needed, row.help);
  return page;
}

std::string causes_as_markdown() {
  std::string page = "\n### Draws that stay unrefined\n| cause | why | remedy |\n|---|---|---|\n";
  for (unsigned i = 0; i < core::cause_count; ++i) {
    const core::CauseText& text = core::text_of(static_cast<core::Cause>(i));
    page += fmt::format("| `{}` | {} | {} |\n", text.key, text.explanation, text.remedy);
  }
  page += "\n### Draws that get another refinement\n| fallback | why | remedy |\n|---|---|---|\n";
  for (unsigned i = 0; i < core::refinement_fallback_count; ++i) {
    const core::FallbackText& text = core::text_of(static_cast<core::RefinementFallback>(i));
    page += fmt::format("| `{}` | {} | {} |\n", text.key, text.explanation, text.remedy);
  }
  return page;
}

}  // namespace glark::tool
