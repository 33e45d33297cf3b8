// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <unordered_set>

namespace glark::refine {
namespace {

using Names = std::unordered_set<std::string_view>;

const Names& qualifiers() {
  static const Names names = {
      "const", "in",      "out",      "inout",    "attribute", "varying",   "uniform",       "buffer",     "shared",
      "flat",  "smooth",  "patch",    "sample",   "centroid",  "invariant", "noperspective", "precise",    "lowp",
      "highp", "mediump", "coherent", "volatile", "restrict",  "readonly",  "writeonly",     "subroutine", "layout"};
  return names;
}

struct Qualifiers {
  Storage storage = Storage::none;
  bool flat = false;
  bool noperspective = false;
  bool smooth = false;
};

class Reader {
 public:
  Reader(const Tokens& tokens, Interface& interface) : tokens_(tokens), interface_(interface) {}

  void read() {
    while (!failed() && at().kind != TokenKind::end) {
      if (at().kind == TokenKind::directive || at().is(";")) {
        ++at_;
      } else {
        read_statement();
      }
    }
    interface_.ok = !failed();
  }

 private:
  bool failed() const { return !interface_.error.empty(); }
  const Token& at() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }
  const Token& ahead(std::size_t distance = 1) const { return tokens_[std::min(at_ + distance, tokens_.size() - 1)]; }

  void fail(const std::string& what) {
    if (!failed()) interface_.error = fmt::format("line {}: {}", at().line, what);
    at_ = tokens_.size() - 1;
  }

  // Past the bracket that closes the one at hand.
  void skip_brackets() {
    const std::size_t opening = at_;
    int depth = 0;
    do {
      const Token& token = at();
      if (token.is("(") || token.is("{") || token.is("[")) ++depth;
      if (token.is(")") || token.is("}") || token.is("]")) --depth;
      if (token.kind == TokenKind::end) {
        at_ = opening;
        return fail("'" + at().text + "' is never closed");
      }
      ++at_;
    } while (depth > 0);
  }

  void skip_statement() {
    while (!failed() && !at().is(";") && at().kind != TokenKind::end) {
      if (at().is("(") || at().is("{") || at().is("[")) {
        skip_brackets();
      } else {
        ++at_;
      }
    }
    if (!failed() && at().kind == TokenKind::end) fail("';' expected at the end of the shader");
    ++at_;
  }

  // Newer qualifiers are ordinary names in older shaders. There, the next token is not a name.
  bool at_qualifier() const {
    if (!qualifiers().contains(at().text)) return false;
    const bool may_be_name = at().is("sample") || at().is("buffer") || at().is("patch") || at().is("shared") ||
                             at().is("precise") || at().is("subroutine") || at().is("layout");
    return !may_be_name || ahead().kind == TokenKind::identifier ||
           ((at().is("layout") || at().is("subroutine")) && ahead().is("("));
  }

  Qualifiers read_qualifiers() {
    Qualifiers found;
    for (; at_qualifier() && !failed(); ++at_) {
      const Token& token = at();
      if (token.is("in") || token.is("attribute")) found.storage = Storage::input;
      // EXT_gpu_shader4 also writes "varying out".
      if (token.is("out") || token.is("varying")) found.storage = Storage::output;
      if (token.is("uniform")) found.storage = Storage::uniform;
      if (token.is("buffer")) found.storage = Storage::buffer;
      if (token.is("const")) found.storage = Storage::constant;
      if (token.is("shared") || token.is("inout")) found.storage = Storage::other;
      if (token.is("flat")) found.flat = true;
      if (token.is("noperspective")) found.noperspective = true;
      if (token.is("smooth")) found.smooth = true;
      if ((token.is("layout") || token.is("subroutine")) && ahead().is("(")) {
        ++at_;
        skip_brackets();
        --at_;
      }
    }
    return found;
  }

  void read_sizes(std::vector<std::string>& sizes) {
    while (at().is("[") && !failed()) {
      const std::size_t begin = at_ + 1;
      skip_brackets();
      sizes.push_back(failed() ? "" : to_text(tokens_, begin, at_ - 1));
    }
  }

  // name[sizes] = initializer, up to and including the ';'.
  void read_variables(const Qualifiers& found, const std::string& type, const std::vector<std::string>& type_sizes,
                      std::vector<Variable>& variables) {
    while (!failed() && !at().is(";")) {
      if (at().kind != TokenKind::identifier) return fail("a name was expected instead of '" + at().text + "'");
      Variable variable;
      variable.name = at().text;
      variable.type = type;
      variable.flat = found.flat;
      variable.noperspective = found.noperspective;
      variable.smooth = found.smooth;
      ++at_;
      read_sizes(variable.sizes);
      variable.sizes.insert(variable.sizes.end(), type_sizes.begin(), type_sizes.end());
      if (at().is("=")) {
        variable.initializer_begin = ++at_;
        while (!failed() && !at().is(",") && !at().is(";")) skip_one();
        variable.initializer_end = at_;
      }
      variables.push_back(std::move(variable));
      if (at().is(",")) {
        ++at_;
      } else if (!at().is(";")) {
        fail("';' expected before '" + at().text + "'");
      }
    }
    ++at_;
  }

