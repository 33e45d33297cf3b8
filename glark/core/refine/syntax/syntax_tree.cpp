// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/syntax/syntax_tree.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

namespace glark::refine {
namespace {

// One line of the text: "0:12" or "0:? ", two spaces for each level, and the words.
struct Line {
  int number = 0;
  std::size_t depth = 0;
  std::string_view words;
};

std::optional<Line> split_line(std::string_view text) {
  const std::size_t colon = text.find(':');
  const bool placed = colon != 0 && colon != std::string_view::npos &&
                      text.substr(0, colon).find_first_not_of("-0123456789") == std::string_view::npos;
  if (!placed) return std::nullopt;
  Line line;
  const char* const begin = text.data() + colon + 1;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), line.number);
  std::size_t at = colon + 1 + static_cast<std::size_t>(end - begin);
  if (error != std::errc()) at = colon + 3;  // "? "
  const std::size_t words = text.find_first_not_of(' ', at);
  if (words == std::string_view::npos) return std::nullopt;
  line.depth = (words - at) / 2;
  line.words = text.substr(words);
  return line;
}

// Lines that say what the next child is.
struct Marker {
  std::string_view words;
  Role role;
};
constexpr std::array markers = {
    Marker{"Condition", Role::condition},
    Marker{"true case", Role::true_case},
    Marker{"false case", Role::false_case},
    Marker{"Loop Condition", Role::test},
    Marker{"Loop Body", Role::body},
    Marker{"Loop Terminal Expression", Role::terminal},
    Marker{"true case is null", Role::none},
    Marker{"No loop condition", Role::none},
    Marker{"No loop body", Role::none},
    Marker{"condition", Role::none},  // of a switch, which always has both of its children
    Marker{"body", Role::none},
};

struct KindRow {
  std::string_view prefix;
  NodeKind kind;
};
constexpr std::array kinds = {
    KindRow{"Sequence", NodeKind::sequence},
    KindRow{"Scope", NodeKind::sequence},
    KindRow{"Linker Objects", NodeKind::linker_objects},
    KindRow{"Function Definition: ", NodeKind::function},
    KindRow{"Function Parameters:", NodeKind::parameters},
    KindRow{"Function Call: ", NodeKind::call},
    KindRow{"Test condition and select", NodeKind::selection},
    KindRow{"Loop with condition ", NodeKind::loop},
    KindRow{"switch", NodeKind::switch_statement},
    KindRow{"case: ", NodeKind::case_label},
    KindRow{"default: ", NodeKind::case_label},
    KindRow{"Branch: Return", NodeKind::return_statement},
    KindRow{"Branch: Break", NodeKind::break_statement},
    KindRow{"Branch: Continue", NodeKind::continue_statement},
    KindRow{"Constant:", NodeKind::constant},
    KindRow{"'", NodeKind::symbol},
};

constexpr std::string_view member_index = ": direct index for structure";
// glslang has no words for the only built-in function without arguments, ftransform().
constexpr std::string_view nameless_operation = "ERROR: Bad aggregation op";

class TreeReader {
 public:
  TreeReader(const std::set<std::string>& shadowing, std::unordered_map<std::string, Type>& types)
      : shadowing_(shadowing), types_(types) {
    open_.push_back(&root_);
  }

