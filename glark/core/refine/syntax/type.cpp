// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/syntax/type.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glark::refine {
namespace {

template <typename Meaning>
struct Word {
  std::string_view word;
  Meaning meaning;
};
using StorageWord = Word<StorageClass>;
using BasicWord = Word<BasicType>;

constexpr std::array storage_words = {
    StorageWord{"temp", StorageClass::local},          StorageWord{"const", StorageClass::local},
    StorageWord{"global", StorageClass::global},       StorageWord{"in", StorageClass::input},
    StorageWord{"out", StorageClass::output},          StorageWord{"inout", StorageClass::inout},
    StorageWord{"uniform", StorageClass::uniform},     StorageWord{"buffer", StorageClass::buffer},
    StorageWord{"shared", StorageClass::global},       StorageWord{"gl_VertexId", StorageClass::input},
    StorageWord{"gl_InstanceId", StorageClass::input}, StorageWord{"gl_Position", StorageClass::output},
    StorageWord{"gl_PointSize", StorageClass::output}, StorageWord{"gl_ClipVertex", StorageClass::output},
};

constexpr std::array basic_words = {
    BasicWord{"void", BasicType::none},        BasicWord{"float", BasicType::floating},
    BasicWord{"double", BasicType::floating},  BasicWord{"float16_t", BasicType::floating},
    BasicWord{"bool", BasicType::integer},     BasicWord{"int", BasicType::integer},
    BasicWord{"uint", BasicType::integer},     BasicWord{"int8_t", BasicType::integer},
    BasicWord{"uint8_t", BasicType::integer},  BasicWord{"int16_t", BasicType::integer},
    BasicWord{"uint16_t", BasicType::integer}, BasicWord{"int64_t", BasicType::integer},
    BasicWord{"uint64_t", BasicType::integer}, BasicWord{"structure", BasicType::structure},
    BasicWord{"block", BasicType::structure},
};

constexpr std::array ignored_words = {"lowp", "mediump", "highp", "of", "vector", "(read", "only)"};

// Null if `rows` has no such word.
template <typename Rows>
auto meaning_of(std::string_view word, const Rows& rows) -> const decltype(rows.front().meaning)* {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.word == word; });
  return found == rows.end() ? nullptr : &found->meaning;
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

class TypeReader {
 public:
  explicit TypeReader(std::string_view text) : text_(text) {}

  Type read_whole() { return read().type; }

 private:
  // A type, up to the end of its text, or to the comma or brace after a member. The last word is the name of a member.
  TypeMember read() {
    TypeMember result;
    skip_layout();
    bool stored = false;
    bool complete = false;
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
      if (!stored) {
        stored = read_storage(word, result.type);
      } else if (!complete) {
        complete = read_part(word, result.type);
      } else {
        result.name = word;
      }
    }
    return result;
  }

  void skip_layout() {
    skip_spaces();
    if (!text_.substr(at_).starts_with("layout(")) return;
    std::size_t depth = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '(') ++depth;
      if (text_[at_] == ')' && --depth == 0) break;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string_view next_word() {
    skip_spaces();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::string_view(" ,{}").find(text_[at_]) == std::string_view::npos) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  static bool read_storage(std::string_view word, Type& type) {
    const StorageClass* const storage = meaning_of(word, storage_words);
    if (storage) type.storage = *storage;
    return storage != nullptr;
  }

  // Returns true after the last word of the type.
  bool read_part(std::string_view word, Type& type) {
    if (std::find(ignored_words.begin(), ignored_words.end(), word) != ignored_words.end()) return false;
    if (word == "array") {
      type.array = true;
    } else if (word == "matrix") {
      type.matrix = true;
    } else if (word.ends_with("-component")) {
      type.vector_size = static_cast<std::size_t>(word.front() - '0');
    } else if (!is_digit(word.front()) && !word.ends_with("sized") && !word.ends_with("-element")) {
      read_basic(word, type);
      return true;
    }
    return false;
  }

  void read_basic(std::string_view word, Type& type) {
    const BasicType* const basic = meaning_of(word, basic_words);
    type.basic = basic ? *basic : BasicType::opaque;
    if (!type.is_structure() || at_ == text_.size() || text_[at_] != '{') return;
    do {
      ++at_;
      type.members.push_back(read());
    } while (at_ < text_.size() && text_[at_] == ',');
    at_ = std::min(at_ + 1, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<std::size_t> Type::member(std::string_view name) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const TypeMember& each) { return each.name == name; });
  if (found == members.end()) return std::nullopt;
  return static_cast<std::size_t>(found - members.begin());
}

Type read_type(std::string_view text) { return TypeReader(text).read_whole(); }

}  // namespace glark::refine