  void skip_one() {
    if (at().kind == TokenKind::end) return fail("';' expected at the end of the shader");
    if (at().is("(") || at().is("{") || at().is("[")) return skip_brackets();
    ++at_;
  }

  std::vector<Variable> read_members() {
    std::vector<Variable> members;
    ++at_;
    while (!failed() && !at().is("}")) {
      if (at().is(";") || at().kind == TokenKind::directive) {
        ++at_;
        continue;
      }
      const Qualifiers found = read_qualifiers();
      if (at().kind != TokenKind::identifier) {
        fail("a member was expected instead of '" + at().text + "'");
        break;
      }
      const std::string type = at().text;
      ++at_;
      std::vector<std::string> sizes;
      read_sizes(sizes);
      read_variables(found, type, sizes, members);
    }
    ++at_;
    return members;
  }

  std::string read_structure() {
    ++at_;
    Structure structure;
    if (at().kind == TokenKind::identifier) {
      structure.name = at().text;
      ++at_;
    }
    if (at().is("{")) {
      structure.members = read_members();
      interface_.structures.push_back(structure);
    }
    return structure.name;
  }

  void read_function(std::size_t name) {
    skip_brackets();
    if (at().is("{")) {
      interface_.functions.push_back(tokens_[name].text);
      if (tokens_[name].is("main")) interface_.defines_main = true;
      skip_brackets();
    } else if (at().is(";")) {
      ++at_;
    } else {
      fail("'{' or ';' expected after the parameters of '" + tokens_[name].text + "'");
    }
  }

  void read_block(Declaration declaration, const Qualifiers& found) {
    declaration.is_block = true;
    declaration.block_name = at().text;
    ++at_;
    declaration.members = read_members();
    for (Variable& member : declaration.members) {
      member.flat = member.flat || found.flat;
      member.noperspective = member.noperspective || found.noperspective;
    }
    read_variables(found, declaration.block_name, {}, declaration.variables);
    interface_.declarations.push_back(std::move(declaration));
  }

  void read_statement() {
    if (at().is("precision")) return skip_statement();
    Declaration declaration;
    declaration.begin = at_;
    const Qualifiers found = read_qualifiers();
    declaration.storage = found.storage;
    declaration.type_token = at_;
    if (failed() || at().is(";")) return;
    if (at().kind != TokenKind::identifier) return fail("a declaration was expected instead of '" + at().text + "'");
    if (ahead().is("{") && !at().is("struct")) return read_block(std::move(declaration), found);
    if (ahead().is(",") || ahead().is(";")) return skip_statement();  // "invariant gl_Position;" redeclares
    std::string type = at().text;
    if (at().is("struct")) {
      type = read_structure();
    } else {
      ++at_;
    }
    std::vector<std::string> type_sizes;
    read_sizes(type_sizes);
    if (at().kind == TokenKind::identifier && ahead().is("(")) {
      ++at_;
      return read_function(at_ - 1);
    }
    read_variables(found, type, type_sizes, declaration.variables);
    interface_.declarations.push_back(std::move(declaration));
  }

  const Tokens& tokens_;
  Interface& interface_;
  std::size_t at_ = 0;
};

}  // namespace

const Structure* Interface::structure(const std::string& name) const {
  const auto found =
      std::find_if(structures.begin(), structures.end(), [&](const Structure& s) { return s.name == name; });
  return found == structures.end() ? nullptr : &*found;
}

GlslVersion version_of(const Tokens& tokens, bool es_context) {
  GlslVersion version;
  version.es = es_context;
  version.number = es_context ? 100 : 110;
  for (const Token& token : tokens) {
    if (directive_name(token) != "version") continue;
    const Tokens words = tokenize(std::string_view(token.text).substr(1));  // version 300 es
    if (words.size() > 2) version.number = std::atoi(words[1].text.c_str());
    version.compatibility = words.size() > 3 && words[2].is("compatibility");
    version.es = version.number == 100 || (words.size() > 3 && words[2].is("es"));
    break;
  }
  return version;
}

Interface read_interface(const Tokens& tokens, bool es_context) {
  Interface interface;
  interface.version = version_of(tokens, es_context);
  Reader(tokens, interface).read();
  return interface;
}

}  // namespace glark::refine
