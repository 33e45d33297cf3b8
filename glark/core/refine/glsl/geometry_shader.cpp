// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/geometry_shader.h"

#include <algorithm>

#include "glark/core/refine/glsl/tokens.h"
#include "glark/core/refine/glsl/types.h"

namespace glark::refine {
namespace {

using Words = std::set<std::string>;

// "left = right;"
struct Assignment {
  Words left;
  Words right;
};

std::vector<Assignment> assignments_of(const std::vector<std::string>& sources) {
  std::vector<Assignment> result;
  for (const std::string& source : sources) {
    Assignment assignment;
    bool assigned = false;
    for (const Token& token : tokenize(source)) {
      if (token.is(";") || token.is("{") || token.is("}") || token.kind == TokenKind::end) {
        if (assigned) result.push_back(std::move(assignment));
        assignment = Assignment{};
        assigned = false;
      } else if (token.is("=") || token.is("+=") || token.is("*=") || token.is("-=") || token.is("/=")) {
        assigned = true;
      } else if (token.is(")") && !assigned) {
        assignment.left.clear();  // the parenthesis closes a condition
      } else if (token.kind == TokenKind::identifier) {
        (assigned ? assignment.right : assignment.left).insert(token.text);
      }
    }
  }
  return result;
}

bool meets(const Words& a, const Words& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& word) { return b.contains(word); });
}

Words followed_from_positions(const std::vector<Assignment>& assignments) {
  constexpr int longest_chain = 64;  // a shader of a megabyte must not take minutes
  Words words{"gl_Position"};
  std::size_t before = 0;
  for (int round = 0; before != words.size() && round < longest_chain; ++round) {
    before = words.size();
    for (const Assignment& assignment : assignments) {
      if (meets(assignment.left, words)) words.insert(assignment.right.begin(), assignment.right.end());
    }
  }
  return words;
}

}  // namespace

std::set<std::string> words_of_positions(const std::vector<std::string>& sources) {
  return followed_from_positions(assignments_of(sources));
}

bool makes_its_own_positions(const std::vector<std::string>& sources) {
  const std::vector<Assignment> assignments = assignments_of(sources);
  const Words words = followed_from_positions(assignments);
  // A word that is never assigned comes from elsewhere: a vertex, a uniform, a parameter.
  return words.size() > 1 && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
           return numeric_type(std::string_view(word)) != nullptr || word == "true" || word == "false" ||
                  std::any_of(assignments.begin(), assignments.end(),
                              [&](const Assignment& assignment) { return assignment.left.contains(word); });
         });
}

}  // namespace glark::refine
