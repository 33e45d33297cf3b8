// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace glark::tool {
namespace {

using settings::Kind;
using settings::Setting;

// A format of fmt: braces are doubled.
constexpr char bash_script[] = R"(# Completion of glark for bash; `glark settings --as bash` prints it.
_glark_words() {{ mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current"); }}

_glark_program() {{
  if declare -F _command_offset >/dev/null; then
    _command_offset "$1"
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}

_glark() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} i
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    _glark_words '{commands}'
    return
  fi
  case ${{COMP_WORDS[1]}} in
    run | doctor) ;;
    help) _glark_words '{topics}'; return ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
  esac
  # The program begins after --, or at the first word that is neither an option nor the value of one.
  for ((i = 2; i < COMP_CWORD; ++i)); do
    case ${{COMP_WORDS[i]}} in
      --) _glark_program $((i + 1)); return ;;
      {with_value}) ((++i)) ;;
      -*) ;;
      *) _glark_program "$i"; return ;;
    esac
  done
  case $previous in
{values}    {files}) mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
    {folders}) mapfile -t COMPREPLY < <(compgen -d -- "$current"); return ;;
    {with_value}) return ;;
  esac
  if [[ $current == -* ]]; then
    _glark_words '{options} --help'
  else
    mapfile -t COMPREPLY < <(compgen -c -- "$current")
  fi
}}
complete -o filenames -F _glark glark
)";

bool takes_value(const Setting& setting) { return setting.kind != Kind::toggle; }
bool takes_file(const Setting& setting) {
  return setting.kind == Kind::output_file || setting.kind == Kind::input_file;
}

std::string joined(std::span<const std::string> words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : std::string(between)) + word;
  return text;
}

std::vector<std::string> options_that(bool (*wanted)(const Setting& setting)) {
  std::vector<std::string> names;
  for (const Setting& setting : settings::table())
    if (wanted(setting)) names.push_back(fmt::format("--{}", setting.key));
  return names;
}

// The part of "a, b or c" before the next separator; removes both from `text`.
std::string_view next_part(std::string_view& text) {
  constexpr std::string_view separators[] = {", or ", ", ", " or "};
  std::size_t end = text.size();
  std::size_t after = text.size();
  for (const std::string_view separator : separators)
    if (const std::size_t at = text.find(separator); at < end) {
      end = at;
      after = at + separator.size();
    }
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(after);
  return part;
}

// The words of "F1 to F12"; others than such a range stay as they are.
std::vector<std::string> words_of_part(std::string_view part) {
  const std::size_t to = part.find(" to ");
  const std::size_t digits = part.find_first_of("0123456789");
  if (to == std::string_view::npos || digits == 0 || digits >= to) return {std::string(part)};
  const std::string_view letters = part.substr(0, digits);
  const std::string_view last = part.substr(to + 4);
  if (!last.starts_with(letters)) return {std::string(part)};
  const auto number = [&](std::string_view text) { return std::atoi(std::string(text.substr(digits)).c_str()); };
  std::vector<std::string> words;
  for (int i = number(part.substr(0, to)); i <= number(last); ++i) words.push_back(fmt::format("{}{}", letters, i));
  return words;
}

std::string bash_values() {
  std::string cases;
  for (const Setting& setting : settings::table())
    if (const std::vector<std::string> words = words_of(setting); !words.empty())
      cases += fmt::format("    --{}) _glark_words '{}'; return ;;\n", setting.key, joined(words, " "));
  return cases;
}

// Within '...[...]:...' of _arguments.
std::string zsh_text(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\'')
      escaped += "'\\''";
    else if (letter == '[' || letter == ']' || letter == ':' || letter == '\\')
      escaped += std::string("\\") + letter;
    else
      escaped += letter;
  }
  return escaped;
}

std::string zsh_action(const Setting& setting) {
  if (const std::vector<std::string> words = words_of(setting); !words.empty())
    return fmt::format("({})", joined(words, " "));
  if (takes_file(setting)) return "_files";
  return setting.kind == Kind::output_folder ? "_files -/" : " ";
}

std::string zsh_option(const Setting& setting) {
  const std::string_view repeated = setting.kind == Kind::captures ? "*" : "";
  const std::string option = fmt::format("'{}--{}[{}]", repeated, setting.key, zsh_text(setting.help));
  if (!takes_value(setting)) return option + "'";
  return fmt::format("{}:{}:{}'", option, zsh_text(setting.value), zsh_action(setting));
}

}  // namespace

std::vector<std::string> words_of(const Setting& setting) {
  std::vector<std::string> words;
  std::string_view text = setting.needed;
  if (text.ends_with(',')) text.remove_suffix(1);
  if (text.starts_with("a list of ")) text.remove_prefix(text.find("of ") + 3);
  if (setting.kind != Kind::value) return words;
  while (!text.empty()) {
    for (const std::string& part : words_of_part(next_part(text))) {
      settings::Settings scratch;
      const bool word = !part.empty() && part.find(' ') == std::string::npos;
      if (word && setting.read(scratch, part)) words.push_back(part);
    }
  }
  return words.size() > 1 ? words : std::vector<std::string>();
}

std::string bash_completion(std::span<const CommandLine> commands, std::span<const std::string> topics) {
  std::vector<std::string> names;
  for (const CommandLine& command : commands) names.push_back(command.name);
  return fmt::format(
      bash_script, fmt::arg("commands", joined(names, " ")), fmt::arg("topics", joined(topics, " ")),
      fmt::arg("with_value", joined(options_that(takes_value), " | ")), fmt::arg("values", bash_values()),
      fmt::arg("files", joined(options_that(takes_file), " | ")),
      fmt::arg("folders", joined(options_that([](const Setting& s) { return s.kind == Kind::output_folder; }), " | ")),
      fmt::arg("options", joined(options_that([](const Setting&) { return true; }), " ")));
}

std::string zsh_completion(std::span<const CommandLine> commands, std::span<const std::string> topics) {
  std::string described;
  for (const CommandLine& command : commands)
    described += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.help));
  std::string options;
  for (const Setting& setting : settings::table()) options += fmt::format("    {}\n", zsh_option(setting));
  return fmt::format(
      R"(#compdef glark
# Completion of glark for zsh; `glark settings --as zsh` prints it.
_glark() {{
  local -a commands options
  commands=(
{}  )
  options=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  case $words[2] in
    run | doctor)
      shift words
      (( CURRENT-- ))
      _arguments -S $options '*::program: _normal'
      ;;
    help) compadd -- {} ;;
    *) _files ;;
  esac
}}
_glark "$@"
)",
      described, options, joined(topics, " "));
}

}  // namespace glark::tool