  std::vector<SyntaxNode> read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      std::string joined;
      text.remove_prefix(std::min(end + 1, text.size()));
      if (line.ends_with(nameless_operation)) {  // its type is on the next line
        joined = line;
        joined += text.substr(0, std::min(text.find('\n'), text.size()));
        line = joined;
      }
      if (const std::optional<Line> parts = split_line(line)) add(*parts);
    }
    // A shader with several functions has a sequence around them.
    const bool wrapped = root_.children.size() == 1 && root_.children.front().kind == NodeKind::sequence;
    return wrapped ? std::move(root_.children.front().children) : std::move(root_.children);
  }

 private:
  void add(const Line& line) {
    const auto* const marker =
        std::find_if(markers.begin(), markers.end(), [&](const Marker& row) { return row.words == line.words; });
    if (marker != markers.end()) {
      role_ = marker->role;
      role_depth_ = line.depth;
      return;
    }
    const Role role = line.depth == role_depth_ ? std::exchange(role_, Role::none) : Role::none;
    open_.resize(std::min(open_.size(), line.depth + 1));
    SyntaxNode& parent = *open_.back();
    if (parent.kind == NodeKind::constant) return read_number(line.words, parent);
    const bool global = &parent == &root_ || (line.depth == 1 && parent.kind == NodeKind::sequence);
    if (global) leave_function();
    parent.children.push_back(make_node(line));
    parent.children.back().role = role;
    open_.push_back(&parent.children.back());
  }

  void leave_function() {
    function_.clear();
    parameters_.clear();
  }

  static void read_number(std::string_view words, SyntaxNode& constant) {
    if (constant.count++ == 0) std::from_chars(words.data(), words.data() + words.size(), constant.first_number);
  }

  SyntaxNode make_node(const Line& line) {
    SyntaxNode node;
    node.line = line.number;
    const std::size_t bracket = line.words.find(" (");
    const std::size_t end = line.words.rfind(')');
    const bool typed = bracket != std::string_view::npos && end != std::string_view::npos && bracket < end;
    node.type = type_of(typed ? line.words.substr(bracket + 2, end - bracket - 2) : std::string_view());
    const auto* const row = std::find_if(kinds.begin(), kinds.end(),
                                         [&](const KindRow& each) { return line.words.starts_with(each.prefix); });
    node.kind = row == kinds.end() ? NodeKind::operation : row->kind;
    std::string_view words = line.words.substr(0, typed ? bracket : line.words.size());
    if (row != kinds.end()) words.remove_prefix(std::min(row->prefix.size(), words.size()));
    name_node(words, line, node);
    return node;
  }

  void name_node(std::string_view words, const Line& line, SyntaxNode& node) {
    node.words = words;
    switch (node.kind) {
      case NodeKind::function: function_ = node.words; break;
      case NodeKind::loop: node.tests_first = !words.starts_with("not "); break;
      case NodeKind::symbol: name_symbol(line, node); break;
      case NodeKind::operation:
        if (words.ends_with(member_index)) {
          node.member = words.substr(0, words.size() - member_index.size());
          node.words = member_index.substr(2);
        } else if (words == nameless_operation) {
          node.words = "ftransform";
        }
        break;
      default: break;
    }
  }

  // Functions have variables of their own. The text does not tell variables of one name and type in different blocks
  // apart. That is exact for blocks side by side: a variable has no value before the first write.
  void name_symbol(const Line& line, SyntaxNode& node) {
    node.words = node.words.substr(0, node.words.rfind('\''));
    const std::string key = function_ + '\n' + std::string(line.words);
    const bool declares = open_.back()->kind == NodeKind::parameters;
    if (declares) parameters_.insert(node.words);
    const bool parameter = parameters_.contains(node.words) && node.type->storage != StorageClass::global;
    if (node.type->storage != StorageClass::local && !parameter) return;
    node.local = locals_.try_emplace(key, static_cast<int>(locals_.size())).first->second;
    node.shares_name = shadowing_.contains(node.words);
  }

  const Type* type_of(std::string_view text) {
    const auto [entry, added] = types_.try_emplace(std::string(text));
    if (added) entry->second = read_type(text);
    return &entry->second;
  }

  const std::set<std::string>& shadowing_;
  std::unordered_map<std::string, Type>& types_;
  SyntaxNode root_;
  std::vector<SyntaxNode*> open_;  // from the root to the last node
  Role role_ = Role::none;
  std::size_t role_depth_ = 0;
  std::string function_;
  std::set<std::string> parameters_;  // of the function
  std::map<std::string, int> locals_;
};

}  // namespace

const SyntaxNode* SyntaxNode::part(Role wanted) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const SyntaxNode& child) { return child.role == wanted; });
  return found == children.end() ? nullptr : &*found;
}

SyntaxTree::SyntaxTree(std::string_view text, const std::set<std::string>& shadowing)
    : parts_(TreeReader(shadowing, types_).read(text)) {}

}  // namespace glark::refine
