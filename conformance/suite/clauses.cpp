// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <map>
#include <stdexcept>

#include "conformance/suite/case.h"

namespace glark::conformance {

const std::string& sentence_of(const std::string& clause) {
  static const std::map<std::string, std::string> sentences = {
#include "conformance/clauses.inc"
  };
  const auto found = sentences.find(clause);
  if (found == sentences.end()) throw std::logic_error("no clause " + clause + " in clauses.txt");
  return found->second;
}

}  // namespace glark::conformance
