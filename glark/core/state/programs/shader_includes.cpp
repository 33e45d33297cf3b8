// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/shader_includes.h"

#include <algorithm>
#include <optional>

namespace glark::core {
namespace {

constexpr int deepest = 32;                               // a string may include itself, in a part that is not compiled
constexpr std::size_t most_bytes = std::size_t{1} << 22;  // of the whole source
constexpr std::string_view blanks = " \t\v\f";

std::string_view without_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(blanks), text.size()));
}

struct Directive {
  std::string_view path;
  bool quoted;  // by "", not by <>
};

// The directive of a line that is no comment.
std::optional<Directive> directive_of(std::string_view line) {
  for (const std::string_view word : {"#", "include"}) {
    line = without_blanks(line);
    if (!line.starts_with(word)) {
      return std::nullopt;
    }
    line.remove_prefix(word.size());
  }
  line = without_blanks(line);
  const bool quoted = line.starts_with('"');
  const std::size_t end = line.find(quoted ? '"' : '>', 1);
  if ((!quoted && !line.starts_with('<')) || end == std::string_view::npos) {
    return std::nullopt;
  }
  return Directive{.path = line.substr(1, end - 1), .quoted = quoted};
}

// Whether a comment /* */ is open at the end of the line.
bool in_comment_after(std::string_view line, bool in_comment) {
  for (std::size_t at = 0; at < line.size();) {
    const std::string_view rest = line.substr(at);
    if (!in_comment && rest.starts_with("//")) {
      return false;
    }
    const bool turns = rest.starts_with(in_comment ? "*/" : "/*");
    in_comment = in_comment != turns;
    at += turns ? 2 : 1;
  }
  return in_comment;
}

std::string joined(std::string_view folder, std::string_view path) {
  std::string whole(folder.substr(0, folder.ends_with('/') ? folder.size() - 1 : folder.size()));
  return (whole += '/') += path;
}

std::string_view folder_of(std::string_view path) { return path.substr(0, path.rfind('/')); }

class Expansion {
 public:
  Expansion(const gl::Dispatch& gl, const std::vector<std::string>& paths) : gl_(gl), paths_(paths) {}

  // `place`: the path of this string; empty for the source of the shader.
  void add(std::string_view text, std::string_view place, int depth) {
    bool in_comment = false;
    while (!text.empty() && result_.size() < most_bytes) {
      const std::size_t end = text.find('\n');
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      const std::optional<Directive> directive = in_comment ? std::nullopt : directive_of(line);
      if (!directive || !include(*directive, place, depth)) {
        result_.append(line);
      }
      result_ += '\n';
      in_comment = in_comment_after(line, in_comment);
    }
  }
  const std::string& result() const { return result_; }

 private:
  bool include(const Directive& directive, std::string_view place, int depth) {
    std::vector<std::string> candidates;
    if (directive.path.starts_with('/')) {
      candidates.emplace_back(directive.path);
    } else {
      if (directive.quoted && !place.empty()) {
        candidates.push_back(joined(folder_of(place), directive.path));
      }
      for (const std::string& path : paths_) {
        candidates.push_back(joined(path, directive.path));
      }
    }
    for (const std::string& candidate : candidates) {
      if (const std::optional<std::string> text = named_string(candidate); text && depth < deepest) {
        add(*text, candidate, depth + 1);
        return true;
      }
    }
    return false;
  }

  std::optional<std::string> named_string(const std::string& path) const {
    if (gl_.IsNamedStringARB(-1, path.c_str()) == GL_FALSE) {
      return std::nullopt;
    }
    GLint length = 0;  // with the null at its end
    gl_.GetNamedStringivARB(-1, path.c_str(), GL_NAMED_STRING_LENGTH_ARB, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
    GLint written = 0;
    gl_.GetNamedStringARB(-1, path.c_str(), length, &written, text.data());
    text.resize(static_cast<std::size_t>(std::clamp(written, 0, length)));
    return text;
  }

  const gl::Dispatch& gl_;
  const std::vector<std::string>& paths_;
  std::string result_;
};

}  // namespace

bool may_include(std::string_view source) { return source.find("include") != std::string_view::npos; }

std::string expand_includes(const gl::Dispatch& gl, const std::string& source, const std::vector<std::string>& paths) {
  if (gl.IsNamedStringARB == nullptr) {
    return source;
  }
  Expansion expansion(gl, paths);
  expansion.add(source, {}, 0);
  const std::string& result = expansion.result();
  const bool asks_for_place =
      result.find("__LINE__") != std::string::npos || result.find("__FILE__") != std::string::npos;
  return result.size() < most_bytes && !asks_for_place ? result : source;
}

}  // namespace glark::core
